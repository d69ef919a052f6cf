#include "throughput/kernels.h"

#include <utility>

#include "beam/internal_force.h"
#include "beam/nodal_inertia.h"
#include "contact/centreline.h"
#include "contact/motion.h"
#include "solve/integrate.h"
#include "solve/selective_mass.h"
#include "throughput/stopwatch.h"

namespace knitmech::bench {

namespace {

constexpr double kEntry = sizeof(double);

// beam/internal_force.cpp. 311 operations in element_pass: 193 of them in element_state (40 in the series of the half
// angle, 30 in the rotation matrix, 15 to turn the chord back), 94 in element_loads (45 to turn three vectors), 24 for
// chord, viscosity and its loss; 6 to gather, 1 to add up the loss. Reads position 3, rotation 4, velocity 3, element
// 9, approach 1; writes approach 1; sets loads 6.
constexpr Cost kBeams{311 + 6 + 1, (10 + 9 + 2 + 2 * 6) * kEntry};
// solve/integrate.cpp, advance. 10 for each velocity, 6 for the position, 68 to turn the node. Reads masses 2, loads 6,
// state 13; writes state 13.
constexpr Cost kIntegration{10 + 10 + 6 + 68, (2 + 6 + 2 * 13) * kEntry};
// solve/selective_mass.cpp. 2 operations in each direction to eliminate, 4 to substitute. Reads and writes forces 3
// twice over; reads factors 2 and 4, mass 1.
constexpr Cost kSelectiveMass{3 * 2 + 3 * 4, (4 * 3 + 2 + 4 + 1) * kEntry};
// contact/centreline.cpp. 12 in move_nodes; in turn_all 30 for each of three vectors and 8 for its change, 6 for what
// the line moved by them. Reads position 3, rotation 4, stress-free vectors 6; reads and writes position as it was 3,
// turned vectors 9; sets moved 1, turned 1, the first of which is read and written again.
constexpr Cost kSmoothLine{12 + 3 * 38 + 6, (3 + 4 + 6 + 2 * (3 + 9) + 2 * 2 + 2) * kEntry};
// contact/centreline.cpp, move_nodes. Reads position 3, the same as it was 3; writes 3; sets moved 1.
constexpr Cost kChordLine{12, (3 + 2 * 3 + 2) * kEntry};
// contact/motion.cpp, add_moves. Reads moved 1, turned 1, bound 1; reads and writes motion 1, its part by turning 1.
constexpr Cost kMotion{4, (3 + 2 * 2) * kEntry};

Cost sum(const std::vector<KernelTime>& kernels) {
  Cost all{};
  for (const KernelTime& kernel : kernels) {
    all.flops += kernel.cost.flops;
    all.bytes += kernel.cost.bytes;
  }
  return all;
}

/// The parts of a solver, each to be called by itself, at a state that one has reached.
class Parts {
 public:
  Parts(const model::Model& model, const solve::ExplicitSettings& settings, model::State state)
      : settings_(settings),
        team_(static_cast<std::size_t>(settings.threads)),
        elements_(beam::make_elements(model, settings.mass_scaling, settings.bulk_viscosity)),
        inertia_(beam::lump_inertia(elements_, settings.mass_scaling, settings.finest_length)),
        masses_(inertia_, solve::GivenMotion::by_grips(model)),
        line_(model),
        motion_(model.nodes.size()),
        work_(model.nodes.size()),
        loads_(model.nodes.size()),
        no_loads_(model.nodes.size()),
        state_(std::move(state)),
        n_elements_(static_cast<double>(model.n_elements())) {}

  [[nodiscard]] std::vector<KernelTime> time() {
    std::vector<KernelTime> times;
    const auto add = [&](const char* name, Cost cost, const auto& work) {
      times.push_back({name, cost, shortest_time(work) / n_elements_});
    };
    constexpr double kStep = 1e-6;  // [s]; does not matter
    add("beams", kBeams, [&] { beam::set_internal_force(elements_, state_, kStep, work_, loads_, team_); });
    add("centreline", line_.is_smooth() ? kSmoothLine : kChordLine, [&] { line_.update(state_, {}, kStep, team_); });
    add("motion", kMotion, [&] { motion_.add(line_.moved(), line_.turned(), 0, team_); });
    // Zero forces stay zero; others would fade from call to call into numbers that the processor is slow with.
    add("selective mass", kSelectiveMass, [&] { masses_.share(no_loads_, team_); });
    add("integration", kIntegration, [&] {
      solve::integrate(inertia_, no_loads_, {kStep, kStep}, settings_.mass_damping, state_, team_);
    });
    return times;
  }

 private:
  solve::ExplicitSettings settings_;
  base::ThreadTeam team_;
  beam::Elements elements_;
  beam::NodalInertia inertia_;
  solve::SelectiveMass masses_;
  contact::Centreline line_;
  contact::Motion motion_;
  beam::ElementWork work_;
  model::NodalLoads loads_, no_loads_;
  model::State state_;
  double n_elements_;
};

}  // namespace

std::vector<KernelTime> time_kernels(const model::Model& model, const solve::ExplicitSettings& settings) {
  solve::ExplicitSolver solver(model, settings);
  const double step = shortest_time([&] { solver.step(); });

  std::vector<KernelTime> times = Parts(model, settings, solver.state()).time();
  times.push_back({"whole step", sum(times), step / static_cast<double>(model.n_elements())});
  return times;
}

}  // namespace knitmech::bench
