#include "picture/contact_map.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/errors.h"
#include "picture/mm_axes.h"
#include "picture/svg.h"

namespace knitmech::picture {
namespace {

using Eigen::Vector2d;
using model::ContactRecord;

/// Two colours that any eye tells apart (M. Okabe and K. Ito, "Color Universal Design", 2008).
constexpr const char* kStick = R"(fill="#0072b2" fill-opacity="0.75")";
constexpr const char* kSlip = R"(fill="#e69f00" fill-opacity="0.75" stroke="#8a4b00" stroke-width="1")";
constexpr const char* kYarn = R"(fill="none" stroke="#a8a8a8" stroke-width="1" stroke-linejoin="round")";

constexpr double kMapHeight = 700;      // [px], about
constexpr double kMostMapWidth = 1400;  // [px]
constexpr double kTextSize = 14;
constexpr double kLegendRow = 58;  // height on the page [px]

/// Radius of the largest disc over the side of a square that one stitch has on the page [-]; usual 0.13. Larger discs
/// hide one another.
constexpr double kDiscShare = 0.13;

struct Box {
  Vector2d lowest, highest;
};

Box box_of(const std::vector<PlaneLine>& lines) {
  Box box{lines.front().front(), lines.front().front()};
  for (const PlaneLine& line : lines) {
    for (const Vector2d& point : line) {
      box.lowest = box.lowest.cwiseMin(point);
      box.highest = box.highest.cwiseMax(point);
    }
  }
  return box;
}

MmAxes map_axes(const Box& box) {
  MmAxes axes;
  axes.across = nice_ticks(box.lowest.x(), box.highest.x(), 6);
  axes.up = nice_ticks(box.lowest.y(), box.highest.y(), 8);
  const double width = axes.across.last() - axes.across.first();
  const double height = axes.up.last() - axes.up.first();
  axes.px_per_mm_across = axes.px_per_mm_up = std::min(kMapHeight / height, kMostMapWidth / width);
  axes.top = 100;
  return axes;
}

/// Side of a square as large as the part of the fabric that a stitch has on the page [px].
double stitch_size(const model::Model& model, const Box& box, const MmAxes& axes) {
  const int courses = 1 + *std::max_element(model.course.begin(), model.course.end());
  const int wales = 1 + *std::max_element(model.wale.begin(), model.wale.end());
  const Vector2d size = (box.highest - box.lowest) * axes.px_per_mm_up;
  // A single yarn has no area to speak of.
  constexpr double kLeast = 60;  // [px]
  return std::max(kLeast, std::sqrt(size.x() * size.y() / (std::max(1, courses) * std::max(1, wales))));
}

std::string disc(const Vector2d& place, double radius, bool slips) {
  return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {}/>\n", place.x(), place.y(), radius,
                     slips ? kSlip : kStick);
}

bool is_drawn(const ContactRecord& contact) {
  return contact.position.allFinite() && std::isfinite(contact.normal_force) && contact.normal_force > 0;
}

/// Contacts that can be drawn, those with the largest force first, so that small discs lie on large ones.
std::vector<ContactRecord> drawn_contacts(const model::Frame& frame) {
  std::vector<ContactRecord> contacts;
  std::copy_if(frame.contacts.begin(), frame.contacts.end(), std::back_inserter(contacts), is_drawn);
  std::stable_sort(contacts.begin(), contacts.end(),
                   [](const ContactRecord& a, const ContactRecord& b) { return a.normal_force > b.normal_force; });
  return contacts;
}

std::string force_text(double force) {
  constexpr double kLeastInNewton = 0.1;
  return force < kLeastInNewton ? fmt::format("{:.3g} mN", 1000 * force) : fmt::format("{:.3g} N", force);
}

/// Stick and slip with their numbers, and a disc of a round force.
std::string legend(const MmAxes& axes, const std::vector<ContactRecord>& contacts, double radius_of_newton) {
  const double y = kLegendRow;
  if (contacts.empty()) return text_element(axes.left, y + 5, kTextSize, "start", "no contact bears a force");
  const auto n_slip = std::count_if(contacts.begin(), contacts.end(), [](const ContactRecord& c) { return c.slips; });
  const auto n_stick = static_cast<std::ptrdiff_t>(contacts.size()) - n_slip;
  constexpr double kRadius = 7;
  const double reference = round_number_below(contacts.front().normal_force);
  const double radius = radius_of_newton * std::sqrt(reference);
  double x = axes.left + radius;
  std::string text = fmt::format(
      "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"none\" stroke=\"#333333\"/>\n", x, y, radius);
  x += radius + 8;
  text += text_element(x, y + 5, kTextSize, "start", force_text(reference));
  x += 96;
  text +=
      disc({x, y}, kRadius, false) + text_element(x + 13, y + 5, kTextSize, "start", fmt::format("stick: {}", n_stick));
  x += 120;
  text +=
      disc({x, y}, kRadius, true) + text_element(x + 13, y + 5, kTextSize, "start", fmt::format("slip: {}", n_slip));
  return text;
}

}  // namespace

std::string contact_map_svg(const model::Model& model, const model::Frame& frame, const std::string& caption) {
  const std::vector<PlaneLine> lines = centrelines(model, frame, 0, 1);
  if (lines.empty()) {
    throw InputError(
        fmt::format("Frame {} has no yarn whose position is known, so there is nothing to draw.", frame.index));
  }
  const Box box = box_of(lines);
  const MmAxes axes = map_axes(box);
  const std::vector<ContactRecord> contacts = drawn_contacts(frame);
  const double largest_force = contacts.empty() ? 1 : contacts.front().normal_force;
  const double radius_of_newton = kDiscShare * stitch_size(model, box, axes) / std::sqrt(largest_force);
  std::string text = text_element(axes.left, 28, kTextSize + 2, "start", caption, " font-weight=\"bold\"");
  text += legend(axes, contacts, radius_of_newton);
  text += axes_elements(axes, "x [mm]", "y [mm]");
  for (const PlaneLine& line : lines) text += polyline_element(axes, line, kYarn);
  for (const ContactRecord& contact : contacts) {
    text += disc(axes.place_of(contact.position.head<2>()), radius_of_newton * std::sqrt(contact.normal_force),
                 contact.slips);
  }
  // Room for the legend beside a narrow fabric.
  constexpr double kLeastWidth = 460;
  const int width = static_cast<int>(std::ceil(std::max(axes.left + axes.width() + 30, kLeastWidth)));
  return svg_document(width, static_cast<int>(std::ceil(axes.top + axes.height() + 60)), text);
}

}  // namespace knitmech::picture
