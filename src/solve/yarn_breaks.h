#pragma once

#include <cstddef>
#include <vector>

#include "base/left_out.h"
#include "base/thread_team.h"
#include "beam/strength_watch.h"
#include "model/model.h"
#include "model/state.h"

namespace knitmech::solve {

/// Decides which elements break.
///
/// An element breaks when its axial force reaches the strength of its section. Yarns of the model are equally strong
/// everywhere, so along a stretch under the same force all elements would break at the same instant; in a real yarn
/// the weakest place breaks and unloads the rest. So of the overloaded elements of a yarn the most overloaded breaks,
/// and no other at the distance d along the same yarn before the time
///
///     2 d / c,        c = sqrt(N / (strain rho A)) at the strength,
///
/// within which the unloading has run there. That is a moment of a slow test: 1 ms for 100 mm of a yarn with 200 m/s.
class YarnBreaks {
 public:
  /// \param mass_scaling factor on all masses [-]
  YarnBreaks(const model::Model& model, const beam::Elements& elements, double mass_scaling);

  /// Elements that break in a state, each once.
  [[nodiscard]] std::vector<std::size_t> find(const model::State& state,
                                              const base::ThreadTeam& team = base::ThreadTeam(1));

  /// c of an element at its strength [mm/s].
  [[nodiscard]] double wave_speed(std::size_t element) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(model_, mass_scaling_), watch_, breaks_);
  }

 private:
  struct Break {
    std::size_t element;
    int yarn;
    double time;  ///< [s]

    template <class Archive>
    void serialize(Archive& archive) {
      archive(element, yarn, time);
    }
  };
  [[nodiscard]] bool is_being_unloaded(std::size_t element, double time) const;

  const model::Model& model_;
  double mass_scaling_;
  beam::StrengthWatch watch_;
  std::vector<Break> breaks_;
};

}  // namespace knitmech::solve
