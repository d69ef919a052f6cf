#include "results/checkpoint_file.h"

#include <fmt/core.h>

#include <cereal/archives/portable_binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/errors.h"
#include "results/atomic_file.h"
#include "results/summary.h"

namespace knitmech::results {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFormat = "knitmech-checkpoint";

/// FNV-1a of 64 bits (Fowler, Noll, Vo): every step is a bijection, so that one wrong byte always shows.
std::uint64_t checksum(std::string_view bytes, std::uint64_t sum = 0xcbf29ce484222325) {
  for (const char byte : bytes) {
    sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  }
  return sum;
}

/// The first line of the file: format, version of the program, lengths of the two parts that follow, their checksum.
std::string head_line(std::string_view record, std::string_view solver) {
  return fmt::format("{} {} {} {} {:016x}\n", kFormat, KNITMECH_VERSION, record.size(), solver.size(),
                     checksum(solver, checksum(record)));
}

std::string bytes_of(const Checkpoint& checkpoint) {
  std::ostringstream stream;
  cereal::PortableBinaryOutputArchive(stream, cereal::PortableBinaryOutputArchive::Options::LittleEndian())(
      checkpoint.case_text, checkpoint.record);
  return std::move(stream).str();
}

void take_from(const std::string& bytes, Checkpoint& checkpoint) {
  std::istringstream stream(bytes);
  cereal::PortableBinaryInputArchive(stream, cereal::PortableBinaryInputArchive::Options::LittleEndian())(
      checkpoint.case_text, checkpoint.record);
}

[[nodiscard]] std::string refusal(const fs::path& dir, const std::string& why) {
  return fmt::format("The run in \"{0}\" cannot go on: {1}; start it anew with knitmech run \"{0}/case.toml\".",
                     dir.string(), why);
}

/// Words of the first line.
struct Head {
  std::string format, version, checksum;
  std::size_t record = 0, solver = 0;
};

Head read_head(std::string_view line) {
  Head head;
  std::istringstream words{std::string(line)};
  words >> head.format >> head.version >> head.record >> head.solver >> head.checksum;
  return head;
}

void refuse_what_has_ended(const fs::path& dir) {
  if (!is_summary(dir / kSummaryFile)) {
    throw InputError(
        fmt::format("\"{}\" is no folder of a KnitMech run; give one that has a {}.", dir.string(), kCheckpointFile));
  }
  const std::string status = status_in_summary(dir / kSummaryFile);
  if (status == "completed") {
    throw InputError(fmt::format("The run in \"{}\" is complete; there is nothing to resume.", dir.string()));
  }
  if (status == "failed") {
    throw InputError(fmt::format(
        "The run in \"{}\" has failed and would fail again; its summary.json says why and what to try.", dir.string()));
  }
  if (!fs::exists(dir / kCheckpointFile)) {
    throw InputError(refusal(dir, fmt::format("it ended before its first {}", kCheckpointFile)));
  }
}

}  // namespace

void write_checkpoint(const fs::path& dir, const Checkpoint& checkpoint) {
  const std::string record = bytes_of(checkpoint);
  write_file_atomically(dir / kCheckpointFile, {head_line(record, checkpoint.solver), record, checkpoint.solver});
}

Checkpoint read_checkpoint(const fs::path& dir) {
  refuse_what_has_ended(dir);
  const std::string content = read_file(dir / kCheckpointFile);
  const std::size_t end_of_head = content.find('\n');
  const Head head = read_head(std::string_view(content).substr(0, end_of_head));
  const auto damaged = [&dir] { return InputError(refusal(dir, fmt::format("its {} is damaged", kCheckpointFile))); };
  if (end_of_head == std::string::npos || head.format != kFormat) throw damaged();
  if (head.version != KNITMECH_VERSION) {
    throw InputError(refusal(
        dir, fmt::format("its {} is of KnitMech {} and this is {}", kCheckpointFile, head.version, KNITMECH_VERSION)));
  }
  const std::string_view parts = std::string_view(content).substr(end_of_head + 1);
  if (head.record > parts.size() || head.solver != parts.size() - head.record) throw damaged();
  const std::string record(parts.substr(0, head.record));
  Checkpoint checkpoint;
  checkpoint.solver = parts.substr(head.record);
  if (head_line(record, checkpoint.solver) != content.substr(0, end_of_head + 1)) throw damaged();
  try {
    take_from(record, checkpoint);
  } catch (const std::exception&) {
    throw InputError(refusal(dir, fmt::format("its {} is of another KnitMech {}", kCheckpointFile, KNITMECH_VERSION)));
  }
  return checkpoint;
}

}  // namespace knitmech::results
