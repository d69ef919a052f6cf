#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/left_out.h"
#include "beam/nodal_inertia.h"
#include "contact/centreline.h"
#include "model/frame.h"
#include "model/model.h"
#include "model/state.h"
#include "solve/integrate.h"

namespace knitmech::solve {

/// Ties between places of yarns that cross (Model::ties), as forces: in every step they load the yarns with just what
/// keeps the tied places together.
///
/// Two points that were one at the start, halfway between both centrelines, stay one. Each is fixed to the section of
/// its yarn,
///
///     p = x(s) + R a,   R the rotation of the node nearest to the place, a the way from the centreline at the start,
///
/// so that the yarns keep their relative position however the pair turns as a whole; nothing keeps them from turning
/// about the point. The force f of a tie makes the velocities u of its two points equal over the coming step h, but for
/// what takes back a share of the distance that their motion along arcs has left between them,
///
///     u_b - u_a + kTieRecovery (p_b - p_a) / h = 0:
///
/// three equations for f, with the inertia that the tie feels. Ties that share nodes are solved in turns, starting from
/// the forces of the step before. So ties do no work but for that share, store none and put no limit on the step.
class Ties {
 public:
  explicit Ties(const model::Model& model);

  /// Adds the forces of the ties to loads that are complete but for the grips.
  /// \param line the centreline that the contact sees, up to date
  void apply(const contact::Centreline& line, const beam::NodalInertia& inertia, StepLengths step, double mass_damping,
             const model::State& state, model::NodalLoads& loads);

  /// Forgets the ties on an element, which has broken.
  void remove(std::size_t element);

  /// Adds the forces of the last call of apply to other loads.
  void add_last_forces(model::NodalLoads& loads) const;

  /// Distance of the two points of a tie at the last call of apply, the largest [mm].
  [[nodiscard]] double largest_stretch() const { return largest_stretch_; }
  /// Fills the tie_force of a frame whose points are set, as of the last call of apply.
  void set_results(model::Frame& frame) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(gripped_), ties_, largest_stretch_);
  }

 private:
  struct Anchor {
    model::ElementPlace place;
    std::size_t node = 0;  ///< nearest, which the arm turns with
    Vector3 arm{};         ///< a [mm], stress-free

    template <class Archive>
    void serialize(Archive& archive) {
      archive(place, node, arm);
    }
  };
  /// A point of a tie at one instant: where it is, and how it hangs on the two nodes of its element.
  struct Point {
    std::size_t node = 0;            ///< first of the two
    std::array<double, 2> weight{};  ///< share of their displacement [-]
    std::array<Vector3, 2> arm{};    ///< it moves by w x arm where they turn [mm]
    Vector3 position{};              ///< p [mm]

    template <class Archive>
    void serialize(Archive& archive) {
      archive(node, weight, arm, position);
    }
  };
  struct Tie {
    Anchor first, second;
    Point now_first{}, now_second{};  ///< at the last call of apply
    Vector3 force{0, 0, 0};           ///< on the first, then [N]

    template <class Archive>
    void serialize(Archive& archive) {
      archive(first, second, now_first, now_second, force);
    }
  };
  class Coming;

  [[nodiscard]] static Point point_of(const contact::Centreline& line, const model::State& state, const Anchor& anchor);

  std::vector<Tie> ties_;
  std::vector<char> gripped_;  ///< per node
  double largest_stretch_ = 0;
};

}  // namespace knitmech::solve
