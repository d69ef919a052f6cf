#include "exchange/abaqus_lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <istream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "base/errors.h"
#include "base/text.h"
#include "exchange/abaqus_lines.h"
#include "exchange/abaqus_reader.h"
#include "exchange/abaqus_syntax.h"

namespace knitmech::exchange {
namespace {

using syntax::Entry;
using syntax::Keyword;
using syntax::Names;
using syntax::Role;

constexpr int kFewestOfFreedom = 1, kMostOfFreedom = 6;

const char* word_for(Names names) {
  switch (names) {
    case Names::node_set:
      return "node set";
    case Names::element_set:
      return "element set";
    case Names::material:
      return "material";
    case Names::amplitude:
      return "amplitude";
    case Names::surface:
      return "surface";
    case Names::interaction:
      break;
  }
  return "surface interaction";
}

bool may_stand_for_dof(const std::string& entry) {
  static const std::set<std::string> kWords{"ENCASTRE", "PINNED", "XSYMM",  "YSYMM",
                                            "ZSYMM",    "XASYMM", "YASYMM", "ZASYMM"};
  return kWords.contains(entry);
}

class Lint {
 public:
  explicit Lint(std::string source) : source_(std::move(source)) {}

  void check(const KeywordBlock& block) {
    const Keyword* rule = syntax::keyword_rule(block.keyword);
    if (rule == nullptr) return note_unknown(block);
    check_place(block, *rule);
    check_options(block, *rule);
    check_data(block, *rule);
    define_and_refer(block, *rule);
    before_.push_back(block.keyword);
  }

  void finish() {
    if (in_step_) error(step_line_, "the step does not end; *END STEP is missing");
    if (!had_step_) error(0, "there is no *STEP, so nothing would be computed");
  }

  std::vector<DeckFinding> findings;

 private:
  void error(int line, std::string message) { findings.push_back({line, true, std::move(message)}); }

  /// Notes what throws InputError as an error of a line, without the place that its message begins with.
  template <typename Check>
  void note_errors_of(int line, const Check& check) {
    try {
      check();
    } catch (const InputError& thrown) {
      const std::string place = fmt::format("{}, line {}: ", source_, line);
      std::string message = thrown.what();
      error(line, message.starts_with(place) ? message.substr(place.size()) : message);
    }
  }

  void note_unknown(const KeywordBlock& block) {
    const std::string_view nearest = base::nearest_word(block.keyword, syntax::keyword_names());
    if (nearest.empty()) {
      findings.push_back(
          {block.line, false, fmt::format("{} is not among the keywords that are checked", block.as_written)});
    } else {
      error(block.line, fmt::format("there is no keyword {}; is *{} meant?", block.as_written, nearest));
    }
    before_.push_back(block.keyword);
  }

  void check_place(const KeywordBlock& block, const Keyword& rule) {
    if (rule.part == syntax::Part::history && !in_step_)
      error(block.line, fmt::format("{} belongs into a step", block.as_written));
    if (rule.part == syntax::Part::model && in_step_) {
      error(block.line, fmt::format("{} does not belong into a step", block.as_written));
    }
    if (block.keyword == "STEP") {
      in_step_ = had_step_ = true;
      step_line_ = block.line;
    }
    if (block.keyword == "ENDSTEP") in_step_ = false;
    if (rule.after.empty()) return;
    const auto between = [&](const std::string& keyword) {
      return std::ranges::find(rule.is_within, keyword) != rule.is_within.end();
    };
    const auto owner = std::ranges::find_if_not(before_.rbegin(), before_.rend(), between);
    if (owner != before_.rend() && std::ranges::find(rule.after, *owner) != rule.after.end()) return;
    error(block.line, fmt::format("{} belongs to a *{} before it", block.as_written,
                                  base::alternatives({rule.after.begin(), rule.after.end()})));
  }

