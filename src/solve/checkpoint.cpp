#include "solve/checkpoint.h"

#include <cereal/archives/portable_binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/common.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <sstream>
#include <utility>

#include "base/errors.h"

namespace Eigen {

template <class Archive>
void serialize(Archive& archive, Vector3d& v) {
  archive(v.x(), v.y(), v.z());
}

}  // namespace Eigen

namespace knitmech::solve {

namespace {

constexpr const char* kStrange = "The checkpoint was not written by this version of the program; start the run anew.";

cereal::PortableBinaryOutputArchive::Options little_endian() {
  return cereal::PortableBinaryOutputArchive::Options::LittleEndian();
}

}  // namespace

std::string checkpoint_of(const ExplicitSolver& solver, const RunProgress& progress) {
  std::ostringstream stream;
  cereal::PortableBinaryOutputArchive(stream, little_endian())(solver, progress);
  return std::move(stream).str();
}

void go_back_to(std::string checkpoint, ExplicitSolver& solver, RunProgress& progress) {
  std::istringstream stream(std::move(checkpoint));
  try {
    cereal::PortableBinaryInputArchive(stream, cereal::PortableBinaryInputArchive::Options::LittleEndian())(solver,
                                                                                                            progress);
  } catch (const cereal::Exception&) {
    throw InputError(kStrange);
  }
  if (stream.peek() != std::istringstream::traits_type::eof()) throw InputError(kStrange);
}

}  // namespace knitmech::solve
