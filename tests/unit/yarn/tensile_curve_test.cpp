#include "yarn/tensile_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "base/errors.h"

namespace knitmech::yarn {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;
using testing::ThrowsMessage;

/// D = 0.12 mm, 20 tex, 50 mm between the grips.
TestFacts all_facts() {
  return {.diameter = 0.12, .linear_density = 20e-12, .gauge_length = 50};
}

std::vector<TensileCurve> read(const std::string& text, const TestFacts& facts = all_facts()) {
  return read_tensile_curves(text, "lab.csv", facts);
}

/// The same curve, 0, 1 and 2 % with 0, 0.5 and 0.8 N, in the words and units of many laboratories.
class SameCurve : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(
    Spellings, SameCurve,
    testing::Values("Strain [%],Force [N]\n0,0\n1,0.5\n2,0.8\n",                 //
                    "Force (mN);Strain (-)\r\n0;0\r\n500;0.01\r\n800;0.02\r\n",  //
                    "\xef\xbb\xbf"
                    "Kraft / cN\tDehnung / %\n0\t0\n50\t1\n80\t2",  //
                    "Verl\xe4ngerung in \xb5m;Pr\xfc"
                    "fkraft in kN\n0;0\n500;0,0005\n1000;0,0008\n",                  //
                    "force_gf;displacement_mm\n0;0\n50,985811;0,5\n81,577297;1\n",   //
                    "Allongement (cm);Force (N)\n0;0\n0,05;0,5\n0,1;0,8\n",          //
                    "Tenacity [cN/tex];Elongation [m]\n0;0\n2.5;0.0005\n4;0.001\n",  //
                    "Load,Extension\n(N),(mm)\n0,0\n\"0,5\",\"0,5\"\n\"0,8\",1\n",   //
                    "Zeit;Kraft;Dehnung\ns;N;%\n0;0;0\n1;0,5;1\n2;0,8;2\n",          //
                    "Lab 7\nForce-elongation test; 5 N load cell\n\nTime [s];Force, standard [N];Strain [mm/mm]\n"
                    "0;0;0\n1;0.5;0.01\n2;0.8;0.02\n\n"));

TEST_P(SameCurve, IsReadFromEverySpelling) {
  const auto curves = read(GetParam());
  ASSERT_EQ(curves.size(), 1);
  EXPECT_THAT(curves[0].strains, Pointwise(testing::DoubleNear(1e-9), std::vector<double>{0, 0.01, 0.02}));
  EXPECT_THAT(curves[0].forces, Pointwise(testing::DoubleNear(1e-8), std::vector<double>{0, 0.5, 0.8}));
  EXPECT_EQ(curves[0].name, "lab.csv");
}

TEST(TensileCurve, OfStressIsTakenOverTheSection) {
  // Reference: 1 MPa on pi 0.12^2 / 4 mm^2 is 0.0113097 N.
  for (const std::string unit : {"MPa", "N/mm^2", "N/mm²"}) {
    const auto curves = read("Stress [" + unit + "];Strain [%]\n0;0\n100;1\n");
    EXPECT_NEAR(curves[0].forces[1], 100 * std::numbers::pi * 0.0036, 1e-13);
  }
  EXPECT_NEAR(read("Spannung [GPa];Dehnung [%]\n0;0\n0,1;1\n")[0].forces[1], 100 * std::numbers::pi * 0.0036, 1e-13);
  EXPECT_NEAR(read("Stress [kPa];Strain [%]\n0;0\n1e5;1\n")[0].forces[1], 100 * std::numbers::pi * 0.0036, 1e-13);
}

TEST(TensileCurve, OfForcePerLinearDensityIsTakenTimesIt) {
  // 20 tex; 1 dtex = 0.1 tex, so 1 cN/dtex = 10 cN/tex; 1 gf/den = 9 gf/tex = 8.82599 cN/tex.
  EXPECT_NEAR(read("Tenacity [cN/tex];Strain [%]\n0;0\n30;1\n")[0].forces[1], 6, 1e-12);
  EXPECT_NEAR(read("Tenacity [N/tex];Strain [%]\n0;0\n0.3;1\n")[0].forces[1], 6, 1e-12);
  EXPECT_NEAR(read("Tenacity [cN/dtex];Strain [%]\n0;0\n3;1\n")[0].forces[1], 6, 1e-12);
  EXPECT_NEAR(read("Tenacity [g/den];Strain [%]\n0;0\n1;1\n")[0].forces[1], 20 * 8.82599e-2, 1e-5);
}

TEST(TensileCurve, TakesForceAndStrainBeforeStressAndDisplacement) {
  const auto curves = read("Stress [MPa];Force [N];Displacement [mm];Strain [%]\n0;0;0;0\n9;0.5;9;1\n");
  EXPECT_EQ(curves[0].forces[1], 0.5);
  EXPECT_EQ(curves[0].strains[1], 0.01);
  // Without the linear density the stress is what can be used.
  const auto stress = read("Tenacity [cN/tex];Stress [MPa];Strain [%]\n0;0;0\n9;100;1\n", {.diameter = 0.12});
  EXPECT_NEAR(stress[0].forces[1], 100 * std::numbers::pi * 0.0036, 1e-13);
}

TEST(TensileCurve, OfForcePerWidthIsForFabricsTimesTheirWidth) {
  const std::string text = "stress_N_per_mm;Strain [%]\n0;0\n0.2;1\n";
  const auto curves = read(text, {.width = 50});
  EXPECT_NEAR(curves[0].forces[1], 10, 1e-12);
  EXPECT_TRUE(curves[0].per_width);
  EXPECT_FALSE(read("Force [N];Strain [%]\n0;0\n0.2;1\n", {.width = 50})[0].per_width);
  // A yarn has no width, and a fabric no section.
  EXPECT_THAT([&] { static_cast<void>(read(text)); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("lab.csv: line 1"), HasSubstr("fabrics"))));
  EXPECT_THAT([&] { static_cast<void>(read("Stress [MPa];Strain [%]\n0;0\n1;1\n", {.width = 50})); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("lab.csv: line 1"), HasSubstr("N/mm"))));
}

