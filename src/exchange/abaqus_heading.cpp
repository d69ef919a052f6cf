#include <fmt/format.h>

#include <ostream>
#include <string>

#include "exchange/abaqus_number.h"
#include "exchange/abaqus_parts.h"

namespace knitmech::exchange::deck {

namespace {

constexpr std::size_t kHeadingWidth = 80;

}  // namespace

void write_heading(std::ostream& out, const model::Model& model) {
  out << "*HEADING\n";
  const std::string title = "KnitMech: " + abaqus_text(model.title);
  for (std::size_t i = 0; i < title.size(); i += kHeadingWidth) line(out, "{}", title.substr(i, kHeadingWidth));
  out << "Units: mm, N, s, t, MPa, mJ\n";
}

void write_node(std::ostream& out, int number, const Eigen::Vector3d& point) {
  line(out, "{}, {}, {}, {}", number, abaqus_number(point.x()), abaqus_number(point.y()), abaqus_number(point.z()));
}

}  // namespace knitmech::exchange::deck