  void check_options(const KeywordBlock& block, const Keyword& rule) {
    for (const syntax::Option& option : rule.options) {
      if (!block.has(option.name)) {
        if (option.required) error(block.line, fmt::format("{} needs the option {}", block.as_written, option.name));
        continue;
      }
      const std::string value = block.option(option.name);
      if (option.role != Role::plain && value.empty()) {
        error(block.line, fmt::format("{}: {} needs a name", block.as_written, option.name));
      }
      if (option.values.empty() || std::ranges::find(option.values, value) != option.values.end()) continue;
      error(block.line, fmt::format("{}: {}={} is not possible; expected {}", block.as_written, option.name, value,
                                    base::alternatives({option.values.begin(), option.values.end()})));
    }
    for (const auto& [name, value] : block.options) {
      if (std::ranges::find(rule.options, name, &syntax::Option::name) != rule.options.end()) continue;
      error(block.line, fmt::format("{} has no option {}", block.as_written, name));
    }
  }

  static const std::vector<syntax::Lines>& lines_of(const KeywordBlock& block, const Keyword& rule) {
    static const std::vector<syntax::Lines> kNone;
    for (const syntax::Data& data : rule.data) {
      const bool counts = data.option.empty() ||
                          (block.has(data.option) && (data.value.empty() || block.option(data.option) == data.value));
      if (counts) return data.lines;
    }
    return kNone;
  }

  void check_data(const KeywordBlock& block, const Keyword& rule) {
    std::size_t next = 0;
    for (const syntax::Lines& lines : lines_of(block, rule)) {
      int count = 0;
      while (count < lines.most && next < block.data.size()) {
        check_line(block, block.data[next++], lines);
        ++count;
      }
      if (count < lines.least) {
        return error(block.line, fmt::format("{} ends before its data line {}", block.as_written, next + 1));
      }
    }
    if (next < block.data.size()) {
      error(block.data[next].line, fmt::format("{} has no such data line", block.as_written));
    }
    if (block.keyword == "ELEMENT") check_elements(block);
  }

  void check_line(const KeywordBlock& block, const DataLine& data, const syntax::Lines& lines) {
    std::size_t n = data.entries.size();
    if (n > 1 && data.entries.back().empty()) --n;  // a comma at the end adds no entry
    if (data.is_blank()) n = 0;
    if (n < lines.fewest) {
      return error(data.line, fmt::format("{}: {} entries; at least {} are needed", block.as_written, n, lines.fewest));
    }
    if (n > lines.fields.size() && !lines.last_repeats) {
      return error(data.line,
                   fmt::format("{}: {} entries; at most {} are possible", block.as_written, n, lines.fields.size()));
    }
    for (std::size_t i = 0; i < n; ++i) {
      check_entry(block, data, data.entries[i], lines.fields[std::min(i, lines.fields.size() - 1)]);
    }
  }

  void check_entry(const KeywordBlock& block, const DataLine& data, const std::string& entry, syntax::Field field) {
    switch (field.entry) {
      case Entry::text:
        return;
      case Entry::whole:
        return note_errors_of(data.line, [&] { static_cast<void>(integer(source_, data.line, entry)); });
      case Entry::real:
        return note_errors_of(data.line, [&] { static_cast<void>(real_number(source_, data.line, entry)); });
      case Entry::name_or_empty:
        if (entry.empty()) return;
        return refer(data.line, field.names, entry);
      case Entry::name:
        return refer(data.line, field.names, entry);
      case Entry::name_or_number:
        if (looks_like_number(entry)) return check_number(data, entry, field.names);
        return refer(data.line, field.names, entry);
      case Entry::variable:
        if (syntax::is_output_variable(block.keyword, entry)) return;
        return error(data.line,
                     fmt::format("{} does not know the variable {}", block.as_written, base::in_quotes(entry)));
      case Entry::degree_or_word:
        if (!may_stand_for_dof(entry)) check_degree(data.line, entry);
        return;
      case Entry::degree_or_nothing:
        if (!entry.empty()) check_degree(data.line, entry);
        return;
    }
  }

  void check_degree(int line, const std::string& entry) {
    note_errors_of(line, [&] {
      const int degree = integer(source_, line, entry);
      if (degree < kFewestOfFreedom || degree > kMostOfFreedom) {
        error(line,
              fmt::format("{} is no degree of freedom; they are {} to {}", degree, kFewestOfFreedom, kMostOfFreedom));
      }
    });
  }

