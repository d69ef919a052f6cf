#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/case.h"
#include "model/frame.h"
#include "model/model.h"

namespace knitmech::run {

/// What is exported.
struct ExportSource {
  const model::Case& input;
  const model::Model& model;
  const model::Frame* frame = nullptr;  ///< shape in which a geometry is written; none: as at the start
  std::string stem = "fabric";          ///< of the names of the files, which some formats repeat within
  int sides = 12;                       ///< of the polygon that stands for a round yarn, where a format has tubes
};

/// A file of an export.
struct ExportedFile {
  std::string_view ending;  ///< its name is the stem and this: ".inp", "_0000.rad"
  std::string bytes;
};

enum class ExportKind {
  deck,     ///< the model with its test, for another finite-element program
  geometry  ///< the yarns as lines or tubes
};

/// A format in which a model goes to another program.
struct ExportFormat {
  std::string_view name;   ///< of `knitmech export -f`
  std::string_view label;  ///< "Abaqus/Explicit input file"
  ExportKind kind = ExportKind::deck;
  std::vector<std::string_view> endings;                             ///< of its files, one each
  std::vector<std::string> (*write)(const ExportSource&) = nullptr;  ///< the bytes of the files, in that order
  bool contact_on_chords = false;  ///< the other program lays the contact on the straight elements
};

/// All formats, decks first.
[[nodiscard]] std::span<const ExportFormat> export_formats();

/// The format of a name. @throws InputError if there is none
[[nodiscard]] const ExportFormat& export_format(std::string_view name);

/// The name that the files of a format share, of the name that is asked for: without an ending of the format, or what
/// else stands behind the last dot.
[[nodiscard]] std::string export_stem(const std::filesystem::path& file, const ExportFormat& format);

/// Where a file of an export goes: one file to just the name that is asked for, several to its stem and their endings.
[[nodiscard]] std::filesystem::path export_path(const std::filesystem::path& file, const ExportFormat& format,
                                                std::string_view ending);

/// What to know before comparing the other program's run with KnitMech's own, in one sentence; empty if nothing.
[[nodiscard]] std::string export_remark(const ExportSource& source, const ExportFormat& format);

/// The files of a source in a format.
/// @throws InputError for a frame in a format that has none, or sides that make no tube
[[nodiscard]] std::vector<ExportedFile> exported(const ExportSource& source, const ExportFormat& format);

}  // namespace knitmech::run
