#include "results/collection_file.h"

#include <fmt/core.h>

namespace knitmech::results {

std::string collection_text(const std::vector<FrameEntry>& entries, std::string (*file_name)(int index)) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (const FrameEntry& entry : entries) {
    text += fmt::format("<DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n", entry.strain,
                        file_name(entry.index));
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace knitmech::results
