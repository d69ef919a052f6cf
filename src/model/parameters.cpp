#include "model/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "base/text.h"

namespace knitmech::model {
namespace {

template <class T>
constexpr bool kIsChoice = std::is_enum_v<T>;

template <class T>
constexpr bool kIsOptional = std::is_same_v<T, std::optional<double>> || std::is_same_v<T, std::optional<int>>;

std::string complaint_about_number(const Parameter& parameter, double number) {
  if (parameter.range.contains(number)) return {};
  const auto text = [&](double each) { return base::format_quantity(each, parameter.dimension); };
  return fmt::format("must be {} {} and at most {}, but is {}",
                     parameter.range.least_excluded ? "greater than" : "at least", text(parameter.range.least),
                     text(parameter.range.greatest), text(number));
}

std::string complaint_about_list(const Parameter& parameter, const std::vector<double>& numbers) {
  constexpr std::size_t kLongestList = 1000;
  if (numbers.empty()) return "is empty; give at least one number";
  if (numbers.size() > kLongestList) {
    return fmt::format("has {} numbers; give at most {}", numbers.size(), kLongestList);
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string complaint = complaint_about_number(parameter, numbers[i]);
    if (!complaint.empty()) return fmt::format("has a wrong number at place {}: it {}", i + 1, complaint);
  }
  // Forces may stay the same from one strain to the next as far as this table knows.
  const bool is_pure = parameter.dimension == base::Dimension::number;
  if (is_pure && std::ranges::adjacent_find(numbers, std::greater_equal<>()) != numbers.end()) {
    return "must ascend, each number greater than the one before";
  }
  return {};
}

std::string complaint_about_text(const std::string& text) {
  constexpr std::size_t kLongestText = 200;
  const auto is_control = [](char letter) { return static_cast<unsigned char>(letter) < ' '; };
  if (std::ranges::all_of(text, [](char letter) { return letter == ' '; })) return "is empty; write a few words";
  if (text.size() > kLongestText) return fmt::format("is longer than {} letters; shorten it", kLongestText);
  if (std::ranges::any_of(text, is_control))
    return "has a line break or another control character; write one plain line";
  return {};
}

std::string complaint_about_choice(const Parameter& parameter, const std::string& word) {
  if (std::ranges::find(parameter.choices, std::string_view(word)) != parameter.choices.end()) return {};
  const std::string_view nearest = base::nearest_word(word, parameter.choices);
  const std::string guess =
      nearest.empty() || parameter.choices.size() == 1 ? "" : fmt::format("; did you mean \"{}\"?", nearest);
  return fmt::format("is {}, but must be \"{}\"{}", base::in_quotes(word), fmt::join(parameter.choices, "\" or \""),
                     guess);
}

}  // namespace

const Parameter* find_parameter(std::string_view key) {
  const auto found = std::ranges::find(parameters(), key, &Parameter::key);
  return found == parameters().end() ? nullptr : &*found;
}

std::string_view section_name_of(std::string_view key) {
  const auto dot = key.find('.');
  return dot == std::string_view::npos ? std::string_view() : key.substr(0, dot);
}

std::string_view name_of(std::string_view key) {
  const auto dot = key.find('.');
  return dot == std::string_view::npos ? key : key.substr(dot + 1);
}

Kind kind_of(const Parameter& parameter) {
  Case any;
  return std::visit(
      [](auto* member) {
        using Member = std::remove_pointer_t<decltype(member)>;
        if constexpr (kIsChoice<Member>) return Kind::choice;
        if constexpr (std::is_same_v<Member, std::string>) return Kind::text;
        if constexpr (std::is_same_v<Member, int>) return Kind::whole_number;
        if constexpr (std::is_same_v<Member, std::optional<int>>) return Kind::whole_number;
        if constexpr (std::is_same_v<Member, std::vector<double>>) return Kind::list_of_quantities;
        return Kind::quantity;
      },
      parameter.slot(any));
}

Value value_in(const Case& input, const Parameter& parameter) {
  Case copy = input;
  return std::visit(
      [&](auto* member) -> Value {
        using Member = std::remove_pointer_t<decltype(member)>;
        if constexpr (kIsChoice<Member>) {
          return std::string(parameter.choices.at(static_cast<std::size_t>(*member)));
        } else if constexpr (kIsOptional<Member>) {
          return *member ? Value(**member) : Value();
        } else if constexpr (std::is_same_v<Member, std::vector<double>> || std::is_same_v<Member, std::string>) {
          return parameter.need == Need::optional && member->empty() ? Value() : Value(*member);
        } else {
          return *member;
        }
      },
      parameter.slot(copy));
}

bool applies_to(const Parameter& parameter, const Case& input) {
  if (parameter.from == FabricFrom::either) return true;
  return (parameter.from == FabricFrom::file) == (input.fabric.yarn_file != nullptr);
}

const Parameter* first_difference(const Case& a, const Case& b) {
  const auto differs = [&](const Parameter& parameter) { return value_in(a, parameter) != value_in(b, parameter); };
  const auto first = std::ranges::find_if(parameters(), differs);
  return first == parameters().end() ? nullptr : &*first;
}

void set_value(Case& input, const Parameter& parameter, const Value& value) {
  std::visit(
      [&](auto* member) {
        using Member = std::remove_pointer_t<decltype(member)>;
        if constexpr (kIsChoice<Member>) {
          const auto word = std::ranges::find(parameter.choices, std::string_view(std::get<std::string>(value)));
          *member = static_cast<Member>(word - parameter.choices.begin());
        } else if constexpr (kIsOptional<Member>) {
          const auto* number = std::get_if<typename Member::value_type>(&value);
          *member = number != nullptr ? Member(*number) : std::nullopt;
        } else {
          *member = std::get<Member>(value);
        }
      },
      parameter.slot(input));
}

std::string complaint_about(const Parameter& parameter, const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return complaint_about_number(parameter, *number);
  if (const auto* number = std::get_if<int>(&value)) return complaint_about_number(parameter, *number);
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) return complaint_about_list(parameter, *numbers);
  if (const auto* text = std::get_if<std::string>(&value)) {
    return kind_of(parameter) == Kind::choice ? complaint_about_choice(parameter, *text) : complaint_about_text(*text);
  }
  return {};
}

Case default_case() {
  Case input;
  for (const Parameter& parameter : parameters()) {
    if (parameter.need == Need::defaulted) set_value(input, parameter, parameter.value);
  }
  return input;
}

}  // namespace knitmech::model
