#pragma once

#include <optional>
#include <vector>

#include "contact/cell_batch.h"
#include "contact/contact_elements.h"
#include "contact/contact_step.h"
#include "contact/overlap.h"
#include "contact/placed_points.h"

namespace knitmech::contact {

/// Room to compute an overlap in; what is in it means nothing before and after. One for each thread.
class OverlapWork {
 public:
  /// Brings the strips of an overlap up to date: their memory, and its loads on the elements.
  ///
  /// Long overlaps are where yarns lie side by side or wind about each other: one yarn is cut into short strips, the
  /// other into cells, and every strip sees the cells that are near it,
  ///
  ///     energy = k  sum over strips  w  sum over cells  integral of e(D - |x_b(t) - x_a|) dT
  ///
  /// (the energy of line_potential.h, w the length of a strip). Strips, cells and all points on them stay where they
  /// are on the yarns, and the integral along a cell is exact in the depths at its three points (cell_law.h). So the
  /// energy is a function of the positions of these points alone: there is no closest place to be found, none that
  /// could jump or vanish where a yarn winds round another so tightly that all its places are equally near, and the
  /// forces are exact derivatives.
  /// \param done what it comes to is added
  void evaluate(const StepOfContacts& step, const ContactElements& pieces, Overlap& overlap, ContactStep& done);

 private:
  /// A strip that is awake, and its cells on which the depth is above 0.
  struct AwakeStrip {
    std::size_t strip;
    double greatest_depth;  ///< at a point [mm]
    std::size_t nearest;    ///< point with that depth
    std::size_t first_cell, n_cells;
  };
  /// A cell that may press.
  struct PressedCell {
    std::size_t point;  ///< its first point
    double length;      ///< [mm]
  };

  struct PointRange {
    std::size_t first, n;
  };

  void find_awake(const Overlap& overlap, double moved);
  void place(const StepOfContacts& step, const ContactElements& pieces, const Overlap& overlap);
  void find_pressed_cells(const StepOfContacts& step, const ContactElements& pieces, const Overlap& overlap,
                          AwakeStrip& awake);
  [[nodiscard]] PointRange weigh(const AwakeStrip& awake);
  void press(const StepOfContacts& step, const ContactElements& pieces, const AwakeStrip& awake, double moved,
             Overlap& overlap, ContactStep& done);
  void give_loads(const StepOfContacts& step, const ContactElements& pieces, Overlap& overlap) const;

  std::vector<AwakeStrip> awake_;
  PlacedPoints middles_, points_;  ///< of the strips; of the cells
  std::size_t first_middle_ = 0;   ///< number of the strip whose middle comes first
  std::vector<double> depths_;     ///< of a strip
  std::vector<double> weights_;    ///< of all points, for a strip [mm^2]
  std::vector<PressedCell> cells_;
  CellBatch batch_;
};

}  // namespace knitmech::contact
