#include "results/frame_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "results/base64.h"
#include "results/collection_file.h"
#include "results/contact_file.h"
#include "results/node_values.h"
#include "sample_run.h"
#include "vtk_xml_reader.h"

namespace knitmech::results {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class FrameFile : public testing::Test {
 protected:
  const model::Model model_ = test::two_yarn_model();
  const model::Frame frame_ = test::awkward_frame(model_, 3);
  const test::VtkFile file_ = test::read_vtk_xml(frame_text(model_, frame_));

  /// Bit by bit, so that NaN equals NaN and 0 is not -0.
  void expect_same(const std::string& name, const std::vector<double>& expected) const {
    ASSERT_TRUE(file_.arrays.contains(name)) << name;
    const std::vector<double>& found = file_.arrays.at(name).values;
    ASSERT_EQ(found.size(), expected.size()) << name;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(found[i]), std::bit_cast<std::uint64_t>(expected[i])) << name << " " << i;
    }
  }

  template <typename Vector>
  static std::vector<double> flat(const std::vector<Vector>& vectors) {
    std::vector<double> values;
    for (const Vector& vector : vectors) {
      for (int k = 0; k < vector.size(); ++k) {
        values.push_back(vector[k]);
      }
    }
    return values;
  }
};

TEST_F(FrameFile, IsWellFormedAndCountsItsPointsAndLines) {
  EXPECT_TRUE(file_.well_formed);
  EXPECT_EQ(file_.piece.at("NumberOfPoints"), "7");
  EXPECT_EQ(file_.piece.at("NumberOfLines"), "2");
}

TEST_F(FrameFile, HoldsOnePolylinePerYarn) {
  EXPECT_THAT(file_.arrays.at("Lines/connectivity").values, ElementsAre(0, 1, 2, 3, 4, 5, 6));
  EXPECT_THAT(file_.arrays.at("Lines/offsets").values, ElementsAre(3, 7));
  EXPECT_THAT(file_.arrays.at("CellData/yarn").values, ElementsAre(0, 1));
}

TEST_F(FrameFile, SaysCourseWaleAndSectionOfEveryNode) {
  EXPECT_THAT(file_.arrays.at("PointData/course").values, ElementsAre(0, 0, 0, 1, 1, 1, 1));
  EXPECT_THAT(file_.arrays.at("PointData/wale").values, ElementsAre(0, 0, 1, 0, 0, 1, 1));
  EXPECT_THAT(file_.arrays.at("PointData/section").values, ElementsAre(0, 0, 0, 1, 1, 1, 1));
}

TEST_F(FrameFile, GivesBackEveryNumberOfTheNodesBitByBit) {
  expect_same("Points/points_mm", flat(frame_.points));
  expect_same("PointData/contact_force_N", flat(frame_.contact_force));
  expect_same("PointData/tie_force_N", flat(frame_.tie_force));
  expect_same("PointData/rotation_wxyz", flat(frame_.rotations));
  expect_same("PointData/tube_radius_mm", {0.06, 0.06, 0.06, 0.1, 0.1, 0.1, 0.1});
  EXPECT_EQ(file_.arrays.at("Points/points_mm").components, 3);
  EXPECT_EQ(file_.arrays.at("PointData/rotation_wxyz").components, 4);
  std::vector<double> displacement;
  std::vector<double> magnitude;
  for (std::size_t i = 0; i < frame_.points.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      displacement.push_back(frame_.points[i][k] - model_.nodes[i][k]);
    }
    magnitude.push_back(frame_.contact_force[i].norm());
  }
  expect_same("PointData/displacement_mm", displacement);
  expect_same("PointData/contact_force_magnitude_N", magnitude);
}

TEST_F(FrameFile, GivesBackEveryElementValueInTheFieldDataAndItsMeanAtTheNodes) {
  const std::vector<std::pair<std::string, const std::vector<double>*>> fields{
      {"axial_force_N", &frame_.axial_force},         {"shear_force_N", &frame_.shear_force},
      {"bending_moment_Nmm", &frame_.bending_moment}, {"torque_Nmm", &frame_.torque},
      {"axial_strain", &frame_.axial_strain},         {"curvature_per_mm", &frame_.curvature},
      {"stretch_energy_mJ", &frame_.stretch_energy},  {"bending_energy_mJ", &frame_.bending_energy},
      {"twist_energy_mJ", &frame_.twist_energy}};
  for (const auto& [name, values] : fields) {
    const std::vector<double>& v = *values;
    expect_same("FieldData/element_" + name, {v[0], v[1], v[3], v[4], v[5]});
    expect_same("PointData/" + name, average_to_nodes(model_, v));
  }
}

TEST_F(FrameFile, WritesAGapWithoutNeighbourAsNotANumber) {
  const std::vector<double>& gap = file_.arrays.at("PointData/gap_mm").values;
  ASSERT_EQ(gap.size(), 7U);
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (i == 2) {
      EXPECT_TRUE(std::isnan(gap[i]));
    } else {
      EXPECT_EQ(gap[i], frame_.gap[i]);
    }
  }
}

TEST_F(FrameFile, SaysStrainAndTime) {
  EXPECT_THAT(file_.arrays.at("FieldData/strain").values, ElementsAre(frame_.history.strain));
  EXPECT_THAT(file_.arrays.at("FieldData/time_s").values, ElementsAre(frame_.history.time));
}

TEST_F(FrameFile, RefusesAFrameOfAnotherModel) {
  model::Frame frame = frame_;
  frame.torque.pop_back();
  EXPECT_THROW(static_cast<void>(frame_text(model_, frame)), std::invalid_argument);
}

TEST(FrameCollection, ListsTheFramesWithTheirStrain) {
  const std::string text = collection_text({{0, 0.0}, {1, 0.022}}, frame_file_name);
  EXPECT_TRUE(test::is_well_formed(text));
  EXPECT_THAT(text, HasSubstr(R"(<DataSet timestep="0" group="" part="0" file="frame_0000.vtp"/>)"));
  EXPECT_THAT(text, HasSubstr(R"(<DataSet timestep="0.022" group="" part="0" file="frame_0001.vtp"/>)"));
}

TEST(FrameCollection, ListsTheContactsOfTheFramesWithTheSameStrain) {
  const std::string text = collection_text({{0, 0.0}, {12, 0.22}}, contact_points_file_name);
  EXPECT_TRUE(test::is_well_formed(text));
  EXPECT_THAT(text, HasSubstr(R"(<DataSet timestep="0" group="" part="0" file="contacts_0000.vtp"/>)"));
  EXPECT_THAT(text, HasSubstr(R"(<DataSet timestep="0.22" group="" part="0" file="contacts_0012.vtp"/>)"));
}

TEST(Base64, AgreesWithTheExamplesOfRfc4648) {
  const auto encode = [](std::string_view text) { return to_base64(std::as_bytes(std::span{text})); };
  EXPECT_EQ(encode(""), "");
  EXPECT_EQ(encode("f"), "Zg==");
  EXPECT_EQ(encode("fo"), "Zm8=");
  EXPECT_EQ(encode("foo"), "Zm9v");
  EXPECT_EQ(encode("foob"), "Zm9vYg==");
  EXPECT_EQ(encode("fooba"), "Zm9vYmE=");
  EXPECT_EQ(encode("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace knitmech::results
