#include "model/case_of_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "base/errors.h"
#include "base/text.h"

namespace knitmech::model {
namespace {

void check_checksum(const Case::Fabric& fabric, const curves::YarnFile& file, const std::string& checksum) {
  if (fabric.yarns_checksum.empty() || fabric.yarns_checksum == checksum) return;
  throw InputError(fmt::format(
      "{} is not the file that the case was written for: its checksum is {}, not fabric.yarns_checksum = {}; put that "
      "file back, or remove the checksum for a new run",
      file.path.string(), checksum, base::in_quotes(fabric.yarns_checksum)));
}

void check_unit(const Case::Fabric& fabric, const curves::YarnFile& file) {
  if (file.lines.in_millimetres == !fabric.file_unit) return;
  if (fabric.file_unit) {
    throw InputError(
        fmt::format("fabric.file_unit is given, but {} says its unit itself; remove it", file.path.string()));
  }
  throw InputError(fmt::format(
      "fabric.file_unit is missing: {} does not say how long its lengths are; write for example file_unit = \"1 mm\"",
      file.path.string()));
}

void check_is_open(const curves::YarnFile& file) {
  const auto& yarns = file.lines.yarns;
  const auto closed = std::ranges::find_if(yarns, &curves::YarnLine::closed);
  if (closed == yarns.end()) return;
  throw InputError(
      fmt::format("{}: yarn {} is closed to a ring, but yarns must have two ends; cut it open in the tool "
                  "that made the file",
                  file.path.string(), closed - yarns.begin() + 1));
}

}  // namespace

std::string complaint_about_fabric(const Parameter& parameter, bool names_file) {
  if (names_file && parameter.from == FabricFrom::loops) {
    return "is given beside fabric.yarns, which takes the place of [loop], [edge_yarn], contact.edge_friction and of "
           "the stitches of [fabric]; remove one of the two";
  }
  if (!names_file && parameter.from == FabricFrom::file) {
    return "goes only with fabric.yarns, which is not given; remove it, or give the file of yarns";
  }
  return {};
}

void read_yarn_file_of(Case& input, const std::optional<std::filesystem::path>& folder) {
  Case::Fabric& fabric = input.fabric;
  if (!folder) {
    throw InputError(fmt::format(
        "the file {} cannot be read, because this text of a case stands in no folder; save the case beside the file of "
        "yarns and use knitmech check and knitmech run",
        base::in_quotes(fabric.yarns)));
  }
  curves::YarnFile file = curves::read_yarn_file(*folder / fabric.yarns);
  std::string checksum = curves::checksum_of(file.bytes);
  check_checksum(fabric, file, checksum);
  check_unit(fabric, file);
  check_is_open(file);
  fabric.yarns = curves::plain_name(file.ending);
  fabric.yarns_checksum = std::move(checksum);
  fabric.yarn_file = std::make_shared<const curves::YarnFile>(std::move(file));
}

}  // namespace knitmech::model
