#include "results/read_contacts.h"

#include <fmt/core.h>

#include <numbers>
#include <string>
#include <string_view>

#include "base/errors.h"
#include "results/atomic_file.h"
#include "results/contact_file.h"
#include "results/csv_text.h"

namespace knitmech::results {
namespace {

/// Takes the cells of a line one after the other.
class Cells {
 public:
  Cells(std::string_view line, const std::vector<std::string_view>& columns, const CsvPlace& place)
      : cells_(csv_cells(line)), columns_(columns), place_(place) {
    if (cells_.size() != columns_.size()) {
      throw InputError(fmt::format("{}, line {}: expected {} values separated by commas, found {}.",
                                   place.path.string(), place.line, columns_.size(), cells_.size()));
    }
  }

  double number() {
    const auto value = parse_number<double>(cells_[at_], columns_[at_], place_);
    ++at_;
    return value;
  }

  Eigen::Vector3d vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

  int yarn(const model::Model& model) {
    const int value = parse_number<int>(cells_[at_], columns_[at_], place_);
    if (value < 0 || value >= static_cast<int>(model.yarns.size())) wrong("a yarn of the model");
    ++at_;
    return value;
  }

  bool slips() {
    if (cells_[at_] != "slip" && cells_[at_] != "stick") wrong("\"stick\" or \"slip\"");
    return cells_[at_++] == "slip";
  }

  /// For a column that follows from others.
  void skip() { ++at_; }

 private:
  [[noreturn]] void wrong(std::string_view expected) const {
    throw_wrong_cell(cells_[at_], columns_[at_], place_, expected);
  }

  std::vector<std::string_view> cells_;
  const std::vector<std::string_view>& columns_;
  const CsvPlace& place_;
  std::size_t at_ = 0;
};

/// In the order of kContactHeader.
model::ContactRecord contact_in(Cells cells, const model::Model& model) {
  model::ContactRecord contact;
  contact.first_yarn = cells.yarn(model);
  cells.skip();  // first_course
  contact.first_place = cells.number();
  contact.second_yarn = cells.yarn(model);
  cells.skip();  // second_course
  contact.second_place = cells.number();
  contact.position = cells.vector();
  contact.normal = cells.vector();
  contact.gap = cells.number();
  contact.normal_force = cells.number();
  contact.friction_force = cells.vector();
  cells.skip();  // friction_force_magnitude_N
  contact.slip = cells.number();
  contact.elastic_slip = cells.number();
  contact.slips = cells.slips();
  contact.angle = cells.number() * std::numbers::pi / 180;
  return contact;
}

}  // namespace

std::vector<model::ContactRecord> read_contacts(const std::filesystem::path& path, const model::Model& model) {
  const std::string content = read_file(path);
  const std::vector<std::string_view> lines = csv_lines(content);
  if (lines.empty() || lines.front() != kContactHeader) {
    throw InputError(fmt::format("{}, line 1: expected the header of a KnitMech table of contacts, \"{}\".",
                                 path.string(), kContactHeader));
  }
  const std::vector<std::string_view> columns = csv_cells(kContactHeader);
  std::vector<model::ContactRecord> contacts;
  contacts.reserve(lines.size() - 1);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const CsvPlace place{path, static_cast<int>(i) + 1};
    contacts.push_back(contact_in(Cells(lines[i], columns, place), model));
  }
  return contacts;
}

}  // namespace knitmech::results