  /// The number of a node or element that stands where a set might.
  void check_number(const DataLine& data, const std::string& entry, Names names) {
    note_errors_of(data.line, [&] {
      const int number = integer(source_, data.line, entry);
      const bool is_node = names == Names::node_set;
      if (!(is_node ? nodes_ : elements_).contains(number)) {
        error(data.line, fmt::format("the {} {} is not defined before", is_node ? "node" : "element", number));
      }
    });
  }

  void check_elements(const KeywordBlock& block) {
    const auto [least, most] = syntax::nodes_of_type(block.option("TYPE"));
    if (most == 0) {
      findings.push_back(
          {block.line, false, fmt::format("elements of the type {} are not checked", block.option("TYPE"))});
    }
    for (const DataLine& data : block.data) {
      const int n = static_cast<int>(data.entries.size()) - 1;
      if (most > 0 && (n < least || n > most)) {
        error(data.line, fmt::format("an element {} has {} to {} nodes, not {}", block.option("TYPE"), least, most, n));
      }
      for (std::size_t i = 1; i < data.entries.size(); ++i) {
        if (looks_like_number(data.entries[i])) check_number(data, data.entries[i], Names::node_set);
      }
    }
  }

  void refer(int line, Names names, const std::string& name) {
    if (name.empty() || defined_.contains({names, name})) return;
    error(line, fmt::format("the {} {} is not defined before", word_for(names), base::in_quotes(name)));
  }

  void define_and_refer(const KeywordBlock& block, const Keyword& rule) {
    if (block.keyword == "NODE") note_numbers(block, nodes_);
    if (block.keyword == "ELEMENT") note_numbers(block, elements_);
    for (const syntax::Option& option : rule.options) {
      const std::string name = block.option(option.name);
      if (name.empty()) continue;
      if (option.role == Role::refers) refer(block.line, option.names, name);
      if (option.role == Role::adds_to && (!block.data.empty() || block.has("ELSET")))
        defined_.insert({option.names, name});
      if (option.role == Role::defines && !defined_.insert({option.names, name}).second) {
        error(block.line,
              fmt::format("the {} {} is defined a second time", word_for(option.names), base::in_quotes(name)));
      }
    }
  }

  void note_numbers(const KeywordBlock& block, std::set<int>& numbers) {
    for (const DataLine& data : block.data) {
      if (!looks_like_number(data.entry(0))) continue;
      note_errors_of(data.line, [&] { numbers.insert(integer(source_, data.line, data.entry(0))); });
    }
  }

  std::string source_;
  std::vector<std::string> before_;  ///< keywords so far
  std::set<std::pair<Names, std::string>> defined_;
  std::set<int> nodes_, elements_;
  bool in_step_ = false, had_step_ = false;
  int step_line_ = 0;
};

/// What read_abaqus() finds in a deck whose keywords are right.
void add_finding_of_reader(const std::string& text, const std::string& source, std::vector<DeckFinding>& findings) {
  try {
    std::istringstream again(text);
    static_cast<void>(read_abaqus(again, source));
  } catch (const InputError& thrown) {
    findings.push_back({0, true, thrown.what()});
  }
}

}  // namespace

std::vector<DeckFinding> lint_abaqus(std::istream& in, const std::string& source) {
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  Lint lint(source);
  try {
    std::istringstream stream(text);
    for (const KeywordBlock& block : read_keyword_blocks(stream, source)) lint.check(block);
    lint.finish();
  } catch (const InputError& thrown) {
    lint.findings.push_back({0, true, thrown.what()});
    return std::move(lint.findings);
  }
  const bool is_right = std::ranges::none_of(lint.findings, &DeckFinding::is_error);
  if (is_right) add_finding_of_reader(text, source, lint.findings);
  std::ranges::stable_sort(lint.findings, {}, &DeckFinding::line);
  return std::move(lint.findings);
}

}  // namespace knitmech::exchange
