#include <cstdint>

#include "curves/bcc_format.h"
#include "curves/bytes.h"
#include "curves/write_lines.h"

namespace knitmech::curves {
namespace {

constexpr std::size_t kNoteBytes = 40;
constexpr std::size_t kOuterPoints = 2;  // one beyond each end of an open curve

std::size_t n_control_points(const YarnLine& yarn) {
  return yarn.points.size() + (yarn.closed ? 0 : kOuterPoints);
}

std::string head_of(const std::vector<YarnLine>& yarns) {
  std::uint64_t n_points = 0;
  for (const YarnLine& yarn : yarns) {
    n_points += n_control_points(yarn);
  }
  std::string bytes(kBccMagic);
  put(bytes, kBccFourAndFour);
  bytes += kBccCatmullRom;
  put(bytes, std::uint8_t{3});
  put(bytes, kBccZUp);
  put(bytes, static_cast<std::uint64_t>(yarns.size()));
  put(bytes, n_points);
  std::string note = "yarn centrelines written by KnitMech";
  note.resize(kNoteBytes, '\0');
  return bytes + note;
}

}  // namespace

std::string bcc_text(const std::vector<YarnLine>& yarns) {
  std::string bytes = head_of(yarns);
  for (const YarnLine& yarn : yarns) {
    const std::vector<Eigen::Vector3d>& points = yarn.points;
    const auto count = static_cast<std::int32_t>(n_control_points(yarn));
    put(bytes, yarn.closed ? -count : count);
    if (!yarn.closed) put_point(bytes, 2 * points[0] - points[1]);
    for (const Eigen::Vector3d& point : points) {
      put_point(bytes, point);
    }
    if (!yarn.closed) put_point(bytes, 2 * points.back() - points[points.size() - 2]);
  }
  return bytes;
}

}  // namespace knitmech::curves
