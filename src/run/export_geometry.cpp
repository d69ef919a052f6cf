#include "run/export_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/errors.h"
#include "curves/write_lines.h"
#include "exchange/tube_files.h"
#include "exchange/write_vtp.h"
#include "exchange/yarn_samples.h"
#include "model/yarn_curve.h"

namespace knitmech::run {
namespace {

std::vector<model::CurvePiece> curves_of(const ExportSource& source) {
  std::vector<model::CurvePiece> pieces =
      source.frame == nullptr ? model::yarn_curves(source.model) : model::yarn_curves(source.model, *source.frame);
  if (pieces.empty()) throw InputError("no element of the yarns is whole in this frame, so there is nothing to write");
  return pieces;
}

std::string title_of(const ExportSource& source) {
  if (source.frame == nullptr) return source.model.title;
  return fmt::format("{}, strain {:.4g}", source.model.title, source.frame->history.strain);
}

/// A list in braces would copy the text, which may be of gigabytes.
std::vector<std::string> one_file(std::string bytes) {
  std::vector<std::string> files;
  files.push_back(std::move(bytes));
  return files;
}

exchange::YarnTubes tubes_of(const ExportSource& source) {
  return {.title = title_of(source), .pieces = curves_of(source), .sides = source.sides};
}

std::vector<curves::YarnLine> lines_of(const ExportSource& source) {
  const std::vector<model::CurvePiece> pieces = curves_of(source);
  int steps = 1;
  for (const model::CurvePiece& piece : pieces) steps = std::max(steps, exchange::steps_of(piece));
  std::vector<curves::YarnLine> lines;
  for (const exchange::YarnRow row : exchange::yarn_rows(pieces)) {
    curves::YarnLine& line = lines.emplace_back();
    line.radius = row.front().radius;
    for (const exchange::YarnSample& sample : exchange::samples_of(row, steps)) line.points.push_back(sample.point);
  }
  return lines;
}

}  // namespace

std::vector<std::string> vtp_files(const ExportSource& source) {
  const double strain = source.frame == nullptr ? 0 : source.frame->history.strain;
  return one_file(exchange::vtp_text(source.model, curves_of(source), strain));
}

std::vector<std::string> gltf_files(const ExportSource& source) {
  return one_file(exchange::glb_bytes(tubes_of(source)));
}

std::vector<std::string> obj_files(const ExportSource& source) {
  return one_file(exchange::obj_text(tubes_of(source)));
}

std::vector<std::string> stl_files(const ExportSource& source) {
  return one_file(exchange::stl_bytes(tubes_of(source)));
}

std::vector<std::string> step_files(const ExportSource& source) {
  return one_file(exchange::step_text(tubes_of(source)));
}

std::vector<std::string> csv_files(const ExportSource& source) {
  return one_file(curves::csv_text(lines_of(source)));
}

std::vector<std::string> bcc_files(const ExportSource& source) {
  return one_file(curves::bcc_text(lines_of(source)));
}

std::vector<std::string> yarns_files(const ExportSource& source) {
  return one_file(curves::yarns_text(lines_of(source)));
}

}  // namespace knitmech::run
