#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/text.h"
#include "exchange/abaqus_reading.h"
#include "exchange/constants.h"

namespace knitmech::exchange::deck {

namespace {

using Sets = std::map<std::string, AbaqusDeck::Set>;

void add_to_set(AbaqusDeck::Set& set, const std::vector<int>& more, int line) {
  if (set.line == 0) set.line = line;
  set.members.insert(set.members.end(), more.begin(), more.end());
  std::sort(set.members.begin(), set.members.end());
  set.members.erase(std::unique(set.members.begin(), set.members.end()), set.members.end());
}

/// Nodes of an element of a type; 0 if the type is not known here.
std::size_t n_nodes_of(const std::string& type) {
  if (type == "B31" || type == "T3D2") return 2;
  if (type == "B32") return 3;
  return 0;
}

/// The entries of an element, from as many data lines as it takes: a line that ends with a comma goes on.
std::vector<std::string> element_entries(const KeywordBlock& block, std::size_t& i, std::size_t n_nodes) {
  std::vector<std::string> entries = block.data[i].entries;
  while (entries.back().empty() && entries.size() <= n_nodes + 1 && i + 1 < block.data.size()) {
    entries.pop_back();
    const std::vector<std::string>& next = block.data[++i].entries;
    entries.insert(entries.end(), next.begin(), next.end());
  }
  if (entries.back().empty()) entries.pop_back();
  return entries;
}

std::vector<int> generated(const Reading& reading, const DataLine& data) {
  const int first = reading.whole(data, 0);
  const int last = reading.whole(data, 1);
  const int increment = data.entry(2).empty() ? 1 : reading.whole(data, 2);
  if (increment <= 0 || last < first) {
    reading.fail(data.line, "GENERATE needs first, last, increment, with first <= last and a positive increment");
  }
  std::vector<int> numbers;
  for (long number = first; number <= last; number += increment) numbers.push_back(static_cast<int>(number));
  return numbers;
}

std::vector<int> listed(const Reading& reading, const DataLine& data, const Sets& sets) {
  std::vector<int> numbers;
  std::size_t n_entries = 0;
  for (const std::string& entry : data.entries) {
    if (entry.empty()) continue;
    if (++n_entries > kAbaqusSetEntries) {
      reading.fail(data.line, fmt::format("more than {} entries on a line of a set", kAbaqusSetEntries));
    }
    if (looks_like_number(entry)) {
      numbers.push_back(integer(reading.source, data.line, entry));
    } else if (const auto set = sets.find(entry); set != sets.end()) {
      numbers.insert(numbers.end(), set->second.members.begin(), set->second.members.end());
    } else {
      reading.fail(data.line, fmt::format("the set {} is not defined before it is used", base::in_quotes(entry)));
    }
  }
  return numbers;
}

void read_set(Reading& reading, const KeywordBlock& block, Sets& sets, const char* option) {
  const std::string name = reading.required(block, option);
  std::vector<int> numbers;
  for (const DataLine& data : block.data) {
    if (data.is_blank()) continue;
    const std::vector<int> more = block.has("GENERATE") ? generated(reading, data) : listed(reading, data, sets);
    numbers.insert(numbers.end(), more.begin(), more.end());
  }
  if (numbers.empty()) reading.fail(block.line, fmt::format("the set {} is empty", name));
  add_to_set(sets[name], numbers, block.line);
}

}  // namespace

void read_nodes(Reading& reading, const KeywordBlock& block) {
  std::vector<int> numbers;
  for (const DataLine& data : block.data) {
    if (data.is_blank()) continue;
    const int number = reading.whole(data, 0);
    if (data.entries.size() < 2 || data.entries.size() > 7) {
      reading.fail(data.line, fmt::format("node {} needs a number and three coordinates", number));
    }
    const Eigen::Vector3d point(reading.real(data, 1), reading.real(data, 2), reading.real(data, 3));
    if (!reading.deck.nodes.emplace(number, point).second) {
      reading.fail(data.line, fmt::format("node {} is defined a second time", number));
    }
    numbers.push_back(number);
  }
  if (block.has("NSET")) add_to_set(reading.deck.node_sets[block.option("NSET")], numbers, block.line);
}

void read_elements(Reading& reading, const KeywordBlock& block) {
  const std::string type = reading.required(block, "TYPE");
  const std::size_t n_nodes = n_nodes_of(type);
  if (n_nodes == 0) reading.fail(block.line, fmt::format("elements of type {} cannot be read; B31 can", type));
  std::vector<int> numbers;
  for (std::size_t i = 0; i < block.data.size(); ++i) {
    if (block.data[i].is_blank()) continue;
    const int line = block.data[i].line;
    const std::vector<std::string> entries = element_entries(block, i, n_nodes);
    if (entries.size() != n_nodes + 1) {
      reading.fail(line, fmt::format("an element of type {} has a number and {} nodes, not {} entries", type, n_nodes,
                                     entries.size()));
    }
    AbaqusDeck::Element element{type, {}, line};
    const int number = integer(reading.source, line, entries.front());
    for (std::size_t k = 1; k < entries.size(); ++k) {
      element.nodes.push_back(integer(reading.source, line, entries[k]));
    }
    if (!reading.deck.elements.emplace(number, std::move(element)).second) {
      reading.fail(line, fmt::format("element {} is defined a second time", number));
    }
    numbers.push_back(number);
  }
  if (block.has("ELSET")) add_to_set(reading.deck.element_sets[block.option("ELSET")], numbers, block.line);
}

void read_node_set(Reading& reading, const KeywordBlock& block) {
  read_set(reading, block, reading.deck.node_sets, "NSET");
}

void read_element_set(Reading& reading, const KeywordBlock& block) {
  read_set(reading, block, reading.deck.element_sets, "ELSET");
}

}  // namespace knitmech::exchange::deck
