#pragma once

#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace knitmech::bench {

/// A table whose columns have titles.
class Table {
 public:
  using Row = std::vector<std::string>;

  /// \param rows titles first
  explicit Table(std::vector<Row> rows) : rows_(std::move(rows)) {
    if (rows_.size() < 2) throw std::runtime_error("A table is empty.");
  }

  [[nodiscard]] std::size_t n_rows() const { return rows_.size() - 1; }
  [[nodiscard]] const std::string& text(std::size_t row, const std::string& title) const {
    for (std::size_t i = 0; i < rows_[0].size(); ++i) {
      if (rows_[0][i] == title) return rows_[row + 1].at(i);
    }
    throw std::runtime_error("A table has no column \"" + title + "\".");
  }
  [[nodiscard]] double number(std::size_t row, const std::string& title) const { return std::stod(text(row, title)); }

 private:
  std::vector<Row> rows_;
};

/// Reads a table that is tab separated.
[[nodiscard]] inline Table read_table(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + " cannot be read.");
  std::vector<Table::Row> rows;
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    for (rows.emplace_back(); std::getline(cells, line, '\t');) rows.back().push_back(line);
  }
  return Table(std::move(rows));
}

}  // namespace knitmech::bench
