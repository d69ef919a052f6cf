#include "study/measures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "results/history_file.h"
#include "study_fixture.h"

namespace knitmech::study {
namespace {

std::optional<double> measure(const std::vector<Measure>& measures, const std::string& name) {
  const auto found = std::ranges::find(measures, name, &Measure::name);
  EXPECT_NE(found, measures.end()) << name;
  return found == measures.end() ? std::nullopt : found->value;
}

/// A run folder in which force = 100 N * strain and work = strain^2, in steps of 0.1 % to 10 % strain.
void write_run(const StudyFolder& folder) {
  std::string history = std::string(results::kHistoryHeader) + "\n";
  for (int i = 0; i <= 100; ++i) {
    model::HistoryRow row;
    row.strain = 0.001 * i;
    row.force_top = 100 * row.strain;
    row.external_work = row.strain * row.strain;
    row.width = 20 - 10 * row.strain;
    history += results::history_line(row);
  }
  folder.write("history.csv", history);
  folder.write("summary.json", R"({"format": "knitmech-run", "status": "completed", "final": {"strain": 0.1},
    "quality": {"quasi_static": true, "kinetic_ratio": 0.02, "toe_strain": null},
    "frames": [{"lowest_z_mm": -0.5, "highest_z_mm": 1}, {"lowest_z_mm": 0, "highest_z_mm": 1.25,
    "contact_force_in_middle_third": 0.4}]})");
}

TEST(Measures, GivenALinearCurveWhenMeasuredThenTheForceIsTheMeanOverTheLastPerCent) {
  const StudyFolder folder;
  write_run(folder);
  const auto measures = measures_of(folder.path(), {0.05, 0.2});
  // Ten rows, from 4.1 % to 5 %.
  EXPECT_NEAR(measure(measures, "force_N_at_5_percent").value(), 100 * 0.0455, 1e-12);
  EXPECT_NEAR(measure(measures, "work_mJ_at_5_percent").value(), 0.0025, 1e-15);
  EXPECT_NEAR(measure(measures, "width_mm_at_5_percent").value(), 19.5, 1e-12);
}

TEST(Measures, GivenAStrainThatTheRunDidNotReachWhenMeasuredThenThereIsNoValue) {
  const StudyFolder folder;
  write_run(folder);
  const auto measures = measures_of(folder.path(), {0.2});
  EXPECT_FALSE(measure(measures, "force_N_at_20_percent").has_value());
}

TEST(Measures, GivenASummaryWhenMeasuredThenItsNumbersAreTakenAndNullIsNoValue) {
  const StudyFolder folder;
  write_run(folder);
  const auto measures = measures_of(folder.path(), {});
  EXPECT_EQ(measure(measures, "quasi_static"), 1.0);
  EXPECT_EQ(measure(measures, "kinetic_ratio"), 0.02);
  EXPECT_EQ(measure(measures, "strain"), 0.1);
  EXPECT_FALSE(measure(measures, "toe_strain").has_value());
  EXPECT_EQ(measure(measures, "out_of_plane_mm"), 1.5);
  EXPECT_EQ(measure(measures, "contact_force_in_middle_third"), 0.4);
}

TEST(Measures, GivenNoRunWhenMeasuredThenTheNamesAreTheSameAndAllIsEmpty) {
  const StudyFolder folder;
  const auto none = measures_of({}, {0.1});
  write_run(folder);
  const auto some = measures_of(folder.path(), {0.1});
  ASSERT_EQ(none.size(), some.size());
  for (std::size_t i = 0; i < none.size(); ++i) {
    EXPECT_EQ(none[i].name, some[i].name);
    EXPECT_FALSE(none[i].value.has_value());
  }
}

}  // namespace
}  // namespace knitmech::study
