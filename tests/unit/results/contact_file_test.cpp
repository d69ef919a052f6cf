#include "results/contact_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "sample_run.h"
#include "vtk_xml_reader.h"

namespace knitmech::results {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) {
    cells.push_back(cell);
  }
  return cells;
}

/// A table as another program reads it: the cells under each name of the header, line after line.
std::map<std::string, std::vector<std::string>> columns_of(const std::string& text) {
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> names = cells_of(line);
  std::map<std::string, std::vector<std::string>> columns;
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = cells_of(line);
    EXPECT_EQ(cells.size(), names.size()) << line;
    for (std::size_t i = 0; i < std::min(cells.size(), names.size()); ++i) {
      columns[names[i]].push_back(cells[i]);
    }
  }
  return columns;
}

void expect_same_bits(const std::vector<double>& found, const std::vector<double>& expected, const std::string& name) {
  ASSERT_EQ(found.size(), expected.size()) << name;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(found[i]), std::bit_cast<std::uint64_t>(expected[i])) << name << " " << i;
  }
}

std::vector<double> numbers_of(const std::vector<std::string>& cells) {
  std::vector<double> values;
  values.reserve(cells.size());
  for (const std::string& cell : cells) {
    values.push_back(std::stod(cell));
  }
  return values;
}

class ContactFile : public testing::Test {
 protected:
  const model::Model model_ = test::two_yarn_model();
  const model::Frame frame_ = test::awkward_frame(model_, 3);

  /// What a field or column has to hold: a number of every contact.
  template <typename ValueOf>
  [[nodiscard]] std::vector<double> expected(ValueOf value_of) const {
    std::vector<double> values;
    for (const model::ContactRecord& contact : frame_.contacts) {
      values.push_back(value_of(contact));
    }
    return values;
  }

  /// Every column that is a number of the record as it is, by its name in table and ParaView file.
  [[nodiscard]] std::map<std::string, std::vector<double>> plain_columns() const {
    using Record = const model::ContactRecord&;
    return {{"first_yarn", expected([](Record c) { return c.first_yarn; })},
            {"first_place_mm", expected([](Record c) { return c.first_place; })},
            {"second_yarn", expected([](Record c) { return c.second_yarn; })},
            {"second_place_mm", expected([](Record c) { return c.second_place; })},
            {"gap_mm", expected([](Record c) { return c.gap; })},
            {"normal_force_N", expected([](Record c) { return c.normal_force; })},
            {"friction_force_magnitude_N", expected([](Record c) { return c.friction_force.norm(); })},
            {"slip_mm", expected([](Record c) { return c.slip; })},
            {"elastic_slip_mm", expected([](Record c) { return c.elastic_slip; })}};
  }
};

TEST_F(ContactFile, ATableLineSaysWhereTwoYarnsTouchAndHow) {
  // Given one contact of the yarns of course 4 and course 5 at a right angle, and one of yarn 0 with itself that slips.
  model::Model model = test::two_yarn_model();
  std::fill(model.course.begin(), model.course.begin() + 3, 4);
  std::fill(model.course.begin() + 3, model.course.end(), 5);
  model::Frame frame;
  frame.contacts = {{.first_yarn = 0,
                     .second_yarn = 1,
                     .first_place = 2.5,
                     .second_place = 3.25,
                     .position = {1, 2, 3},
                     .normal = {0, 0, 1},
                     .gap = -0.001,
                     .normal_force = 0.5,
                     .friction_force = {0.03, 0.04, 0},
                     .elastic_slip = 0.0002,
                     .slip = 0.125,
                     .slips = false,
                     .angle = std::numbers::pi / 2},
                    {.normal = {-1, 0, 0}, .slips = true}};
  // Then each is a line, by the names of the header.
  EXPECT_EQ(contact_table_text(model, frame),
            "first_yarn,first_course,first_place_mm,second_yarn,second_course,second_place_mm,x_mm,y_mm,z_mm,normal_x,"
            "normal_y,normal_z,gap_mm,normal_force_N,friction_force_x_N,friction_force_y_N,friction_force_z_N,"
            "friction_force_magnitude_N,slip_mm,elastic_slip_mm,state,crossing_angle_deg\n"
            "0,4,2.5,1,5,3.25,1,2,3,0,0,1,-0.001,0.5,0.03,0.04,0,0.05,0.125,0.0002,stick,90\n"
            "0,4,0,0,4,0,0,0,0,-1,0,0,0,0,0,0,0,0,0,0,slip,0\n");
}

TEST_F(ContactFile, TheTableReadsBackToTheSameBits) {
  auto columns = columns_of(contact_table_text(model_, frame_));
  for (const auto& [name, values] : plain_columns()) {
    expect_same_bits(numbers_of(columns[name]), values, name);
  }
  const std::vector<std::pair<std::string, Eigen::Vector3d model::ContactRecord::*>> vectors{
      {"{}_mm", &model::ContactRecord::position},
      {"normal_{}", &model::ContactRecord::normal},
      {"friction_force_{}_N", &model::ContactRecord::friction_force}};
  for (const auto& [pattern, member] : vectors) {
    const auto vector = std::mem_fn(member);
    for (int k = 0; k < 3; ++k) {
      const std::string name = std::string{pattern}.replace(pattern.find("{}"), 2, 1, "xyz"[k]);
      const auto component = [&vector, k](const model::ContactRecord& contact) { return vector(contact)[k]; };
      expect_same_bits(numbers_of(columns[name]), expected(component), name);
    }
  }
  EXPECT_THAT(columns["first_course"], ElementsAre("0", "0", "1"));
  EXPECT_THAT(columns["second_course"], ElementsAre("1", "0", "1"));
  EXPECT_THAT(columns["state"], ElementsAre("stick", "slip", "stick"));
}

