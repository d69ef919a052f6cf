#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The syntax of the Abaqus keywords that a deck of yarns needs, as data for abaqus_lint.h. Each keyword as its page in
/// the Abaqus Keywords Guide has it (options, values, data lines; in Abaqus/Explicit where products differ).
namespace knitmech::exchange::syntax {

/// What a name stands for.
enum class Names { node_set, element_set, material, amplitude, surface, interaction };

enum class Entry {
  text,               ///< anything
  whole,              ///< a whole number
  real,               ///< a real number; empty counts as 0
  name,               ///< of what Field::names says
  name_or_empty,      ///< the same, or nothing
  name_or_number,     ///< the same, or the number of a node or an element
  variable,           ///< an output variable
  degree_or_word,     ///< of freedom, 1 to 6, or a word such as ENCASTRE
  degree_or_nothing,  ///< 1 to 6, or nothing
};

struct Field {
  Entry entry = Entry::text;
  Names names = Names::node_set;
};

/// One data line, or several of the same form in a row.
struct Lines {
  std::vector<Field> fields;  ///< most that a line has
  std::size_t fewest = 0;     ///< fields that it has at least
  bool last_repeats = false;  ///< a line may have any number of the last field
  int least = 1, most = 1;    ///< how many such lines
};

/// A form of a keyword's data lines; the first one whose option is there counts.
struct Data {
  std::string option, value;  ///< both empty: in any case; value empty: whatever value
  std::vector<Lines> lines;
};

enum class Role {
  plain,
  defines,  ///< the value is a new name
  adds_to,  ///< the same, and the name may be there already
  refers    ///< the value is a name that was defined before
};

struct Option {
  std::string name;  ///< without blanks, as KeywordBlock has it
  bool required = false;
  std::vector<std::string> values{};  ///< allowed ones, in capitals; empty: any or none
  Role role = Role::plain;
  Names names = Names::node_set;
};

enum class Part { model, history, both };

struct Keyword {
  std::string name;  ///< without blanks
  Part part = Part::model;
  std::vector<std::string> after;      ///< it belongs to the last keyword among these; empty: to none
  std::vector<std::string> is_within;  ///< keywords that may stand between that one and this
  std::vector<Option> options;
  std::vector<Data> data;  ///< empty: no data lines
};

inline constexpr int kAnyNumber = 1 << 30;  ///< of lines

/// The rule of a keyword; none if it is not among those that are known here.
[[nodiscard]] const Keyword* keyword_rule(std::string_view name);

/// Names of all of them.
[[nodiscard]] std::vector<std::string_view> keyword_names();

/// Whether an output variable can be asked for by a keyword (NODEOUTPUT, ...): "Abaqus/Explicit output variable
/// identifiers" in the Abaqus Output Variables guide.
[[nodiscard]] bool is_output_variable(std::string_view keyword, std::string_view variable);

/// Nodes of an element of a type, least and most; a third node of a B31 lays its axes. Zeros: not a type known here.
[[nodiscard]] std::pair<int, int> nodes_of_type(std::string_view type);

}  // namespace knitmech::exchange::syntax
