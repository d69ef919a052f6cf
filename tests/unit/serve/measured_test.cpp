#include "serve/measured.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "serve/refusal.h"

namespace knitmech::serve {
namespace {

using Json = nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

Json measured(const std::string& text) {
  return Json::parse(measured_json("curves.csv", text, "100 mm", "5 cm"));
}

TEST(Measured, GivenForcesAndForcesPerWidthInSeveralUnits_ThenTheSameCurvesComeBack) {
  // Given 0.2 N/mm at 10 % strain of a specimen 50 mm wide and 100 mm long.
  for (const char* text : {"Strain [%],Force [N]\n0,0\n5,4\n10,10\n", "Weg in mm;Kraft in N\n0;0\n5;4\n10;10\n",
                           "Displacement [mm];Stress [N/mm]\n0;0\n5;0.08\n10;0.2\n",
                           "Force per width [N/m];Strain [%]\n0;0\n80;5\n200;10\n"}) {
    const Json curve = measured(text).at("specimens").at(0);
    ASSERT_EQ(curve.at("strain").size(), 3U) << text;
    EXPECT_NEAR(curve.at("strain")[1].get<double>(), 0.05, 1e-12) << text;
    EXPECT_NEAR(curve.at("force_per_width")[1].get<double>(), 0.08, 1e-12) << text;
    EXPECT_NEAR(curve.at("force_per_width")[2].get<double>(), 0.2, 1e-12) << text;
    EXPECT_THAT(curve.at("name").get<std::string>(), HasSubstr("curves.csv"));
  }
}

TEST(Measured, GivenTwoSpecimens_ThenTheMeanLiesBetweenTheLowestAndTheHighest) {
  const Json both = measured("Strain [%],Force [N],Strain [%],Force [N]\n0,0,0,0\n10,10,10,20\n");
  ASSERT_EQ(both.at("specimens").size(), 2U);
  const Json& mean = both.at("mean");
  ASSERT_EQ(mean.at("strain").size(), mean.at("mean").size());
  EXPECT_NEAR(mean.at("lowest").back().get<double>(), 0.2, 1e-12);
  EXPECT_NEAR(mean.at("mean").back().get<double>(), 0.3, 1e-12);
  EXPECT_NEAR(mean.at("highest").back().get<double>(), 0.4, 1e-12);
}

TEST(Measured, GivenALongCurve_ThenItIsThinnedAndKeepsBothEnds) {
  std::string text = "Strain [%],Force [N]\n";
  for (int i = 0; i <= 30000; ++i) text += fmt::format("{},{}\n", 1e-3 * i, 1e-3 * i);
  const Json curve = measured(text).at("specimens").at(0);
  ASSERT_EQ(curve.at("strain").size(), 2000U);
  ASSERT_EQ(curve.at("force_per_width").size(), 2000U);
  EXPECT_EQ(curve.at("strain").front(), 0);
  EXPECT_NEAR(curve.at("strain").back().get<double>(), 0.3, 1e-12);
  for (std::size_t i = 0; i < 2000; ++i) {
    EXPECT_NEAR(curve.at("force_per_width")[i].get<double>(), 2 * curve.at("strain")[i].get<double>(), 1e-12);
  }
}

TEST(Measured, GivenWhatIsNoTableOfCurves_ThenTheMessageSaysWhere) {
  EXPECT_THAT([] { measured("nothing of use"); }, ThrowsMessage<InputError>(HasSubstr("curves.csv")));
  EXPECT_THAT([] { static_cast<void>(measured_json("a", "x", "100", "50 mm")); },
              ThrowsMessage<InputError>(HasSubstr("gauge length")));
  EXPECT_THAT([] { static_cast<void>(measured_json("a", "x", "100 mm", "0 mm")); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("width"), HasSubstr("larger than 0"))));
  try {
    static_cast<void>(
        measured_json("a", std::string(20'000'001, ' ') /* NOLINT(bugprone-string-constructor) */, "100 mm", "50 mm"));
    FAIL() << "took too much";
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.status(), 413);
  }
}

}  // namespace
}  // namespace knitmech::serve
