#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace knitmech::results {

/// A frame of a collection file.
struct FrameEntry {
  int index = 0;
  double strain = 0;  ///< [-]

  template <class Archive>
  void serialize(Archive& archive) {
    archive(index, strain);
  }
};

/// ParaView's collection file (frames.pvd, contacts.pvd), which lists a file per frame with the strain [-] in the place
/// of the time. file_name gives the file of a frame: frame_file_name() or contact_points_file_name().
[[nodiscard]] std::string collection_text(const std::vector<FrameEntry>& entries, std::string (*file_name)(int index));

/// Reads back the frames.pvd that collection_text() made. Throws FileError if it cannot be read, InputError if it is
/// damaged or something else.
[[nodiscard]] std::vector<FrameEntry> read_frames_collection(const std::filesystem::path& path);

}  // namespace knitmech::results
