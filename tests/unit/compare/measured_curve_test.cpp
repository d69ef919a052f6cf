#include "compare/measured_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/errors.h"

namespace knitmech::compare {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Files of curves for one test.
class MeasuredCurves : public testing::Test {
 protected:
  MeasuredCurves() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~MeasuredCurves() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }

 private:
  const fs::path folder_ = fs::temp_directory_path() / (std::string("knitmech-measured-") +
                                                        testing::UnitTest::GetInstance()->current_test_info()->name());
};

/// 50 mm wide, 100 mm between the grips.
SpecimenFacts facts() {
  return {.gauge_length = 100, .width = 50};
}

TEST_F(MeasuredCurves, GivenForcesOrForcesPerWidthInAnyUnit_ThenTheSameMeanPerWidthIsRead) {
  // Given 0.2 N/mm at 10 % strain of a specimen 50 mm wide, in the words and units of several laboratories.
  int i = 0;
  for (const char* text :
       {"Strain [%],Force [N]\n0,0\n10,10\n", "Weg in mm;Kraft in N\n0;0\n10;10\n",
        "force_N,displacement_cm\n0,0\n10,1\n", "Load (kgf);Extension (mm)\n0;0\n1,019716;10\n",
        "Stress [N/mm];Strain [-]\n0;0\n0.2;0.1\n", "axial_strain_%,stress_N_per_mm\n0,0\n10,0.2\n",
        "Force per width [N/m];Strain [%]\n0;0\n200;10\n", "Force per width (N/cm);Strain (%)\n0;0\n2;10\n",
        "Kraft/Breite in N/5cm;Dehnung in %\n0;0\n10;10\n",
        "Tensile force [gf/cm]\tStrain [%]\n0\t0\n203.9432\t10\n"}) {
    const MeasuredCurve curve = read_measured_curve({file(std::to_string(++i) + ".csv", text)}, facts());
    EXPECT_NEAR(curve.mean.strains.back(), 0.1, 1e-12) << text;
    EXPECT_NEAR(curve.mean.forces.back(), 0.2, 1e-6) << text;
    EXPECT_EQ(curve.per_width, i >= 5) << text;
  }
}

TEST_F(MeasuredCurves, GivenSeveralFilesOfSeveralSpecimens_ThenTheirMeanAndRangeAreWhereAllOfThemAre) {
  const std::string two = file("two.csv", "Sample,Strain [%],Force [N]\nA,0,0\nA,20,20\nB,0,0\nB,10,20\nB,11,0\n");
  const std::string one = file("one.csv", "Strain [%],Force [N]\n0,0\n30,60\n");
  const MeasuredCurve curve = read_measured_curve({two, one}, facts());
  ASSERT_EQ(curve.specimens.size(), 3U);
  EXPECT_EQ(curve.mean.n_curves, 3);
  EXPECT_NEAR(curve.mean.strains.back(), 0.1, 1e-12);  // B breaks
  EXPECT_NEAR(curve.mean.forces.back(), (10 + 20 + 20) / 3.0 / 50, 1e-12);
  EXPECT_NEAR(curve.mean.least.back(), 10 / 50.0, 1e-12);
  EXPECT_NEAR(curve.mean.greatest.back(), 20 / 50.0, 1e-12);
}

TEST_F(MeasuredCurves, GivenNamesOfSpecimens_ThenOnlyTheyAreRead) {
  const std::string path = file("two.csv", "Sample,Strain [%],Force [N]\nA,0,0\nA,20,20\nB,0,0\nB,10,20\n");
  SpecimenFacts wanted = facts();
  wanted.samples = {"B"};
  const MeasuredCurve curve = read_measured_curve({path}, wanted);
  ASSERT_EQ(curve.specimens.size(), 1U);
  EXPECT_EQ(curve.specimens[0].specimen, "B");
  wanted.samples = {"B", "C"};
  EXPECT_THAT([&] { static_cast<void>(read_measured_curve({path}, wanted)); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("\"C\""), HasSubstr("A or B"))));
}

TEST_F(MeasuredCurves, GivenColumnsThatNoWordTells_ThenTheyAreTakenByNameAndUnit) {
  const std::string path = file("raw.csv", "ch1,ch2 (N),transverse strain [%],strain\n0,0,0,0\n0.1,10,7,0.2\n");
  SpecimenFacts chosen = facts();
  chosen.columns = {.load = "CH2 (N)", .extension = "ch1 [-]"};
  EXPECT_NEAR(read_measured_curve({path}, chosen).mean.strains.back(), 0.1, 1e-12);
  chosen.columns.extension = "strain [-]";  // the transverse strain is no strain along the pull
  EXPECT_NEAR(read_measured_curve({path}, chosen).mean.strains.back(), 0.2, 1e-12);
  // Without a unit nothing is guessed.
  chosen.columns.extension = "strain";
  EXPECT_THAT([&] { static_cast<void>(read_measured_curve({path}, chosen)); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("raw.csv"), HasSubstr("line 1"), HasSubstr("no unit"))));
  chosen.columns.extension = "ch3 [-]";
  EXPECT_THAT([&] { static_cast<void>(read_measured_curve({path}, chosen)); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("raw.csv"), HasSubstr("\"ch3 [-]\""))));
}

TEST_F(MeasuredCurves, GivenAStressOverASection_ThenItSaysWhatAFabricHas) {
  const std::string path = file("mpa.csv", "Stress [MPa],Strain [%]\n0,0\n1,1\n");
  EXPECT_THAT([&] { static_cast<void>(read_measured_curve({path}, facts())); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("mpa.csv"), HasSubstr("N/mm"))));
  EXPECT_THAT([] { static_cast<void>(read_measured_curve({"/no/such.csv"}, facts())); },
              ThrowsMessage<FileError>(HasSubstr("/no/such.csv")));
}

TEST(MeasuredFabric, GivenMeasuredStockinette_ThenTheCurveOfOneSampleIsRead) {
  // Acrylic stockinette of Singal et al., Nature Communications 15, 2622 (2024), which is not part of this project.
  // No thread changes the environment.
  const char* const folder = std::getenv("KNITMECH_MEASURED_CURVES");  // NOLINT(concurrency-mt-unsafe)
  const fs::path path = fs::path(folder != nullptr ? folder : KNITMECH_SOURCE_DIR "/../shared/data/knit-tensile") /
                        "acrylic-stockinette.csv";
  if (!fs::exists(path)) GTEST_SKIP() << "There is no " << path << "; set KNITMECH_MEASURED_CURVES to its folder.";
  SpecimenFacts of_file{.gauge_length = 100, .width = 80};
  of_file.columns.extension = "axial_strain [-]";
  of_file.samples = {"Acrylic Yarn Stockinette X"};
  const MeasuredCurve curve = read_measured_curve({path.string()}, of_file);
  ASSERT_EQ(curve.specimens.size(), 1U);
  EXPECT_TRUE(curve.per_width);
  EXPECT_NEAR(yarn::force_at(curve.specimens[0].strains, curve.specimens[0].forces, 0.2), 80 * 0.048295, 1e-9);
  of_file.samples.clear();
  EXPECT_EQ(read_measured_curve({path.string()}, of_file).specimens.size(), 2U);
}

}  // namespace
}  // namespace knitmech::compare
