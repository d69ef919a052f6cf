#include "results/read_frame.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "base/errors.h"
#include "model/places.h"
#include "results/atomic_file.h"
#include "results/contact_file.h"
#include "results/frame_file.h"
#include "results/read_contacts.h"
#include "results/run_folder.h"
#include "results/vtk_reader.h"

namespace knitmech::results {
namespace {

using model::Frame;
using model::Model;

template <int kSize>
std::vector<Eigen::Matrix<double, kSize, 1>> vectors(const std::vector<double>& numbers) {
  std::vector<Eigen::Matrix<double, kSize, 1>> all(numbers.size() / kSize);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = Eigen::Map<const Eigen::Matrix<double, kSize, 1>>(numbers.data() + kSize * i);
  }
  return all;
}

std::vector<double> nan_as_infinite(std::vector<double> values) {
  for (double& value : values) {
    value = std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  }
  return values;
}

/// Values of elements by the rule of model::Model, from one value per element (elements_only()).
std::vector<double> with_yarn_ends(const Model& model, const std::vector<double>& element_values) {
  std::vector<double> values;
  values.reserve(model.nodes.size());
  auto next = element_values.begin();
  for (const model::ModelYarn& yarn : model.yarns) {
    const auto end = next + std::max(0, yarn.n_nodes - 1);
    values.insert(values.end(), next, end);
    next = end;
    values.push_back(0);
  }
  return values;
}

void read_history_values(const VtkReader& reader, model::HistoryRow& row) {
  const auto number = [&reader](const char* name) { return reader.numbers("FieldData", name, 1).front(); };
  row.strain = number("strain");
  row.time = number("time_s");
  row.displacement = number("displacement_mm");
  row.force_top = number("force_top_N");
  row.force_bottom = number("force_bottom_N");
}

void read_node_fields(const VtkReader& reader, std::size_t n, Frame& frame) {
  frame.points = vectors<3>(reader.numbers("Points", "points_mm", 3 * n));
  frame.rotations = vectors<4>(reader.numbers("PointData", "rotation_wxyz", 4 * n));
  frame.contact_force = vectors<3>(reader.numbers("PointData", "contact_force_N", 3 * n));
  frame.tie_force = vectors<3>(reader.numbers("PointData", "tie_force_N", 3 * n));
  frame.gap = nan_as_infinite(reader.numbers("PointData", "gap_mm", n));
}

void read_element_fields(const VtkReader& reader, const Model& model, Frame& frame) {
  const auto n_elements = static_cast<std::size_t>(model.n_elements());
  for (const ElementField& field : kElementFields) {
    const std::string name = std::string{kElementPrefix} + field.name;
    frame.*field.values = with_yarn_ends(model, reader.numbers("FieldData", name, n_elements));
  }
}

/// Elements that no polyline joins.
std::vector<int> broken_elements(const VtkReader& reader, const Model& model) {
  const std::size_t n = model.nodes.size();
  std::vector<bool> is_joined(n, false);
  if (reader.n_lines() > n) reader.fail("is damaged: it has more lines than points");
  std::vector<std::int64_t> ends, points;
  if (reader.n_lines() > 0) {
    ends = reader.integers("Lines", "offsets", reader.n_lines());
    if (!std::is_sorted(ends.begin(), ends.end()) || ends.front() < 0 || ends.back() > static_cast<std::int64_t>(n)) {
      reader.fail("is damaged: its lines are not those of the yarns");
    }
    points = reader.integers("Lines", "connectivity", static_cast<std::size_t>(ends.back()));
  }
  std::size_t at = 0;
  for (const std::int64_t end : ends) {
    for (; at + 1 < static_cast<std::size_t>(end); ++at) {
      if (points[at] < 0 || points[at] + 1 >= static_cast<std::int64_t>(n) || points[at + 1] != points[at] + 1) {
        reader.fail("is damaged: its lines are not those of the yarns");
      }
      is_joined[static_cast<std::size_t>(points[at])] = true;
    }
    at = static_cast<std::size_t>(end);
  }
  std::vector<int> broken;
  for (const model::ModelYarn& yarn : model.yarns) {
    for (int node = yarn.first_node; node + 1 < yarn.first_node + yarn.n_nodes; ++node) {
      if (!is_joined[static_cast<std::size_t>(node)]) broken.push_back(node);
    }
  }
  return broken;
}

/// A frame is a row of the history too, with the same bits.
model::HistoryRow history_row(const StoredRun& run, const Frame& frame) {
  const auto found = std::find_if(run.history.begin(), run.history.end(), [&frame](const model::HistoryRow& row) {
    return row.time == frame.history.time && row.strain == frame.history.strain;
  });
  if (found == run.history.end()) {
    throw InputError(fmt::format("{} has no row of frame {}, at {} s.", (run.dir / kHistoryFile).string(), frame.index,
                                 frame.history.time));
  }
  return *found;
}

void check_is_stored(const StoredRun& run, int index) {
  if (std::any_of(run.frames.begin(), run.frames.end(),
                  [index](const FrameEntry& one) { return one.index == index; })) {
    return;
  }
  throw InputError(fmt::format("The run in {} has no frame {}; it has {} to {}.", run.dir.string(), index,
                               run.frames.front().index, run.frames.back().index));
}

}  // namespace

Frame read_frame_file(const std::filesystem::path& path, const Model& model, int index) {
  const VtkReader reader(path, read_file(path));
  if (reader.n_points() != model.nodes.size()) {
    reader.fail(
        fmt::format("has {} points, but the model of the run has {} nodes", reader.n_points(), model.nodes.size()));
  }
  Frame frame;
  frame.index = index;
  read_history_values(reader, frame.history);
  read_node_fields(reader, model.nodes.size(), frame);
  read_element_fields(reader, model, frame);
  frame.broken = broken_elements(reader, model);
  return frame;
}

Frame read_frame(const StoredRun& run, int index) {
  check_is_stored(run, index);
  const std::filesystem::path folder = run.dir / kFramesFolder;
  Frame frame = read_frame_file(folder / frame_file_name(index), run.model, index);
  frame.contacts = read_contacts(folder / contact_table_file_name(index), run.model);
  frame.history = history_row(run, frame);
  return frame;
}

}  // namespace knitmech::results