TEST(TensileCurve, IsReadFromColumnsThatAreChosenByName) {
  const std::string text = "Channel 1;Channel 2 [cN];Force [N];Transverse strain [%]\n0;0;9;9\n0.01;50;9;9\n";
  TestFacts facts = all_facts();
  facts.columns = {.load = "channel 2 [cN]", .extension = "Channel 1 [-]"};
  const auto curves = read(text, facts);
  ASSERT_EQ(curves.size(), 1);
  EXPECT_THAT(curves[0].strains, ElementsAre(0, 0.01));
  EXPECT_THAT(curves[0].forces, ElementsAre(0, 0.5));
  // A line of units below the names says nothing about a column whose unit is chosen.
  const TestFacts with_units_below = {.columns = {.load = "Channel 2", .extension = "Channel 1 [-]"}};
  EXPECT_THAT(read("Channel 1;Channel 2\nV;cN\n0;0\n0.01;50\n", with_units_below)[0].forces, ElementsAre(0, 0.5));
  facts.columns.load = "Channel 3 [N]";
  EXPECT_THAT([&] { static_cast<void>(read(text, facts)); }, ThrowsMessage<InputError>(HasSubstr("\"Channel 3 [N]\"")));
}

TEST(TensileCurve, HasItsSpecimensInAColumn) {
  const auto curves = read("Specimen;Strain [%];Force [N]\nA;0;0\nB;0;0\n;1;0.4\nA;1;0.5\n\n;;\nB;2;0.7\n");
  ASSERT_EQ(curves.size(), 2);
  EXPECT_EQ(curves[0].name, "lab.csv, specimen A");
  EXPECT_EQ(curves[1].specimen, "B");
  EXPECT_THAT(curves[0].forces, ElementsAre(0, 0.5));
  EXPECT_THAT(curves[1].forces, ElementsAre(0, 0.4, 0.7));
}

