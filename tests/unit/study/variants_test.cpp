#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "study/study.h"
#include "study_fixture.h"

namespace knitmech::study {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> names_of(const std::vector<Variant>& variants) {
  std::vector<std::string> names;
  names.reserve(variants.size());
  for (const Variant& variant : variants) names.push_back(variant.name);
  return names;
}

TEST(Variants, GivenAGridWhenLaidOutThenEveryValueMeetsEveryOther) {
  const StudyFolder folder;
  const auto variants = variants_of(folder.study(R"([contact.friction]
values = [0, 0.2]
[loop.height]
values = ["7 mm", "7.5 mm"]
)"));
  EXPECT_THAT(names_of(variants), ElementsAre("friction-0_height-7mm", "friction-0_height-7.5mm",
                                              "friction-0.2_height-7mm", "friction-0.2_height-7.5mm"));
  EXPECT_EQ(variants[3].input.contact.friction, 0.2);
  EXPECT_EQ(variants[3].input.loop.height, 7.5);
  EXPECT_EQ(variants[0].input.contact.friction, 0);
}

TEST(Variants, GivenOneAtATimeWhenLaidOutThenTheBaseComesFirstAndItsOwnValuesNotAgain) {
  const StudyFolder folder;
  const auto variants = variants_of(folder.study(R"(plan = "one-at-a-time"
[contact.friction]
values = [0.1, 0.2]
[loop.height]
values = ["7.5 mm"]
)"));
  EXPECT_THAT(names_of(variants), ElementsAre("base", "friction-0.2", "height-7.5mm"));
  EXPECT_EQ(variants[2].input.contact.friction, 0.1);
}

TEST(Variants, GivenSamplesWhenLaidOutThenTheyLieInTheirRangesAndWholeNumbersAreWhole) {
  const StudyFolder folder;
  for (const char* plan : {"sobol", "latin-hypercube"}) {
    const auto variants = variants_of(folder.study(fmt::format(R"(plan = "{}"
samples = 20
[contact.friction]
from = 0.1
to = 0.3
[fabric.elements_per_erc]
from = 5
to = 8
)",
                                                               plan)));
    ASSERT_EQ(variants.size(), 20U);
    std::set<double> frictions;
    for (const Variant& each : variants) {
      frictions.insert(each.input.contact.friction);
      EXPECT_GE(each.input.contact.friction, 0.1);
      EXPECT_LE(each.input.contact.friction, 0.3);
      EXPECT_GE(each.input.fabric.elements_per_erc, 5);
      EXPECT_LE(each.input.fabric.elements_per_erc, 8);
    }
    EXPECT_EQ(frictions.size(), 20U);
    EXPECT_EQ(variants[6].name, "sample-007");
  }
}

TEST(Variants, GivenAValueThatCannotBeWhenLaidOutThenItAloneHasAComplaint) {
  const StudyFolder folder;
  const auto variants = variants_of(folder.study("[yarn.diameter]\nvalues = [\"0.12 mm\", \"-1 mm\"]"));
  EXPECT_EQ(variants[0].complaint, "");
  EXPECT_THAT(variants[1].complaint, HasSubstr("yarn.diameter must be greater than 0 mm"));
}

TEST(Variants, GivenARuleThatAValueBreaksWhenLaidOutThenTheComplaintNamesTheKey) {
  const StudyFolder folder;
  const auto variants = variants_of(folder.study("[test.strain]\nvalues = [0.005, 0.02]"));
  EXPECT_THAT(variants[0].complaint, HasSubstr("output.frames_at"));
  EXPECT_EQ(variants[1].complaint, "");
}

TEST(Variants, GivenTheSameValueTwiceWhenLaidOutThenTheNamesOfTheFoldersDiffer) {
  const StudyFolder folder;
  const auto variants = variants_of(folder.study("[contact.friction]\nvalues = [0.1, 0.1]"));
  EXPECT_THAT(names_of(variants), ElementsAre("friction-0.1", "friction-0.1_2"));
}

TEST(Variants, GivenNothingToVaryWhenLaidOutThenThereIsTheBaseAlone) {
  const StudyFolder folder;
  EXPECT_THAT(names_of(variants_of(folder.study(""))), ElementsAre("base"));
}

}  // namespace
}  // namespace knitmech::study
