#include "contact/pair_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../../support/beam_case.h"

namespace knitmech::contact {
namespace {

using testing::ElementsAre;

/// Ten elements of one yarn; only their numbers matter here.
ContactElements ten_elements() {
  model::Model model =
      test::yarns_through({test::straight({0, 0, 0}, {10, 0, 0}, 10)}, test::section(19, 6, 0.017, 0.012, 1e-11, 0.12));
  model.centreline = model::Centreline::chords;
  return make_contact_elements(model);
}

TEST(PairWatch, GivenAYarnThatMovesInOnePlace_ThenOnlyThePairsThereAreLookedAt) {
  // Given pairs that were found to be 0.5 mm apart when all were looked at.
  const ContactElements elements = ten_elements();
  Motion motion(11);
  PairWatch watch;
  watch.renew(std::vector<char>(11, 1), {{0, 4}, {1, 5}, {2, 8}, {3, 9}});
  std::vector<std::int32_t> looked;
  const auto look = [&](ElementPair pair) {
    looked.push_back(pair.first);
    return 0.5;
  };
  watch.look_at_all(elements, 0, motion, look);
  EXPECT_THAT(looked, ElementsAre(0, 1, 2, 3));
  looked.clear();
  // When node 8 moves, and with it elements 7 and 8, first by less than that and then beyond it.
  std::vector<double> moved(11, 0.0);
  const std::vector<double> still = moved;
  moved[8] = 0.375;
  motion.add(moved, still, 0);
  watch.look_at_all(elements, 0, motion, look);
  EXPECT_THAT(looked, ElementsAre());
  motion.add(moved, still, 0);
  watch.look_at_all(elements, 0, motion, look);
  // Then of all pairs only that of element 8 is looked at.
  EXPECT_THAT(looked, ElementsAre(2));
}

}  // namespace
}  // namespace knitmech::contact
