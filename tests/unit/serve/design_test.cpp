#include "serve/design.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/errors.h"
#include "model/build_model.h"
#include "model/case_file.h"
#include "model/parameters.h"
#include "results/atomic_file.h"
#include "serve/parameters_json.h"

namespace knitmech::serve {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

std::string first_example() {
  return results::read_file(std::string(KNITMECH_SOURCE_DIR) + "/examples/01-first-loop/case.toml");
}

struct ReadBlob {
  Json head;
  std::string data;

  explicit ReadBlob(const std::string& bytes) {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof(length));
    head = Json::parse(bytes.substr(sizeof(length), length));
    data = bytes.substr(sizeof(length) + length);
    EXPECT_EQ((sizeof(length) + length) % 8, 0U);
  }

  [[nodiscard]] std::vector<float> floats(const char* name) const {
    const Json& place = head.at("arrays").at(name);
    std::vector<float> values(place.at("length").get<std::size_t>());
    std::memcpy(values.data(), data.data() + place.at("offset").get<std::size_t>(), 4 * values.size());
    return values;
  }
};

ReadBlob design_of(const std::string& text, std::optional<DesignEdit> edit = {}) {
  return ReadBlob(design_blob({text, std::move(edit), true}));
}

TEST(Design, OfARightCaseHasItsCentrelines) {
  const std::string text = first_example();
  const ReadBlob design = design_of(text);
  const model::Model model = model::build_model(model::parse_case(text, "case"));
  EXPECT_TRUE(design.head.at("mistakes").empty());
  EXPECT_EQ(design.head.at("fabric").at("nodes"), model.n_nodes());
  const auto positions = design.floats("positions");
  ASSERT_EQ(positions.size(), 3 * model.nodes.size());
  EXPECT_FLOAT_EQ(positions[3 * 7 + 1], static_cast<float>(model.nodes[7].y()));
  EXPECT_DOUBLE_EQ(design.head.at("loop").at("points").at("P1").at(1).get<double>(), 3.5);  // H / 2
}

TEST(Design, FollowsAnEdit) {
  const ReadBlob design = design_of(first_example(), DesignEdit{"loop.head_radius", "1.05 mm"});
  EXPECT_THAT(design.head.at("text").get<std::string>(), HasSubstr("head_radius = \"1.05 mm\""));
  EXPECT_EQ(design.head.at("given").at("loop.head_radius").at("typed"), "1.05 mm");
  EXPECT_EQ(design.head.at("effective").at("loop.head_radius"), "1.05 mm");
  EXPECT_EQ(design.head.at("loop").at("head_radius"), 1.05);
}

TEST(Design, TellsAMistakeAtItsKeyInTheWordsOfTheCommandLine) {
  const ReadBlob design = design_of(first_example(), DesignEdit{"loop.height", "7 kg"});
  ASSERT_EQ(design.head.at("mistakes").size(), 1U);
  const Json& mistake = design.head.at("mistakes")[0];
  EXPECT_EQ(mistake.at("key"), "loop.height");
  EXPECT_TRUE(mistake.at("line").is_number());
  EXPECT_TRUE(design.head.at("facts").is_null());
  EXPECT_TRUE(design.head.at("loop").is_null());
  try {
    (void)model::parse_case(design.head.at("text").get<std::string>(), "case");
    FAIL() << "no mistake";
  } catch (const model::CaseFileError& error) {
    EXPECT_EQ(mistake.at("message"), error.complaint());
    EXPECT_THAT(error.what(), HasSubstr(error.complaint()));
  }
}

TEST(Design, DrawsTheLoopWhateverIsWrongElsewhere) {
  const ReadBlob design = design_of(first_example(), DesignEdit{"fabric.wales", "many"});
  EXPECT_EQ(design.head.at("mistakes").at(0).at("key"), "fabric.wales");
  EXPECT_TRUE(design.head.at("loop").is_object());
  EXPECT_TRUE(design.head.at("fabric").is_null());
}

TEST(Design, TellsWhichValueMakesTheGeometryImpossible) {
  // Given courses too far apart to interlock, then the spacing is named as the cause.
  const ReadBlob design = design_of(first_example(), DesignEdit{"fabric.course_spacing", "6.95 mm"});
  EXPECT_EQ(design.head.at("mistakes").at(0).at("key"), "fabric.course_spacing");
  EXPECT_TRUE(design.head.at("fabric").is_null());
}

TEST(Design, TellsAMistakeOfSeveralValuesAtTheOneThatWasEdited) {
  // Given heads as wide as the wales because of flat and radius, then each has the mistake when it is the one changed.
  for (const char* key : {"loop.head_flat", "loop.head_radius"}) {
    const ReadBlob design = design_of(first_example(), DesignEdit{key, "1.9 mm"});
    EXPECT_EQ(design.head.at("mistakes").at(0).at("key"), key);
    EXPECT_THAT(design.head.at("mistakes").at(0).at("message").get<std::string>(), HasSubstr("overlap"));
  }
}

TEST(Design, OfATextThatIsNoTomlNamesTheLine) {
  const ReadBlob design = design_of("title = \n");
  EXPECT_EQ(design.head.at("mistakes").at(0).at("line"), 1);
  EXPECT_THROW((void)design_of("title = \n", DesignEdit{"title", "x"}), InputError);
}

TEST(ParametersOfThePage, AreThoseOfTheTableThatNeedNoFile) {
  const Json document = Json::parse(parameters_json());
  const auto of_file = std::ranges::count(model::parameters(), model::FabricFrom::file, &model::Parameter::from);
  ASSERT_EQ(of_file, 6);
  ASSERT_EQ(document.at("parameters").size(), model::parameters().size() - static_cast<std::size_t>(of_file));
  for (const Json& each : document.at("parameters")) {
    if (each.at("key") != "yarn.density") continue;
    EXPECT_EQ(each.at("unit"), "kg/m^3");
    EXPECT_GT(each.at("greatest").get<double>(), 1000);
  }
}

}  // namespace
}  // namespace knitmech::serve
