#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/quantity.h"
#include "model/case.h"

namespace knitmech::model {

/// The value of a parameter, in internal units; a choice is its word. std::monostate: "auto", or not given. An empty
/// list stands for one that is not given.
using Value = std::variant<std::monostate, double, int, std::string, std::vector<double>>;

/// The member of a Case that a parameter fills.
using Slot = std::variant<std::string*, double*, std::optional<double>*, int*, std::optional<int>*,
                          std::vector<double>*, knit::Structure*, FileAxes*, Centreline*, TestKind*, Grips*, OnBreak*>;

/// What is written in a case file for a parameter.
enum class Kind { text, quantity, whole_number, list_of_quantities, choice };

/// Whether a parameter must be given, and what holds if it is not.
enum class Need {
  required,   ///< it must be given
  defaulted,  ///< Parameter::value holds
  automatic,  ///< the program chooses a value, the same as "auto"
  optional,   ///< nothing: another parameter stands in its place
};

/// What the fabric comes from. A parameter of one of the two ways cannot be given in a case of the other.
enum class FabricFrom { either, loops, file };

/// Allowed values of a number, in internal units.
struct Range {
  double least = 0;
  double greatest = 0;
  bool least_excluded = false;

  [[nodiscard]] bool contains(double value) const {
    return (least_excluded ? value > least : value >= least) && value <= greatest;
  }
};

/// One input parameter: everything that the reader, its messages, the template of a case file and the input reference
/// say about it.
struct Parameter {
  std::string key = {};          ///< "loop.height": section of the case file, then name
  std::string_view symbol = {};  ///< "H" in formulas; empty if there is none
  base::Dimension dimension = base::Dimension::number;
  Need need = Need::required;
  FabricFrom from = FabricFrom::either;
  Value value = {};  ///< defaulted: the default; otherwise an example that goes well with the other examples
  Range range = {};  ///< of a number, or of each number of a list
  std::vector<std::string_view> choices = {};  ///< of a choice, in the order of the enumeration
  std::string_view help = {};                  ///< one line, no full stop
  Slot (*slot)(Case&) = nullptr;
};

/// A section of the case file.
struct CaseSection {
  std::string_view name;  ///< empty: the top of the file
  std::string_view help;  ///< one line
};

/// The parameters of [yarn] and [edge_yarn]; part of parameters().
[[nodiscard]] std::vector<Parameter> parameters_of_yarns();

/// The parameters of [fabric] for a fabric from a file of yarns; part of parameters().
[[nodiscard]] std::vector<Parameter> parameters_of_file();

/// Whether a parameter has a meaning in a case.
[[nodiscard]] bool applies_to(const Parameter& parameter, const Case& input);

/// The table of all parameters, section by section in the order of the case file. There is no other list of them.
[[nodiscard]] const std::vector<Parameter>& parameters();

/// The sections of the case file, in its order.
[[nodiscard]] const std::vector<CaseSection>& sections();

/// The parameter of a key, or nullptr.
[[nodiscard]] const Parameter* find_parameter(std::string_view key);

/// "loop" of "loop.height"; empty for a key at the top of the file.
[[nodiscard]] std::string_view section_name_of(std::string_view key);

/// "height" of "loop.height".
[[nodiscard]] std::string_view name_of(std::string_view key);

[[nodiscard]] Kind kind_of(const Parameter& parameter);

/// The value that a case holds for a parameter.
[[nodiscard]] Value value_in(const Case& input, const Parameter& parameter);

/// The first parameter, in the order of the table, in which two cases differ; nullptr if there is none.
[[nodiscard]] const Parameter* first_difference(const Case& a, const Case& b);

/// Puts a value into a case. @pre the value is of the parameter's kind and allowed, see complaint_about()
void set_value(Case& input, const Parameter& parameter, const Value& value);

/// What is wrong with a value and what would be right, "must be greater than 0 mm and at most 1000 mm, but is -1 mm";
/// empty for an allowed value.
[[nodiscard]] std::string complaint_about(const Parameter& parameter, const Value& value);

/// A case with all defaults in place and nothing else: every required member is zero or empty.
[[nodiscard]] Case default_case();

}  // namespace knitmech::model
