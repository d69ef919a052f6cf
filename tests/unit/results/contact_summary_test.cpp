#include "results/contact_summary.h"

#include <gtest/gtest.h>

#include "sample_run.h"

namespace knitmech::results {
namespace {

TEST(ContactSummary, AddsUpForcesCountsWhatSlipsAndFindsTheLargestElasticSlip) {
  // Given four contacts of yarns of 0.12 mm (yarn 0) and 0.2 mm (yarn 1) diameter, one of which slips.
  const model::Model model = test::two_yarn_model();
  const std::vector<model::ContactRecord> contacts{
      {.first_yarn = 0, .second_yarn = 1, .normal_force = 0.5, .elastic_slip = 0.0006},
      {.first_yarn = 1, .second_yarn = 1, .normal_force = 0.25, .elastic_slip = 0.0008},
      {.first_yarn = 1, .second_yarn = 0, .normal_force = 0.125, .elastic_slip = 0.0003, .slips = true},
      {.first_yarn = 0, .second_yarn = 0, .normal_force = 0.125}};
  // When they are summed up.
  const ContactSummary summary = summarise_contacts(model, contacts);
  // Then the largest elastic slip is the second one's, but the first one's, 0.0006 mm on 0.12 mm, is the larger share.
  EXPECT_EQ(summary.contacts, 4);
  EXPECT_EQ(summary.normal_force, 1.0);
  EXPECT_EQ(summary.slipping_share, 0.25);
  EXPECT_EQ(summary.elastic_slip, 0.0008);
  EXPECT_DOUBLE_EQ(summary.elastic_slip_ratio, 0.005);
}

TEST(ContactSummary, WithoutContactsThereIsNoShareThatSlips) {
  const ContactSummary summary = summarise_contacts(test::two_yarn_model(), {});
  EXPECT_EQ(summary.contacts, 0);
  EXPECT_EQ(summary.normal_force, 0.0);
  EXPECT_FALSE(summary.slipping_share.has_value());
  EXPECT_EQ(summary.elastic_slip_ratio, 0.0);
}

}  // namespace
}  // namespace knitmech::results
