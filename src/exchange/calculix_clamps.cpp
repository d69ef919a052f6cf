#include "exchange/calculix_clamps.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <ostream>

#include "exchange/abaqus_number.h"

namespace knitmech::exchange::deck {
namespace {

using Eigen::Vector3d;

constexpr const char *kHeldBodies = "HELD_BODIES", *kDrivenBodies = "DRIVEN_BODIES";

template <typename Nodes>
void write_set(std::ostream& out, const std::string& name, const Nodes& nodes) {
  if (nodes.empty()) return;
  line(out, "*NSET, NSET={}", name);
  write_entries(out, std::vector<int>(nodes.begin(), nodes.end()));
}

std::string components(const Vector3d& vector) {
  return fmt::format("{}, {}, {}", abaqus_number(vector.x()), abaqus_number(vector.y()), abaqus_number(vector.z()));
}

/// Data lines of *BOUNDARY for a section that moves with its grip.
std::string conditions(const ClampedSection& section, const Vector3d& displacement) {
  const auto value = [&](const Vector3d& axis) { return abaqus_number(axis.dot(displacement)); };
  const std::string u2 = value(section.across), u3 = value(section.other);
  std::string lines = fmt::format("{}, 1, 1, {}\n", section.name, value(section.along));
  for (const std::size_t on_axis_2 : {0u, 2u}) lines += fmt::format("{}, 3, 3, {}\n", section.nodes[on_axis_2], u3);
  for (const std::size_t on_axis_3 : {1u, 3u}) lines += fmt::format("{}, 2, 2, {}\n", section.nodes[on_axis_3], u2);
  return lines;
}

}  // namespace

ClampedSection clamped_section(int number, const PathPoint& place, const TubeHexahedra& tube,
                               const std::vector<int>& ring, int first_node) {
  const auto corner = [&](std::size_t k) -> const Vector3d& { return tube.nodes[static_cast<std::size_t>(ring[k])]; };
  ClampedSection section;
  section.name = fmt::format("CLAMPED_{}", number);
  section.along = place.tangent;
  section.across = (corner(0) - corner(2)).normalized();
  section.other = section.along.cross(section.across);
  for (const int node : ring) section.nodes.push_back(first_node + node);
  section.grip = place.grip;
  return section;
}

void write_clamps(std::ostream& out, const std::vector<ClampedSection>& sections, const GripNodes& bodies) {
  caption(out, "CLAMPED SECTIONS, axis 1 along the yarn: plane, centre and twist held, free to contract across");
  std::string held;
  for (const ClampedSection& section : sections) {
    write_set(out, section.name, section.nodes);
    line(out, "*TRANSFORM, NSET={}, TYPE=R", section.name);
    line(out, "{}, {}", components(section.along), components(section.across));
    if (section.grip == Grip::held) held += conditions(section, Vector3d::Zero());
  }
  caption(out, "PARTS OF YARNS IN GRIPS: bodies of their own, all held");
  write_set(out, kHeldBodies, bodies.held);
  write_set(out, kDrivenBodies, bodies.driven);
  if (!bodies.held.empty()) held += fmt::format("{}, 1, 3, 0.\n", kHeldBodies);
  out << "*BOUNDARY\n" << held;
}

std::string driven_conditions(const std::vector<ClampedSection>& sections, const GripNodes& bodies,
                              const model::TensileTest& test) {
  const Vector3d displacement(0, test.strain * test.gauge_length, 0);
  std::string lines;
  for (const ClampedSection& section : sections) {
    if (section.grip == Grip::driven) lines += conditions(section, displacement);
  }
  if (bodies.driven.empty()) return lines;
  return lines +
         fmt::format("{0}, 1, 1, 0.\n{0}, 2, 2, {1}\n{0}, 3, 3, 0.\n", kDrivenBodies, abaqus_number(displacement.y()));
}

}  // namespace knitmech::exchange::deck
