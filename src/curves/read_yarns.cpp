#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "base/errors.h"
#include "base/text.h"
#include "curves/bytes.h"
#include "curves/check_lines.h"
#include "curves/read_lines.h"
#include "curves/yarns_format.h"

namespace knitmech::curves {
namespace {

/// The content of a chunk that begins at a place; the place moves behind it.
std::string_view take_chunk(std::string_view bytes, std::size_t& place, const YarnsChunk& chunk) {
  const std::string_view rest = bytes.substr(place);
  const auto refuse = [&](const std::string& complaint) {
    throw InputError(fmt::format("at byte {}: {}", place, complaint));
  };
  if (rest.size() < kChunkHead) refuse(fmt::format("the file ends where the chunk \"{}\" is due", chunk.name));
  if (!rest.starts_with(chunk.name)) {
    refuse(fmt::format("the chunk \"{}\" is due here, but {} is there", chunk.name,
                       base::in_quotes(rest.substr(0, chunk.name.size()))));
  }
  const std::size_t size = number_at<std::uint32_t>(rest, chunk.name.size());
  if (size > rest.size() - kChunkHead) {
    refuse(fmt::format("the chunk \"{}\" should have {} bytes, but the file ends after {}", chunk.name, size,
                       rest.size() - kChunkHead));
  }
  if (size % chunk.entry_bytes != 0) {
    refuse(
        fmt::format("the chunk \"{}\" has {} bytes, which is no multiple of {}", chunk.name, size, chunk.entry_bytes));
  }
  place += kChunkHead + size;
  return rest.substr(kChunkHead, size);
}

YarnLine yarn_of(std::string_view points, std::string_view entry, std::size_t& used, std::size_t index) {
  constexpr std::size_t kEnd = 4, kRadius = 8;  // [bytes] within an entry
  const std::size_t begin = number_at<std::uint32_t>(entry, 0);
  const std::size_t end = number_at<std::uint32_t>(entry, kEnd);
  const std::size_t n_points = points.size() / kPointsChunk.entry_bytes;
  if (begin > end || end > n_points) {
    throw InputError(fmt::format("is damaged: {} should reach from point {} to point {} of {}", yarn_text(index), begin,
                                 end, n_points));
  }
  // Without this a small file could name its points a million times over.
  used += end - begin;
  if (used > n_points) throw InputError(fmt::format("is damaged: {} has points of other yarns", yarn_text(index)));
  YarnLine yarn;
  yarn.radius = number_at<float>(entry, kRadius);
  for (std::size_t i = begin; i < end; ++i) {
    yarn.points.push_back(point_at(points, i * kPointsChunk.entry_bytes));
  }
  close_where_ends_meet(yarn);
  return yarn;
}

}  // namespace

YarnLines parse_yarns(std::string_view bytes) {
  std::size_t place = 0;
  const std::string_view points = take_chunk(bytes, place, kPointsChunk);
  const std::string_view sources = take_chunk(bytes, place, kSourceChunk);
  if (points.size() / kPointsChunk.entry_bytes != sources.size() / kSourceChunk.entry_bytes) {
    throw InputError("is damaged: it has not as many source lines as points");
  }
  const std::string_view infos = take_chunk(bytes, place, kYarnsChunk);
  for (const YarnsChunk& chunk : {kStringsChunk, kUnitsChunk, kCheckpointsChunk}) {
    if (place < bytes.size()) static_cast<void>(take_chunk(bytes, place, chunk));
  }
  if (place != bytes.size()) throw InputError(fmt::format("goes on behind its last chunk, from byte {} on", place));
  YarnLines lines{.kind = LineKind::midpoints, .yarns = {}};
  std::size_t used = 0;
  for (std::size_t i = 0; i < infos.size(); i += kYarnsChunk.entry_bytes) {
    lines.yarns.push_back(yarn_of(points, infos.substr(i), used, lines.yarns.size()));
  }
  check_lines(lines);
  return lines;
}

}  // namespace knitmech::curves
