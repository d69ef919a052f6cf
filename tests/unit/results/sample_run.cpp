#include "sample_run.h"

#include <unistd.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <utility>

namespace knitmech::test {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "knitmech-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::filesystem::filesystem_error("mkdtemp", name, std::make_error_code(std::errc::io_error));
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

model::Model two_yarn_model() {
  model::Model model;
  model.title = "two yarns";
  model.sections = {yarn::Section{.diameter = 0.12}, yarn::Section{.diameter = 0.2}};
  model.yarns = {{.first_node = 0, .n_nodes = 3}, {.first_node = 3, .n_nodes = 4}};
  model.element_section = {0, 0, 0, 1, 1, 1, 1};
  model.course = {0, 0, 0, 1, 1, 1, 1};
  model.wale = {0, 0, 1, 0, 0, 1, 1};
  for (int i = 0; i < 7; ++i) {
    model.nodes.emplace_back(0.1 * i, 1.0 / 3.0 * i, std::sqrt(2.0) * i);
    model.tangents.emplace_back(Eigen::Vector3d::UnitX());
    model.arc_length.push_back(0.1 * i);
  }
  model.test.gauge_length = 10;
  return model;
}

model::Frame awkward_frame(const model::Model& model, int index) {
  model::Frame frame;
  frame.index = index;
  frame.history.strain = 0.022 * index;
  frame.history.time = 1.0 / 7.0 * index;
  int next = 1;
  const auto number = [&next] {
    ++next;
    return std::sqrt(static_cast<double>(next)) * std::pow(10.0, next % 7 - 4);
  };
  const auto vector = [&number] {
    Eigen::Vector3d value;
    for (double& component : value) {
      component = (&component == value.data() ? -1 : 1) * number();
    }
    return value;
  };
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    frame.points.push_back(vector());
    const Eigen::Vector3d imaginary = vector();
    frame.rotations.push_back(Eigen::Vector4d(number(), imaginary[0], imaginary[1], imaginary[2]).normalized());
    frame.contact_force.push_back(vector());
    frame.tie_force.push_back(vector());
    frame.gap.push_back(i == 2 ? std::numeric_limits<double>::infinity() : number());
    for (auto* values :
         {&frame.axial_force, &frame.shear_force, &frame.bending_moment, &frame.torque, &frame.axial_strain,
          &frame.curvature, &frame.stretch_energy, &frame.bending_energy, &frame.twist_energy}) {
      const bool last_of_yarn = i == 2 || i == 6;
      values->push_back(last_of_yarn ? 0.0 : number());
    }
  }
  for (const auto& [first, second] : {std::pair{0, 1}, std::pair{0, 0}, std::pair{1, 1}}) {
    frame.contacts.push_back({.first_yarn = first,
                              .second_yarn = second,
                              .first_place = number(),
                              .second_place = number(),
                              .position = vector(),
                              .normal = vector().normalized(),
                              .gap = -number(),
                              .normal_force = number(),
                              .friction_force = vector(),
                              .elastic_slip = number(),
                              .slip = number(),
                              .slips = first == 0 && second == 0,
                              .angle = number()});
  }
  return frame;
}

}  // namespace knitmech::test
