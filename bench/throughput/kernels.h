#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "solve/explicit_solver.h"

namespace knitmech::bench {

/// What a loop over the elements and nodes of a step does for one of them.
///
/// Counted by hand from the source: every addition, multiplication, division and square root of the formulas as they
/// stand there is one operation, a common subexpression counts once; comparisons and changes of sign count nothing.
/// Bytes are those of the entries of long arrays that the loop reads and writes, each once; what is set without having
/// been read counts twice, as it is fetched before; what stays in the first cache within a block counts nothing. Both
/// have to be counted anew when a loop changes; what a disassembler shows of a loop in
/// build/release/bench/throughput/roofline, one instruction for one operation, has to be as much.
struct Cost {
  double flops;  ///< [-]
  double bytes;
};

/// One kernel, timed.
struct KernelTime {
  std::string name;
  Cost cost;
  double seconds;  ///< for one element
};

/// Times the kernels of a step one by one, and the whole step while no yarn touches another.
[[nodiscard]] std::vector<KernelTime> time_kernels(const model::Model& model, const solve::ExplicitSettings& settings);

}  // namespace knitmech::bench
