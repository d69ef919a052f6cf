#include "run/export_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/errors.h"
#include "base/text.h"
#include "run/export_decks.h"
#include "run/export_geometry.h"

namespace knitmech::run {
namespace {

constexpr int kFewestSides = 3, kMostSides = 256;

const std::vector<ExportFormat>& all_formats() {
  using enum ExportKind;
  static const std::vector<ExportFormat> formats{
      {"abaqus", "Abaqus/Explicit input file", deck, {".inp"}, abaqus_files, true},
      {"calculix-beams", "CalculiX input file, beams without contact", deck, {".inp"}, calculix_beams_files},
      {"calculix-solids", "CalculiX input file, yarns as solids", deck, {".inp"}, calculix_solids_files},
      {"openradioss",
       "OpenRadioss starter and engine decks",
       deck,
       {"_0000.rad", "_0001.rad"},
       openradioss_files,
       true},
      {"lsdyna", "LS-DYNA keyword deck", deck, {".k"}, lsdyna_files, true},
      {"vtp", "Yarns as lines for ParaView", geometry, {".vtp"}, vtp_files},
      {"gltf", "Yarns as tubes, binary glTF 2.0", geometry, {".glb"}, gltf_files},
      {"obj", "Yarns as tubes, Wavefront OBJ", geometry, {".obj"}, obj_files},
      {"stl", "Yarns as tubes, binary STL", geometry, {".stl"}, stl_files},
      {"step", "Yarns as solids for CAD programs, STEP", geometry, {".step"}, step_files},
      {"csv", "Yarn centrelines, a table of points", geometry, {".csv"}, csv_files},
      {"bcc", "Yarn centrelines, binary curve collection", geometry, {".bcc"}, bcc_files},
      {"yarns", "Yarn centrelines of the CMU Textiles Lab", geometry, {".yarns"}, yarns_files},
  };
  return formats;
}

}  // namespace

std::span<const ExportFormat> export_formats() {
  return all_formats();
}

const ExportFormat& export_format(std::string_view name) {
  const auto found = std::ranges::find(all_formats(), name, &ExportFormat::name);
  if (found != all_formats().end()) return *found;
  std::vector<std::string_view> names;
  for (const ExportFormat& each : all_formats()) names.push_back(each.name);
  const std::string_view nearest = base::nearest_word(name, names);
  throw InputError(fmt::format(
      "there is no format {}; {}", base::in_quotes(name),
      nearest.empty() ? "the formats are " + base::alternatives(names) : fmt::format("did you mean {}?", nearest)));
}

std::string export_stem(const std::filesystem::path& file, const ExportFormat& format) {
  const std::string name = file.filename().string();
  for (const std::string_view ending : format.endings) {
    if (name.size() > ending.size() && name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  }
  return file.stem().string();
}

std::filesystem::path export_path(const std::filesystem::path& file, const ExportFormat& format,
                                  std::string_view ending) {
  if (format.endings.size() == 1) return file;
  return file.parent_path() / (export_stem(file, format) + std::string(ending));
}

std::string export_remark(const ExportSource& source, const ExportFormat& format) {
  if (!format.contact_on_chords || source.model.centreline == model::Centreline::chords) return "";
  return fmt::format(
      "the program that reads this deck lays contact on the straight elements, and KnitMech on smooth yarns; to "
      "compare, "
      "run the case with contact.centreline = \"chords\"{}",
      source.input.solver.mass_scaling ? "" : " and a number for solver.mass_scaling");
}

std::vector<ExportedFile> exported(const ExportSource& source, const ExportFormat& format) {
  if (source.frame != nullptr && format.kind == ExportKind::deck) {
    throw InputError(fmt::format("the format {} has no frames: a deck starts with the fabric as it was knitted",
                                 base::in_quotes(format.name)));
  }
  if (source.sides < kFewestSides || source.sides > kMostSides) {
    throw InputError(fmt::format("a tube has {} to {} sides, not {}", kFewestSides, kMostSides, source.sides));
  }
  std::vector<std::string> texts = format.write(source);
  std::vector<ExportedFile> files;
  for (std::size_t i = 0; i < texts.size(); ++i) files.push_back({format.endings.at(i), std::move(texts[i])});
  return files;
}

}  // namespace knitmech::run
