#include "results/quality.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "results/constants.h"

namespace knitmech::results {
namespace {

using model::HistoryRow;
using Rows = std::span<const HistoryRow>;

/// A ratio and the strain at which it occurs.
struct Peak {
  double value = 0;
  double strain = 0;
};

/// |numerator| / denominator; infinite if there is nothing to compare a finite numerator with or a number is missing.
double ratio(double numerator, double denominator) {
  if (numerator == 0) {
    return 0;
  }
  const double value = std::abs(numerator) / denominator;
  return denominator > 0 && std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
}

template <typename RatioOf>
Peak largest(Rows rows, RatioOf&& ratio_of) {
  Peak peak{ratio_of(rows.front()), rows.front().strain};
  for (const HistoryRow& row : rows.subspan(1)) {
    if (const double value = ratio_of(row); value > peak.value) {
      peak = {value, row.strain};
    }
  }
  return peak;
}

double balance_ratio(const HistoryRow& row) {
  return ratio(energy_residual(row), row.external_work);
}

double grip_difference_of(Rows rows) {
  double top = 0;
  double bottom = 0;
  for (const HistoryRow& row : rows) {
    top += row.force_top;
    bottom += row.force_bottom;
  }
  return ratio(top - bottom, 0.5 * (top + bottom));
}

double kinetic_ratio_of(Rows rows) {
  double kinetic = 0;
  double internal = 0;
  for (const HistoryRow& row : rows) {
    kinetic += row.kinetic_energy;
    internal += row.internal_energy;
  }
  return ratio(kinetic, internal);
}

/// Largest ratio over windows of kWindow strain. The windows reach back from the last row, so that the end of the test
/// is always judged; a first window that is not full counts only if it is the only one.
template <typename RatioOf>
Peak largest_over_windows(Rows rows, RatioOf&& ratio_of) {
  Peak peak;
  std::size_t end = rows.size();
  while (end > 0) {
    const double start_strain = rows[end - 1].strain - kWindow;
    std::size_t begin = end - 1;
    while (begin > 0 && rows[begin - 1].strain > start_strain) {
      --begin;
    }
    const bool is_full = begin > 0;
    const bool is_only = end == rows.size();
    if (is_full || is_only) {
      const double value = ratio_of(rows.subspan(begin, end - begin));
      if (is_only || value > peak.value) {
        peak = {value, rows[end - 1].strain};
      }
    }
    end = begin;
  }
  return peak;
}

/// A share in percent; from ten times on its digits would say nothing: then what it is a share of is next to nothing.
std::string percent(double share) {
  return share < 10 ? fmt::format("{:.2g} %", 100 * share) : std::string{"a multiple"};
}

std::string strain_text(double strain) {
  return fmt::format("{:.1f} % strain", 100 * strain);
}

/// Sentences on the limits that failed, with what to try; empty if all were kept.
std::string failed_limits(const Quality& quality) {
  std::string text;
  const auto add = [&text](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
  if (quality.lost_crossings > 0) {
    add(fmt::format("{} crossing{} lost: yarn passed through yarn; use a larger contact stiffness or pull less far.",
                    quality.lost_crossings, quality.lost_crossings == 1 ? " was" : "s were"));
  }
  const bool kinetic_failed = *quality.kinetic_ratio > kKineticRatioLimit;
  const bool grips_failed = *quality.grip_difference > kGripDifferenceLimit;
  if (kinetic_failed || grips_failed) {
    std::string what;
    if (kinetic_failed) {
      what = fmt::format("the kinetic energy reaches {} of the internal energy up to {} (limit {})",
                         percent(*quality.kinetic_ratio), strain_text(*quality.kinetic_ratio_strain),
                         percent(kKineticRatioLimit));
    }
    if (grips_failed) {
      what += fmt::format("{}the grip forces differ by {} of their mean up to {} (limit {})",
                          what.empty() ? "" : " and ", percent(*quality.grip_difference),
                          strain_text(*quality.grip_difference_strain), percent(kGripDifferenceLimit));
    }
    add(fmt::format("Not quasi-static: {}; pull more slowly or use less mass scaling.", what));
  }
  if (*quality.energy_balance > kEnergyBalanceLimit) {
    add(fmt::format(
        "The energy balance is off by {} of the work at {} (limit {}); use a smaller share of the stable "
        "step or less mass scaling.",
        percent(*quality.energy_balance), strain_text(*quality.energy_balance_strain), percent(kEnergyBalanceLimit)));
  }
  return text;
}

std::string kept_limits(const Quality& quality, model::RunStatus status) {
  return fmt::format(
      "{} after the toe region, which ends at {}: kinetic energy at most {} of the internal energy, energy "
      "balance within {} of the work, grip forces within {} of each other.",
      status == model::RunStatus::failed ? "The limits of a quasi-static test were kept" : "Quasi-static",
      strain_text(*quality.toe_strain), percent(*quality.kinetic_ratio), percent(*quality.energy_balance),
      percent(*quality.grip_difference));
}

/// How the run ended, if it did not reach its end.
std::string ending(const model::RunOutcome& outcome) {
  switch (outcome.status) {
    case model::RunStatus::completed:
      return {};
    case model::RunStatus::interrupted:
      return fmt::format("The run was interrupted at {} and is judged up to there. ", strain_text(outcome.strain));
    case model::RunStatus::failed:
      return fmt::format("The simulation failed at {}; its last rows are not to be trusted. ",
                         strain_text(outcome.strain));
  }
  return {};
}

void set_ratios(Quality& quality, Rows rows) {
  quality.toe_strain = rows.front().strain;
  const Peak kinetic = largest_over_windows(rows, kinetic_ratio_of);
  quality.kinetic_ratio = kinetic.value;
  quality.kinetic_ratio_strain = kinetic.strain;
  const Peak balance = largest(rows, balance_ratio);
  quality.energy_balance = balance.value;
  quality.energy_balance_strain = balance.strain;
  quality.energy_balance_end = balance_ratio(rows.back());
  const Peak grips = largest_over_windows(rows, grip_difference_of);
  quality.grip_difference = grips.value;
  quality.grip_difference_strain = grips.strain;
}

}  // namespace

double energy_residual(const HistoryRow& row) {
  return row.internal_energy + row.kinetic_energy + row.contact_energy + row.friction_loss + row.damping_loss +
         row.break_loss - row.external_work;
}

std::size_t first_row_after_toe(const std::vector<HistoryRow>& history) {
  double largest_work = 0;
  for (const HistoryRow& row : history) {
    largest_work = std::isfinite(row.external_work) ? std::max(largest_work, row.external_work) : largest_work;
  }
  if (largest_work <= 0) {
    return history.size();
  }
  std::size_t first = history.size();
  // Written so that a work that is not a number counts as judged, and is then found wanting.
  while (first > 0 && !(history[first - 1].external_work < kToeWorkShare * largest_work)) {
    --first;
  }
  return first;
}

Quality assess_quality(const std::vector<HistoryRow>& history, const model::RunOutcome& outcome, double diameter) {
  Quality quality;
  quality.penetration = outcome.largest_penetration;
  quality.penetration_ratio = diameter > 0 ? outcome.largest_penetration / diameter : 0;
  for (const HistoryRow& row : history) {
    quality.elastic_slip = std::max(quality.elastic_slip, row.largest_elastic_slip);
  }
  quality.elastic_slip_ratio = diameter > 0 ? quality.elastic_slip / diameter : 0;
  quality.lost_crossings = outcome.lost_crossings;
  quality.crossing_checks = outcome.crossing_checks;
  const std::size_t first = first_row_after_toe(history);
  if (first == history.size()) {
    quality.verdict = ending(outcome) +
                      "The fabric never left the toe region of hardly any force, so nothing can be said about the "
                      "quality; pull further.";
    return quality;
  }
  set_ratios(quality, Rows{history}.subspan(first));
  const std::string failures = failed_limits(quality);
  quality.quasi_static = failures.empty() && outcome.status != model::RunStatus::failed;
  quality.verdict = ending(outcome) + (failures.empty() ? kept_limits(quality, outcome.status) : failures);
  return quality;
}

}  // namespace knitmech::results
