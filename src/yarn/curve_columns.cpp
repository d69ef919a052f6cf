#include "yarn/curve_columns.h"

#include <algorithm>
#include <array>
#include <utility>

#include "yarn/table_text.h"

namespace knitmech::yarn {
namespace {

using enum ColumnQuantity;

/// Linear densities are in t/mm: 1 tex = 1 g/km = 1e-12 t/mm, 1 den = 1 g/(9 km). 1 gf = 9.80665 mN.
constexpr std::array kUnits{
    ColumnUnit{{"N"}, force},
    ColumnUnit{{"mN", 1, 1e3}, force},
    ColumnUnit{{"cN", 1, 1e2}, force},
    ColumnUnit{{"kN", 1e3}, force},
    ColumnUnit{{"gf", 980665, 1e8}, force},
    ColumnUnit{{"kgf", 980665, 1e5}, force},
    ColumnUnit{{"cN/tex", 1e10}, specific_force},
    ColumnUnit{{"N/tex", 1e12}, specific_force},
    ColumnUnit{{"mN/tex", 1e9}, specific_force},
    ColumnUnit{{"cN/dtex", 1e11}, specific_force},
    ColumnUnit{{"gf/den", 9.0 * 980665 * 1e4}, specific_force},
    ColumnUnit{{"MPa"}, stress},
    ColumnUnit{{"GPa", 1e3}, stress},
    ColumnUnit{{"kPa", 1, 1e3}, stress},
    ColumnUnit{{"Pa", 1, 1e6}, stress},
    ColumnUnit{{"N/mm^2"}, stress},
    ColumnUnit{{"N/mm"}, force_per_width},
    ColumnUnit{{"mN/mm", 1, 1e3}, force_per_width},
    ColumnUnit{{"N/cm", 1, 10}, force_per_width},
    ColumnUnit{{"cN/cm", 1, 1e3}, force_per_width},
    ColumnUnit{{"N/m", 1, 1e3}, force_per_width},
    ColumnUnit{{"kN/m"}, force_per_width},
    ColumnUnit{{"N/5cm", 1, 50}, force_per_width},
    ColumnUnit{{"gf/cm", 980665, 1e9}, force_per_width},
    ColumnUnit{{"%", 1, 1e2}, strain},
    ColumnUnit{{"-"}, strain},
    ColumnUnit{{"mm/mm"}, strain},
    ColumnUnit{{"m/m"}, strain},
    ColumnUnit{{"mm"}, displacement},
    ColumnUnit{{"um", 1, 1e3}, displacement},
    ColumnUnit{{"cm", 10}, displacement},
    ColumnUnit{{"m", 1e3}, displacement},
};

/// A word that names a column of this role wherever it stands in a head, also within a longer word.
struct RoleWord {
  std::string_view word;
  ColumnRole role;
  bool alone = false;  ///< only as a word of its own
};
constexpr std::array kRoleWords{
    RoleWord{"force", ColumnRole::load},
    RoleWord{"load", ColumnRole::load},
    RoleWord{"stress", ColumnRole::load},
    RoleWord{"tenacit", ColumnRole::load},
    RoleWord{"tension", ColumnRole::load, true},
    RoleWord{"kraft", ColumnRole::load},
    RoleWord{"spannung", ColumnRole::load},
    RoleWord{"contrainte", ColumnRole::load},
    RoleWord{"charge", ColumnRole::load},
    RoleWord{"f", ColumnRole::load, true},
    RoleWord{"strain", ColumnRole::extension},
    RoleWord{"elongation", ColumnRole::extension},
    RoleWord{"extension", ColumnRole::extension},
    RoleWord{"displacement", ColumnRole::extension},
    RoleWord{"dehnung", ColumnRole::extension},
    RoleWord{"weg", ColumnRole::extension},
    RoleWord{"verlangerung", ColumnRole::extension},
    RoleWord{"verlaengerung", ColumnRole::extension},
    RoleWord{"langenanderung", ColumnRole::extension},
    RoleWord{"laengenaenderung", ColumnRole::extension},
    RoleWord{"allongement", ColumnRole::extension},
    RoleWord{"deplacement", ColumnRole::extension},
    RoleWord{"deformation", ColumnRole::extension},
    RoleWord{"specimen", ColumnRole::specimen},
    RoleWord{"sample", ColumnRole::specimen},
    RoleWord{"probe", ColumnRole::specimen},
    RoleWord{"prufling", ColumnRole::specimen},
    RoleWord{"pruefling", ColumnRole::specimen},
    RoleWord{"eprouvette", ColumnRole::specimen},
};

using Replacement = std::pair<std::string_view, std::string_view>;

std::string replaced(std::string text, std::span<const Replacement> replacements) {
  for (const auto& [other, usual] : replacements) {
    for (auto at = text.find(other); at != std::string::npos; at = text.find(other, at + usual.size())) {
      text.replace(at, other.size(), usual);
    }
  }
  return text;
}

/// In small letters and without accents.
std::string plain(std::string_view text) {
  constexpr std::array kLetters{
      Replacement{"ä", "a"}, Replacement{"Ä", "a"}, Replacement{"à", "a"}, Replacement{"ö", "o"},
      Replacement{"Ö", "o"}, Replacement{"ü", "u"}, Replacement{"Ü", "u"}, Replacement{"é", "e"},
      Replacement{"É", "e"}, Replacement{"è", "e"}, Replacement{"ê", "e"},
  };
  std::string result = replaced(std::string(text), kLetters);
  for (char& letter : result) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return result;
}

bool is_letter(char letter) {
  return letter >= 'a' && letter <= 'z';
}

bool has_word(std::string_view head, const RoleWord& role_word) {
  const std::string_view word = role_word.word;
  for (auto at = head.find(word); at != std::string_view::npos; at = head.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool alone = (at == 0 || !is_letter(head[at - 1])) && (end == head.size() || !is_letter(head[end]));
    if (alone || !role_word.alone) return true;
  }
  return false;
}

/// Words of a strain across the pull.
constexpr std::array kAcrossWords{RoleWord{"transvers", ColumnRole::extension},
                                  RoleWord{"lateral", ColumnRole::extension}, RoleWord{"quer", ColumnRole::extension}};

bool is_across(std::string_view head) {
  return std::ranges::any_of(kAcrossWords, [head](const RoleWord& each) { return has_word(head, each); });
}

/// The role that a head names. A head that names both load and extension, as the title of a curve does, has none.
std::optional<ColumnRole> role_of(std::string_view head) {
  const std::string text = plain(head);
  const auto names = [&](ColumnRole role) {
    return std::ranges::any_of(kRoleWords,
                               [&](const RoleWord& each) { return each.role == role && has_word(text, each); });
  };
  const bool load = names(ColumnRole::load);
  const bool extension = names(ColumnRole::extension) && !is_across(text);
  if (load && extension) return std::nullopt;
  if (load) return ColumnRole::load;
  if (extension) return ColumnRole::extension;
  // With a unit it is a property of the specimen, not its name.
  if (names(ColumnRole::specimen) && head.find_first_of("[(") == std::string_view::npos) return ColumnRole::specimen;
  return std::nullopt;
}

std::string_view without_brackets(std::string_view text) {
  const bool bracketed =
      text.size() >= 2 && ((text.front() == '[' && text.back() == ']') || (text.front() == '(' && text.back() == ')'));
  return bracketed ? trimmed(text.substr(1, text.size() - 2)) : text;
}

/// Every text of a head that may be its unit, the likeliest first.
std::vector<std::string> possible_units(std::string_view full_head) {
  constexpr std::array kPer{Replacement{"_per_", "/"}, Replacement{" per ", "/"}};
  const std::string with_slashes = replaced(std::string(full_head), kPer);
  const std::string_view head = with_slashes;
  std::vector<std::string> texts;
  const std::size_t opening = head.find_last_of("[(");
  if (opening != std::string_view::npos) {
    const std::size_t closing = head.find(head[opening] == '[' ? ']' : ')', opening);
    if (closing != std::string_view::npos) texts.emplace_back(trimmed(head.substr(opening + 1, closing - opening - 1)));
  }
  constexpr std::string_view kIn = " in ";
  if (const auto in = head.find(kIn); in != std::string_view::npos) texts.emplace_back(trimmed(head.substr(in + 4)));
  const bool bracketed = !texts.empty();
  if (const auto last = head.find_last_of(" _,"); last != std::string_view::npos) {
    texts.emplace_back(trimmed(head.substr(last + 1)));
  }
  if (const auto slash = head.find('/'); slash != std::string_view::npos && !bracketed) {
    texts.emplace_back(trimmed(head.substr(slash + 1)));
  }
  return texts;
}

/// A unit without the spellings that mean the same.
std::string usual_spelling(std::string_view spelling) {
  constexpr std::array kSpellings{
      Replacement{" ", ""},        Replacement{"\u00b5", "u"},     Replacement{"\u03bc", "u"},
      Replacement{"\u00b2", "^2"}, Replacement{"mm2", "mm^2"},     Replacement{"Tex", "tex"},
      Replacement{"TEX", "tex"},   Replacement{"g/den", "gf/den"},
  };
  return replaced(std::string(without_brackets(trimmed(spelling))), kSpellings);
}

ColumnRole role_of(ColumnQuantity quantity) {
  return quantity == strain || quantity == displacement ? ColumnRole::extension : ColumnRole::load;
}

void find_unit(Column& column) {
  if (column.role == ColumnRole::specimen) return;
  const auto texts = possible_units(column.head);
  for (const std::string& text : texts) {
    column.unit = find_column_unit(text, column.role);
    if (!column.unit) continue;
    column.unit_text = text;
    return;
  }
  const bool in_brackets = column.head.find_first_of("[(/") != std::string::npos;
  if (in_brackets && !texts.empty()) column.unit_text = texts.front();
}

/// "axial_strain [-]" is the column of this head, or else that of the head "axial_strain" with the unit "-".
bool is_chosen(std::string_view head, std::string_view chosen, std::string_view& unit) {
  unit = {};
  if (plain(head) == plain(trimmed(chosen))) return true;
  const std::size_t opening = chosen.find_last_of("[(");
  if (opening == std::string_view::npos) return false;
  unit = without_brackets(trimmed(chosen.substr(opening)));
  return plain(head) == plain(trimmed(chosen.substr(0, opening)));
}

/// The column of a head, without its index; empty if it is none.
std::optional<Column> column_of(std::string_view head, const ColumnChoice& choice) {
  for (const auto& [role, chosen] : {std::pair<ColumnRole, std::string_view>{ColumnRole::load, choice.load},
                                     {ColumnRole::extension, choice.extension}}) {
    std::string_view unit;
    if (chosen.empty() || !is_chosen(head, chosen, unit)) continue;
    Column column{.role = role, .head = std::string(head), .unit_text = std::string(unit)};
    if (unit.empty()) {
      find_unit(column);
    } else {
      column.unit = find_column_unit(unit, role);
      column.unit_is_chosen = true;
    }
    return column;
  }
  const auto role = role_of(head);
  if (!role || (*role == ColumnRole::load && !choice.load.empty()) ||
      (*role == ColumnRole::extension && !choice.extension.empty())) {
    return std::nullopt;
  }
  Column column{.role = *role, .head = std::string(head), .unit_text = {}};
  find_unit(column);
  return column;
}

}  // namespace

std::vector<Column> columns_named_in(std::span<const std::string_view> cells, const ColumnChoice& choice) {
  std::vector<Column> columns;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    constexpr std::size_t kLongestHead = 80;
    if (cells[i].size() > kLongestHead || looks_like_number(cells[i])) continue;
    if (auto column = column_of(cells[i], choice)) {
      column->index = i;
      columns.push_back(*std::move(column));
    }
  }
  return columns;
}

std::optional<ColumnUnit> find_column_unit(std::string_view spelling, ColumnRole role) {
  const std::string wanted = usual_spelling(spelling);
  for (const ColumnUnit& each : kUnits) {
    if (role_of(each.quantity) == role && each.unit.name == wanted) return each;
  }
  return std::nullopt;
}

std::string column_unit_names(ColumnRole role) {
  std::string names;
  for (const ColumnUnit& each : kUnits) {
    if (role_of(each.quantity) != role) continue;
    if (!names.empty()) names += ", ";
    names += each.unit.name;
  }
  return names;
}

}  // namespace knitmech::yarn
