#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "base/errors.h"
#include "base/text.h"
#include "curves/bcc_format.h"
#include "curves/bytes.h"
#include "curves/check_lines.h"
#include "curves/read_lines.h"

namespace knitmech::curves {
namespace {

constexpr std::size_t kCountBytes = sizeof(std::int32_t);

LineKind kind_in(std::string_view bytes) {
  if (!bytes.starts_with(kBccMagic)) {
    throw InputError("is no binary curve collection: it does not begin with the letters BCC");
  }
  if (bytes.size() < kBccHead) {
    throw InputError(
        fmt::format("ends within its head: it has {} bytes, and the head alone {}", bytes.size(), kBccHead));
  }
  if (number_at<std::uint8_t>(bytes, kBccNumberSizes) != kBccFourAndFour) {
    throw InputError("does not hold numbers of 32 bits (byte 3 is not 0x44); only such files can be read");
  }
  if (const int n = number_at<std::uint8_t>(bytes, kBccDimensions); n != 3) {
    throw InputError(fmt::format("holds curves in {} dimensions; only those in 3 can be read", n));
  }
  const std::string_view type = bytes.substr(kBccCurveType, 2);
  if (type == kBccCatmullRom) return LineKind::inner_points;
  if (type == kBccPolyline) return LineKind::through_points;
  throw InputError(
      fmt::format("holds curves of the type {}; only \"C0\", uniform Catmull-Rom, and \"PL\", polylines, "
                  "can be read",
                  base::in_quotes(type)));
}

/// Throws where the counts of the head cannot be those of a file of this size.
void check_counts(std::string_view bytes) {
  const auto n_curves = number_at<std::uint64_t>(bytes, kBccCurveCount);
  const auto n_points = number_at<std::uint64_t>(bytes, kBccPointCount);
  const std::size_t rest = bytes.size() - kBccHead;
  if (n_curves <= rest / kCountBytes && n_points <= rest / kPointBytes &&
      n_curves * kCountBytes + n_points * kPointBytes == rest) {
    return;
  }
  throw InputError(
      fmt::format("is damaged or cut off: its head speaks of {} curves with {} control points, which is "
                  "not what {} bytes hold",
                  n_curves, n_points, bytes.size()));
}

YarnLine read_yarn(std::string_view bytes, std::size_t& place, std::size_t index) {
  const auto damaged = [&](const std::string& what) {
    return InputError(fmt::format("is damaged: {} at byte {} {}", yarn_text(index), place, what));
  };
  if (bytes.size() - place < kCountBytes) throw damaged("is missing");
  const std::int64_t count = number_at<std::int32_t>(bytes, place);
  const auto n_points = static_cast<std::size_t>(count < 0 ? -count : count);
  if (n_points > (bytes.size() - place - kCountBytes) / kPointBytes) {
    throw damaged(fmt::format("should have {} points, more than the file holds", n_points));
  }
  place += kCountBytes;
  YarnLine yarn;
  yarn.closed = count < 0;
  for (std::size_t i = 0; i < n_points; ++i, place += kPointBytes) {
    yarn.points.push_back(point_at(bytes, place));
  }
  return yarn;
}

}  // namespace

YarnLines parse_bcc(std::string_view bytes) {
  YarnLines lines;
  lines.kind = kind_in(bytes);
  check_counts(bytes);
  const auto n_curves = number_at<std::uint64_t>(bytes, kBccCurveCount);
  std::size_t place = kBccHead;
  for (std::uint64_t i = 0; i < n_curves; ++i) {
    lines.yarns.push_back(read_yarn(bytes, place, lines.yarns.size()));
  }
  if (place != bytes.size()) {
    throw InputError(fmt::format("is damaged: its curves end at byte {}, but the file has {}", place, bytes.size()));
  }
  check_lines(lines);
  return lines;
}

}  // namespace knitmech::curves
