#include "picture/picture_words.h"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "base/text.h"

namespace knitmech::picture {
namespace {

constexpr std::array<std::pair<std::string_view, ColourBy>, 10> kColours{{{"plain", ColourBy::plain},
                                                                          {"course", ColourBy::course},
                                                                          {"contact", ColourBy::contact_force},
                                                                          {"curvature", ColourBy::curvature},
                                                                          {"axial-force", ColourBy::axial_force},
                                                                          {"axial-strain", ColourBy::axial_strain},
                                                                          {"shear-force", ColourBy::shear_force},
                                                                          {"bending-moment", ColourBy::bending_moment},
                                                                          {"torque", ColourBy::torque},
                                                                          {"out-of-plane", ColourBy::out_of_plane}}};

constexpr std::array<std::pair<std::string_view, View>, 5> kViews{{{"front", View::front},
                                                                   {"back", View::back},
                                                                   {"side", View::side},
                                                                   {"top", View::top},
                                                                   {"oblique", View::oblique}}};

template <typename Words>
std::vector<std::string_view> names_of(const Words& words) {
  std::vector<std::string_view> names;
  names.reserve(words.size());
  for (const auto& [name, value] : words) names.push_back(name);
  return names;
}

template <typename Words>
auto meaning(const Words& words, std::string_view word, const char* kind) {
  for (const auto& [name, value] : words) {
    if (name == word) return value;
  }
  const std::vector<std::string_view> known = names_of(words);
  const std::string_view nearest = base::nearest_word(word, known);
  const std::string advice =
      nearest.empty() ? fmt::format("take {}", base::alternatives(known)) : fmt::format("did you mean {}?", nearest);
  throw InputError(fmt::format("there is no {} {}; {}", kind, base::in_quotes(word), advice));
}

}  // namespace

ColourBy colour_by_word(std::string_view word) {
  return meaning(kColours, word, "colour");
}

View view_by_word(std::string_view word) {
  return meaning(kViews, word, "view");
}

std::vector<std::string_view> colour_words() {
  return names_of(kColours);
}

std::vector<std::string_view> view_words() {
  return names_of(kViews);
}

}  // namespace knitmech::picture
