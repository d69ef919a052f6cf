#include "results/node_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sample_run.h"

namespace knitmech::results {
namespace {

using testing::ElementsAre;

// Two yarns of 3 and 4 nodes; the last entry of each is unused and must not be seen, so it is not zero here.
const std::vector<double> kElementValues{2, 4, 99, 1, 3, 7, 99};

TEST(NodeValues, ANodeGetsTheMeanOfItsElementsAndAnEndItsOnlyOne) {
  EXPECT_THAT(average_to_nodes(test::two_yarn_model(), kElementValues), ElementsAre(2, 3, 4, 1, 2, 5, 7));
}

TEST(NodeValues, ElementsOnlyLeavesOutTheUnusedEntries) {
  EXPECT_THAT(elements_only(test::two_yarn_model(), kElementValues), ElementsAre(2, 4, 1, 3, 7));
}

TEST(NodeValues, AYarnOfOneNodeHasNoElement) {
  model::Model model;
  model.nodes = {Eigen::Vector3d::Zero()};
  model.yarns = {{.first_node = 0, .n_nodes = 1}};
  EXPECT_THAT(average_to_nodes(model, {99}), ElementsAre(0));
  EXPECT_TRUE(elements_only(model, {99}).empty());
}

}  // namespace
}  // namespace knitmech::results
