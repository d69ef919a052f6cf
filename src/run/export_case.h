#pragma once

#include <span>
#include <string>
#include <string_view>

#include "run/load_case.h"

namespace knitmech::run {

/// A format in which a model goes to another program.
struct ExportFormat {
  std::string_view name;       ///< of `knitmech export -f`
  std::string_view label;      ///< "Abaqus/Explicit input file"
  std::string_view extension;  ///< of its files, without the dot
};

[[nodiscard]] std::span<const ExportFormat> export_formats();

/// The file of a case in a format. @throws InputError if there is no such format
[[nodiscard]] std::string exported(const LoadedCase& loaded, std::string_view format);

}  // namespace knitmech::run
