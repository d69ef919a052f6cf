#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace knitmech::yarn {

/// A measured point of a yarn's tensile curve.
struct AxialPoint {
  double strain = 0;  ///< [-]
  double force = 0;   ///< [N]
};

/// What a yarn answers to an axial strain.
struct AxialResponse {
  double force = 0;   ///< N [N]
  double slope = 0;   ///< dN / d(strain) [N], the axial stiffness EA at this strain
  double energy = 0;  ///< integral of N from 0 to the strain [mJ/mm], per length of the unstrained yarn
};

/// An elastic axial law N(strain) through measured points: smooth, and nowhere falling between them.
///
/// Between the points a cubic with continuous slope, the slopes after Fritsch and Butland: the weighted harmonic mean
/// of the two neighbouring secants, 0 where one of them is 0. At the two ends it is the slope of the parabola through
/// three points, but not below a third of the end's secant nor above three times it: the lower bound keeps a yarn from
/// having no stiffness at zero (and, if the curve ends steeply, beyond it), the upper one keeps the cubic from falling.
/// With two points the law is a straight line. Below 0 it goes on with the slope at 0, beyond the last point with the
/// slope there.
///
/// Source: F. N. Fritsch, J. Butland, A method for constructing local monotone piecewise cubic interpolants, SIAM J.
/// Sci. Stat. Comput. 5 (1984), doi:10.1137/0905021.
class AxialLaw {
 public:
  /// Throws InputError that names the point (from 1) unless the first is (0, 0), strains ascend, no force falls, the
  /// second force is above 0, all numbers are finite and there are at least two points.
  explicit AxialLaw(const std::vector<AxialPoint>& points);

  /// Force, slope and energy at once. As quick for many points as for few, unless they are very unevenly spaced.
  [[nodiscard]] AxialResponse at(double strain) const {
    const Piece& piece = pieces_[piece_of(strain)];
    const double s = strain - piece.start;
    const double c2 = piece.half_curvature;
    const double c3 = piece.cubic;
    return {.force = piece.force + s * (piece.slope + s * (c2 + s * c3)),
            .slope = piece.slope + s * (2 * c2 + s * 3 * c3),
            .energy = piece.energy + s * (piece.force + s * (piece.slope / 2 + s * (c2 / 3 + s * c3 / 4)))};
  }

  [[nodiscard]] double force(double strain) const { return at(strain).force; }    ///< N [N]
  [[nodiscard]] double slope(double strain) const { return at(strain).slope; }    ///< dN / d(strain) [N]
  [[nodiscard]] double energy(double strain) const { return at(strain).energy; }  ///< [mJ/mm]

  /// The least strain at which a force above 0 [N] is reached; infinite if the law ends flat below it.
  [[nodiscard]] double strain_at(double force) const;

  /// Strains of the points, from 0 on [-].
  [[nodiscard]] std::vector<double> strains() const;

  [[nodiscard]] double slope_at_zero() const { return pieces_.front().slope; }  ///< EA of the unstrained yarn [N]
  [[nodiscard]] double largest_slope() const { return largest_slope_; }         ///< over all strains [N]
  [[nodiscard]] double last_strain() const { return pieces_.back().start; }     ///< of the last point [-]

 private:
  /// A cubic in s = strain - start.
  struct Piece {
    double start = 0, energy = 0, force = 0, slope = 0, half_curvature = 0, cubic = 0;
  };

  [[nodiscard]] std::size_t piece_of(double strain) const {
    if (!(strain > 0)) return 0;
    if (strain >= last_strain()) return pieces_.size() - 1;
    std::size_t piece = first_piece_[static_cast<std::size_t>(strain * cells_per_strain_)];
    while (strain >= pieces_[piece + 1].start) ++piece;
    return piece;
  }
  void make_cells();

  std::vector<std::uint32_t>
      first_piece_;  ///< that may hold the strains of a cell; the cells are evenly spaced from 0 on
  double cells_per_strain_ = 0;
  std::vector<Piece> pieces_;  ///< below 0, between the points, beyond the last
  double largest_slope_ = 0;
};

}  // namespace knitmech::yarn
