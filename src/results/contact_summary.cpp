#include "results/contact_summary.h"

#include <algorithm>
#include <cstddef>

#include "model/places.h"

namespace knitmech::results {
namespace {

double diameter_of(const model::Model& model, int yarn, double place) {
  return model.section_of(model::node_near(model, yarn, place)).diameter;
}

}  // namespace

ContactSummary summarise_contacts(const model::Model& model, const std::vector<model::ContactRecord>& contacts) {
  ContactSummary summary;
  int n_slipping = 0;
  for (const model::ContactRecord& contact : contacts) {
    const double diameter = std::min(diameter_of(model, contact.first_yarn, contact.first_place),
                                     diameter_of(model, contact.second_yarn, contact.second_place));
    ++summary.contacts;
    n_slipping += contact.slips ? 1 : 0;
    summary.normal_force += contact.normal_force;
    summary.elastic_slip = std::max(summary.elastic_slip, contact.elastic_slip);
    if (diameter > 0) {
      summary.elastic_slip_ratio = std::max(summary.elastic_slip_ratio, contact.elastic_slip / diameter);
    }
  }
  if (summary.contacts > 0) {
    summary.slipping_share = static_cast<double>(n_slipping) / summary.contacts;
  }
  return summary;
}

}  // namespace knitmech::results
