#pragma once

#include <filesystem>

#include "model/frame.h"
#include "model/model.h"
#include "results/read_run.h"

namespace knitmech::results {

/// Reads a frame of a run back as it was written, bit by bit, with its contacts and its row of the history. Two things
/// the files do not keep: the angle of a contact, which they give in degrees, is right to the last digit but one, and a
/// gap that was not a number comes back as +infinity (no other yarn near).
///
/// Throws InputError with the file and what is wrong if the run has no such frame, the frame is not one of its model, a
/// file is damaged, or the history lacks its row; FileError if a file is missing or cannot be read.
[[nodiscard]] model::Frame read_frame(const StoredRun& run, int index);

/// The .vtp file of a frame alone: its fields, and of its history row what that file has: strain, time, displacement
/// and the forces of the grips. No contacts. Throws like read_frame().
[[nodiscard]] model::Frame read_frame_file(const std::filesystem::path& path, const model::Model& model, int index);

}  // namespace knitmech::results
