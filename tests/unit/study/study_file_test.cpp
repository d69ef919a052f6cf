#include "study/study_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/errors.h"
#include "study_fixture.h"

namespace knitmech::study {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// What is said about a wrong study; empty if it is taken.
std::string complaint_about_study(const std::string& text) {
  const StudyFolder folder;
  try {
    (void)folder.study(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(StudyFile, GivenListsOfValuesWhenReadThenTheyStandInTheOrderOfTheFile) {
  const StudyFolder folder;
  const Study study = folder.study(R"(title = "two things"
strains = [0.01]
[contact.friction]
values = [0, 0.2]
[fabric.structure]
values = ["tied", "basic"]
)");
  EXPECT_EQ(study.title, "two things");
  EXPECT_EQ(study.plan, Plan::grid);
  EXPECT_THAT(study.strains, ElementsAre(0.01));
  ASSERT_EQ(study.variations.size(), 2U);
  EXPECT_EQ(study.variations[0].parameter->key, "contact.friction");
  EXPECT_THAT(study.variations[0].values, ElementsAre(model::Value(0.0), model::Value(0.2)));
  EXPECT_THAT(study.variations[1].values, ElementsAre(model::Value("tied"), model::Value("basic")));
}

TEST(StudyFile, GivenARangeInStepsWhenReadThenItsValuesAreEvenlySpaced) {
  const StudyFolder folder;
  const Study study = folder.study(R"([loop.height]
from = "7 mm"
to = "8 mm"
steps = 3
[yarn.youngs_modulus]
from = "100 MPa"
to = "10 GPa"
steps = 3
spacing = "logarithmic"
)");
  EXPECT_THAT(study.variations[0].values, ElementsAre(model::Value(7.0), model::Value(7.5), model::Value(8.0)));
  const auto modulus = [&](std::size_t i) { return std::get<double>(study.variations[1].values[i]); };
  EXPECT_DOUBLE_EQ(modulus(0), 100);
  EXPECT_EQ(modulus(1), 1000);
  EXPECT_EQ(modulus(2), 10000);
}

TEST(StudyFile, GivenNoStrainsWhenReadThenThoseOfTheFramesOfTheBaseCaseAreTaken) {
  const StudyFolder folder;
  EXPECT_THAT(folder.study("").strains, ElementsAre(0.01, 0.02));
}

TEST(StudyFile, GivenAMistakeWhenReadThenTheMessageNamesFileLineAndKeyAndWhatWouldBeRight) {
  EXPECT_THAT(complaint_about_study("plan = \"everything\""),
              AllOf(HasSubstr("study.toml, line 2"), HasSubstr("plan"), HasSubstr("one-at-a-time")));
  EXPECT_THAT(complaint_about_study("[contact.frction]\nvalues = [0.1]"),
              AllOf(HasSubstr("line 2"), HasSubstr("did you mean contact.friction?")));
  EXPECT_THAT(complaint_about_study("[loop.height]\nvalues = [7]"),
              AllOf(HasSubstr("line 3"), HasSubstr("loop.height"), HasSubstr("has no unit")));
  EXPECT_THAT(complaint_about_study("[loop]\nheight = \"7 mm\""), HasSubstr("write [loop.height]"));
  EXPECT_THAT(complaint_about_study("[loop.height]\nfrom = \"7 mm\""), HasSubstr("has no to"));
  EXPECT_THAT(complaint_about_study("[loop.height]\nfrom = \"8 mm\"\nto = \"7 mm\"\nsteps = 3"),
              HasSubstr("must have from below to"));
  EXPECT_THAT(complaint_about_study("[loop.height]\nfrom = \"7 mm\"\nto = \"8 mm\""), HasSubstr("needs steps"));
  EXPECT_THAT(complaint_about_study("[loop.height]\nvalue = [1]"), HasSubstr("there is no key \"value\" here"));
  EXPECT_THAT(complaint_about_study("[output.frames_at]\nvalues = [0.1]"), HasSubstr("cannot be varied"));
  EXPECT_THAT(complaint_about_study("samples = 10"), HasSubstr("serves only a plan that takes samples"));
  EXPECT_THAT(complaint_about_study("plan = \"sobol\""), HasSubstr("has nothing to sample"));
  EXPECT_THAT(complaint_about_study("plan = \"sobol\"\n[contact.friction]\nvalues = [0, 1]"),
              HasSubstr("write from and to"));
  EXPECT_THAT(complaint_about_study("[measured]\nfiles = [\"nowhere.csv\"]"), HasSubstr("there is no file"));
  EXPECT_THAT(complaint_about_study("[measured]\nwidth = \"50 mm\""), HasSubstr("measured.files"));
  EXPECT_THAT(complaint_about_study("[measured]\nfile = \"x.csv\""), HasSubstr("the keys of [measured] are files"));
  EXPECT_THAT(complaint_about_study("[measured]\nfiles = \"base.toml\"\nwidth = \"0 mm\""),
              HasSubstr("more than 0 mm"));
  EXPECT_THAT(complaint_about_study("[measured]\nfiles = \"base.toml\"\noffset = \"none\""), HasSubstr("\"auto\""));
  EXPECT_THAT(complaint_about_study("strains = [0.2, 0.1]"), HasSubstr("ascending"));
  EXPECT_THAT(complaint_about_study("[measured]\nfiles = \"base.toml\"\nwidth = 5"), HasSubstr("write it in quotes"));
  EXPECT_THAT(complaint_about_study("[loop.\"height.x\"]\nvalues = [1]"), HasSubstr("there is no parameter"));
  EXPECT_THAT(complaint_about_study("[\"loop.height\"]\nvalues = [1]"), HasSubstr("there is no parameter"));
  EXPECT_THAT(complaint_about_study("[loop.height.mm]\nvalues = [1]"), HasSubstr("there is no key \"mm\" here"));
  EXPECT_THAT(complaint_about_study("[strains]\nx = 1"), HasSubstr("is a section, but must be a value"));
  EXPECT_THAT(complaint_about_study("titl = \"x\""), HasSubstr("did you mean title?"));
}

TEST(StudyFile, GivenNoBaseWhenReadThenTheMessageShowsHowToGiveOne) {
  try {
    (void)parse_study("title = \"x\"", "study.toml");
    FAIL() << "was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("base = \"case.toml\""));
  }
}

}  // namespace
}  // namespace knitmech::study
