#pragma once

#include <cstddef>
#include <vector>

#include "model/model.h"

namespace knitmech::contact {

/// Coefficients of friction [-] of every kind of yarn on every other, by their sections.
class FrictionTable {
 public:
  explicit FrictionTable(const model::Model& model)
      : n_(model.sections.size()), coefficients_(n_ * n_, model.friction) {
    for (const model::PairFriction& pair : model.pair_friction) {
      const auto a = static_cast<std::size_t>(pair.first_section);
      const auto b = static_cast<std::size_t>(pair.second_section);
      coefficients_[a * n_ + b] = coefficients_[b * n_ + a] = pair.friction;
    }
  }

  [[nodiscard]] double between(int first_section, int second_section) const {
    return coefficients_[static_cast<std::size_t>(first_section) * n_ + static_cast<std::size_t>(second_section)];
  }

 private:
  std::size_t n_;
  std::vector<double> coefficients_;
};

}  // namespace knitmech::contact
