#pragma once

#include <filesystem>

#include "results/read_run.h"

namespace knitmech::report {

/// In a run folder: the report, and the folder of its figures as files of their own.
inline constexpr const char* kReportFile = "report.html";
inline constexpr const char* kFiguresFolder = "figures";

/// Writes report.html, one page that needs no other file and no network, and its figures in figures/: charts as SVG,
/// pictures of the fabric as PNG.
///
/// Shown are at most kMostFrames of the stored frames, evenly spaced in strain, the last among them.
/// \param threads that draw; 0: as many as the processor has
/// @throws FileError if a file cannot be written; InputError if a stored frame is damaged
void write_run_report(const results::StoredRun& run, int threads = 0);

/// Removes the report of an earlier run from its folder, with the figures, so that it is not taken for that of the
/// next. Other files in figures/ stay. A folder that is none of a run is left alone.
/// @throws FileError if that fails
void remove_run_report(const std::filesystem::path& run_folder);

/// Frames that a report shows [-]; more make the page larger, about 1 MB each.
inline constexpr std::size_t kMostFrames = 6;

/// Nodes of all frames that a report shows together [-]: of a large fabric it shows fewer frames, at least the last. A
/// million nodes take some 0.4 GB while the report is made.
inline constexpr std::size_t kMostNodesShown = 4'000'000;

/// Nodes up to which a fabric is drawn as lines, in contact maps and from the side [-]; 100 000 make 4 MB each.
inline constexpr std::size_t kMostNodesInLines = 100'000;

}  // namespace knitmech::report
