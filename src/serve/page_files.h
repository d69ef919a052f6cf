#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace knitmech::serve {

/// A file of the page, as web/build.mjs makes it.
struct PageFile {
  std::string_view name;                  ///< "index.html"
  std::string_view type;                  ///< "text/html; charset=utf-8"
  std::span<const unsigned char> packed;  ///< the content [gzip]
};

[[nodiscard]] const std::vector<PageFile>& page_files();

}  // namespace knitmech::serve