TEST(TensileCurve, HasItsSpecimensSideBySide) {
  const auto curves = read("Strain [%];Force [N];Strain [%];Force [N]\n0;0;0;0\n1;0.5;1;0.6\n2;0.8;;\n");
  ASSERT_EQ(curves.size(), 2);
  EXPECT_THAT(curves[0].forces, ElementsAre(0, 0.5, 0.8));
  EXPECT_THAT(curves[1].forces, ElementsAre(0, 0.6));
  const auto shared = read("Strain [%];Force 1 [N];Force 2 [N]\n0;0;0\n1;0.5;0.6\n2;0.8;\n");
  ASSERT_EQ(shared.size(), 2);
  EXPECT_THAT(shared[0].strains, ElementsAre(0, 0.01, 0.02));
  EXPECT_THAT(shared[1].strains, ElementsAre(0, 0.01));
}

TEST(TensileCurve, IsReadAsALaboratoryExportsIt) {
  // Reference: the formula in tests/data/yarn/README.md; the file has 0.01 cN and 0.01 %.
  std::ifstream file(KNITMECH_SOURCE_DIR "/tests/data/yarn/five-specimens.csv", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const auto curves = read_tensile_curves(bytes, "five.csv", {});
  ASSERT_EQ(curves.size(), 5);
  const std::vector<double> scales = {0.96, 0.98, 1.00, 1.01, 1.05};
  for (std::size_t k = 0; k < 5; ++k) {
    for (std::size_t i = 0; i + 1 < curves[k].strains.size(); ++i) {
      const double strain = curves[k].strains[i];
      EXPECT_NEAR(strain, 0.005 * static_cast<double>(i), 1e-12);
      EXPECT_NEAR(curves[k].forces[i], scales[k] * (14 * strain + 0.55 * (1 - std::exp(-strain / 0.04))), 1e-4);
    }
  }
  EXPECT_EQ(curves[2].strains.size(), 68);  // 0 to 33 % by 0.5 %, and one after the break
}

TEST(TensileCurve, IsFiniteOrRefusedWhateverTheFile) {
  // Given 20000 files with a few bytes of a good one changed, removed or doubled (the same in every run), each is read
  // into finite curves of at least two points, or refused as wrong input; nothing else may happen.
  const std::string good =
      "Pr\xfc"
      "fung 7\n\nSpecimen;Weg in \xb5m;\"Kraft [cN]\";Strain [%]\nA;0;0,0;0\nA;5;1,5;1\nB;0;0;0\n;10;2,5E1;2\n";
  using namespace std::string_literals;
  const std::string letters = ";,.\t\r\n\"\0[]()%/-+eE09naif\xff\xc3 "s;
  std::mt19937 random(5);
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  int n_read = 0;
  for (int file = 0; file < 20000; ++file) {
    std::string bytes = good;
    for (std::size_t change = 1 + below(3); change > 0 && !bytes.empty(); --change) {
      const std::size_t at = below(bytes.size());
      const std::size_t kind = below(3);
      if (kind == 0) bytes[at] = letters[below(letters.size())];
      if (kind == 1) bytes.erase(at, 1 + below(4));
      if (kind == 2) bytes.insert(at, bytes.substr(below(bytes.size()), 1 + below(8)));
    }
    try {
      for (const TensileCurve& curve : read(bytes)) {
        ASSERT_GE(curve.strains.size(), 2);
        ASSERT_EQ(curve.strains.size(), curve.forces.size());
        for (std::size_t i = 0; i < curve.strains.size(); ++i) {
          ASSERT_TRUE(std::isfinite(curve.strains[i]) && std::isfinite(curve.forces[i]));
        }
      }
      ++n_read;
    } catch (const InputError& error) {
      ASSERT_THAT(error.what(), testing::StartsWith("lab.csv: "));
    }
  }
  EXPECT_GT(n_read, 1000);
  EXPECT_LT(n_read, 19000);
}

struct BrokenFile {
  std::string text;
  std::string complaint;
};
class BrokenCurve : public testing::TestWithParam<BrokenFile> {};
INSTANTIATE_TEST_SUITE_P(
    Files, BrokenCurve,
    testing::Values(
        BrokenFile{"", "is empty"},  //
        BrokenFile{std::string("\x7f"
                               "ELF\0\0",
                               6),
                   "not a text file"},                                     //
        BrokenFile{"1;2\n3;4\n", "no line names the columns of a curve"},  //
        BrokenFile{"Strain [%];Force [N]\n", "line 1: names the columns of a curve, but no numbers follow"},
        BrokenFile{"Strain [%];Force [N]\nabc;def\n", "line 1: names the columns"},
        BrokenFile{"Strain [%];Force [N]\n0;0\n", "has 1 points"},
        BrokenFile{"Strain [%];Force [N]\n0;0\n1;abc\n", "line 3: \"abc\" is no number"},
        BrokenFile{"Strain [%];Force [N]\n0;0\n1;nan\n", "line 3: \"nan\" is no finite number"},
        BrokenFile{"Strain [%];Force [N]\n0;0\n1;inf\n", "line 3"},
        BrokenFile{"Strain [%];Force [kN]\n0;0\n1;1e308\n", "line 3: a number is too large"},
        BrokenFile{"Strain [%];Force [N]\n0;0\n1\n",
                   "line 3: there is a number for the extension, but none for the load"},
        BrokenFile{"Strain [%];Force [N]\n0;0\n;1\n", "line 3: there is a number for the load"},
        BrokenFile{"Strain [%];Force [N];Strain [%];Force [N]\n0;0;0;0\n1;1;1;\n", "line 3: there is a number"},
        BrokenFile{"Strain [%],Force [N]\n0,0\n0,5,0,1\n", "line 3: has 3 cells, but line 1 names 2 columns"},
        BrokenFile{"Strain [%];Force [N]\n0,5;1\n1.5;2\n", "line 3: \"1.5\" has a decimal point"},
        BrokenFile{"Strain [%];Force [N]\n0;1.234,5\n", "line 2: \"1.234,5\" is no number"},
        BrokenFile{"Strain;Force [N]\n0;0\n1;1\n", "line 1: the column \"Strain\" has no unit; write one of %"},
        BrokenFile{"Strain [%];Force [lbf]\n0;0\n1;1\n",
                   "\"Force [lbf]\" has the unit \"lbf\", which is not known here"},
        BrokenFile{"Strain [%];Force [mn]\n0;0\n1;1\n", "\"mn\""},  // mN and MN would be alike
        BrokenFile{"Strain [%];Force [N];Force [cN]\n0;0;0\n1;1;1\n", "different units"},
        BrokenFile{"Strain [%];Strain [%];F [N];F [N];F [N]\n0;0;0;0;0\n", "3 columns of load and 2 of extension"},
        BrokenFile{"Specimen;Strain [%];Force [N]\n;0;0\n", "line 2: the cell of the specimen is empty"},
        BrokenFile{"Specimen;Strain [%];Force [N]\nA;0;0\nA;1;1\nB;0;0\n", "specimen \"B\" has 1 points"}));

TEST_P(BrokenCurve, IsRefusedWithFileAndPlace) {
  EXPECT_THAT([] { (void)read(GetParam().text); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("lab.csv: "), HasSubstr(GetParam().complaint))));
}

TEST(TensileCurve, NamesTheFactThatItsUnitsNeed) {
  const auto complaint = [](const std::string& head, const char* option) {
    EXPECT_THAT([&] { (void)read(head + "\n0;0\n1;1\n", {}); }, ThrowsMessage<InputError>(HasSubstr(option))) << head;
  };
  complaint("Strain [%];Stress [MPa]", "--diameter");
  complaint("Strain [%];Tenacity [cN/tex]", "--linear-density");
  complaint("Displacement [mm];Force [N]", "--gauge-length");
  EXPECT_THROW((void)read("Strain [%];Force [N]\n0;0\n1;1\n", {.diameter = 0.0}), InputError);
}

}  // namespace
}  // namespace knitmech::yarn
