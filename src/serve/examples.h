#pragma once

#include <span>
#include <string_view>

namespace knitmech::serve {

/// A case of examples/ that is part of the program.
struct Example {
  std::string_view name;  ///< of its folder, "01-first-loop"
  std::string_view text;  ///< of its case.toml
};

/// In the order of their names. Made by src/serve/CMakeLists.txt.
[[nodiscard]] std::span<const Example> examples();

}  // namespace knitmech::serve
