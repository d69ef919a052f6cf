#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "contact/cell_law.h"

namespace knitmech::contact {

/// Many cells that are integrated side by side, one in each lane of the processor's vectors.
class CellBatch {
 public:
  void clear() { n_ = 0; }
  [[nodiscard]] std::size_t size() const { return n_; }

  /// \param start, middle, end depths [mm]   \param radii D [mm]
  void add(double start, double middle, double end, double radii);

  /// Integrates all cells that were added, as integrate_cell() does to better than 1e-6.
  void integrate();

  [[nodiscard]] CellLoad load(std::size_t cell) const {
    return {energy_[cell], tangent_[cell], {on_start_[cell], on_middle_[cell], on_end_[cell]}};
  }

 private:
  void make_room(std::size_t n);

  std::size_t n_ = 0;
  std::vector<double> start_, middle_, end_, radii_;
  std::vector<double> energy_, tangent_, on_start_, on_middle_, on_end_;
  std::vector<double> irregular_;  ///< 1 where a cell has to be integrated on its own
};

}  // namespace knitmech::contact
