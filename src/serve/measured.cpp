#include "serve/measured.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/quantity.h"
#include "compare/measured_curve.h"
#include "serve/refusal.h"
#include "yarn/tensile_curve.h"

namespace knitmech::serve {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLargestText = 20'000'000;  // [bytes]
constexpr std::size_t kMostPoints = 2000;         // of a curve

double length_of(const char* what, const std::string& typed) {
  try {
    const double length = base::parse_quantity(typed, base::Dimension::length);
    if (length > 0) return length;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", what, error.what()));
  }
  throw InputError(fmt::format("{}: should be larger than 0, as 100 mm", what));
}

/// Evenly chosen, the first and the last among them.
std::vector<double> thinned(const std::vector<double>& values, double factor) {
  const std::size_t n = std::min(values.size(), kMostPoints);
  std::vector<double> chosen;
  chosen.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from = values.size() <= kMostPoints ? i : i * (values.size() - 1) / (n - 1);
    chosen.push_back(factor * values[from]);
  }
  return chosen;
}

}  // namespace

std::string measured_json(const std::string& name, std::string_view text, const std::string& gauge_length,
                          const std::string& width) {
  if (text.size() > kLargestText) {
    throw Refusal(413, fmt::format("{}: is larger than {} bytes; give the curves of fewer specimens, or fewer points",
                                   name, kLargestText));
  }
  const double of_width = length_of("width", width);
  const yarn::TestFacts facts{.gauge_length = length_of("gauge length", gauge_length), .width = of_width};
  const compare::MeasuredCurve measured = compare::average(yarn::read_tensile_curves(text, name, facts), of_width);
  Json specimens = Json::array();
  for (const yarn::TensileCurve& curve : measured.specimens) {
    specimens.push_back({{"name", curve.name},
                         {"strain", thinned(curve.strains, 1)},
                         {"force_per_width", thinned(curve.forces, 1 / of_width)}});
  }
  const yarn::MeanCurve& mean = measured.mean;
  const Json document = {{"specimens", std::move(specimens)},
                         {"mean",
                          {{"strain", thinned(mean.strains, 1)},
                           {"mean", thinned(mean.forces, 1)},
                           {"lowest", thinned(mean.least, 1)},
                           {"highest", thinned(mean.greatest, 1)}}}};
  return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace knitmech::serve