TEST_F(ContactFile, ParaViewSeesAPointWithTheSameFieldsAtEachContact) {
  // Given the file of a frame with three contacts.
  const test::VtkFile file = test::read_vtk_xml(contact_points_text(model_, frame_));
  // Then it has three points, each a cell of its own, at the positions of the contacts,
  EXPECT_TRUE(file.well_formed);
  EXPECT_EQ(file.piece.at("NumberOfPoints"), "3");
  EXPECT_EQ(file.piece.at("NumberOfVerts"), "3");
  EXPECT_EQ(file.piece.at("NumberOfLines"), "0");
  EXPECT_THAT(file.arrays.at("Verts/connectivity").values, ElementsAre(0, 1, 2));
  EXPECT_THAT(file.arrays.at("Verts/offsets").values, ElementsAre(1, 2, 3));
  const std::vector<std::pair<std::string, Eigen::Vector3d model::ContactRecord::*>> vectors{
      {"Points/points_mm", &model::ContactRecord::position},
      {"PointData/normal", &model::ContactRecord::normal},
      {"PointData/friction_force_N", &model::ContactRecord::friction_force}};
  for (const auto& [name, member] : vectors) {
    std::vector<double> values;
    for (const model::ContactRecord& contact : frame_.contacts) {
      const Eigen::Vector3d& vector = contact.*member;
      values.insert(values.end(), vector.begin(), vector.end());
    }
    EXPECT_EQ(file.arrays.at(name).components, 3);
    expect_same_bits(file.arrays.at(name).values, values, name);
  }
  // and its fields are the columns of the table.
  for (const auto& [name, values] : plain_columns()) {
    expect_same_bits(file.arrays.at("PointData/" + name).values, values, name);
  }
  EXPECT_THAT(file.arrays.at("PointData/first_course").values, ElementsAre(0, 0, 1));
  EXPECT_THAT(file.arrays.at("PointData/second_course").values, ElementsAre(1, 0, 1));
  EXPECT_THAT(file.arrays.at("PointData/slips").values, ElementsAre(0, 1, 0));
  EXPECT_THAT(file.arrays.at("FieldData/strain").values, ElementsAre(frame_.history.strain));
  EXPECT_THAT(file.arrays.at("FieldData/time_s").values, ElementsAre(frame_.history.time));
}

TEST_F(ContactFile, TheCrossingAngleIsInDegrees) {
  // Given contacts side by side, at 60 degrees and at a right angle.
  model::Frame frame;
  frame.contacts = {{.angle = 0}, {.angle = std::numbers::pi / 3}, {.angle = std::numbers::pi / 2}};
  // Then both files say so.
  const std::vector<double> table = numbers_of(columns_of(contact_table_text(model_, frame)).at("crossing_angle_deg"));
  const test::VtkFile points = test::read_vtk_xml(contact_points_text(model_, frame));
  EXPECT_THAT(table, ElementsAre(0, testing::DoubleEq(60), 90));
  expect_same_bits(points.arrays.at("PointData/crossing_angle_deg").values, table, "crossing_angle_deg");
}

TEST_F(ContactFile, AFrameWithoutContactsKeepsItsColumnsAndFields) {
  // Given the frames before and after the first contact: ParaView shows a field only if every instant has it.
  model::Frame without = frame_;
  without.contacts.clear();
  const test::VtkFile before = test::read_vtk_xml(contact_points_text(model_, without));
  const test::VtkFile after = test::read_vtk_xml(contact_points_text(model_, frame_));
  // Then the fields are the same, with nothing in them, and the table is its header.
  EXPECT_TRUE(before.well_formed);
  EXPECT_EQ(before.piece.at("NumberOfPoints"), "0");
  for (const auto& [name, array] : after.arrays) {
    if (name.starts_with("PointData/")) {
      ASSERT_TRUE(before.arrays.contains(name)) << name;
      EXPECT_THAT(before.arrays.at(name).values, IsEmpty()) << name;
      EXPECT_EQ(before.arrays.at(name).type, array.type) << name;
      EXPECT_EQ(before.arrays.at(name).components, array.components) << name;
    }
  }
  EXPECT_EQ(contact_table_text(model_, without), std::string{kContactHeader} + "\n");
}

TEST_F(ContactFile, RefusesAContactOfAYarnThatTheModelDoesNotHave) {
  for (const int yarn : {-1, 2}) {
    model::Frame frame = frame_;
    frame.contacts.back().second_yarn = yarn;
    EXPECT_THROW(static_cast<void>(contact_table_text(model_, frame)), std::invalid_argument) << yarn;
    EXPECT_THROW(static_cast<void>(contact_points_text(model_, frame)), std::invalid_argument) << yarn;
  }
}

}  // namespace
}  // namespace knitmech::results
