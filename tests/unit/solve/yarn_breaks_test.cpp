#include "solve/yarn_breaks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "../../support/beam_case.h"
#include "solve/broken_yarns.h"

namespace knitmech::solve {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// Two yarns of four elements of 1 mm each, nodes 0 to 4 and 5 to 9; EA 20 N, rho A 2e-11 t/mm, strength 2 N.
model::Model two_yarns() {
  model::Model model =
      test::yarns_through({test::straight({0, 0, 0}, {4, 0, 0}, 4), test::straight({0, 10, 0}, {4, 10, 0}, 4)},
                          test::section(20, 8, 0.02, 0.015, 2e-11));
  model.strengths = {{0, 2.0}};
  return model;
}

/// Every element of 1 mm stretched to 1 + strain.
model::State stretched(const model::Model& model, double strain, double time) {
  model::State state = test::state_of(model);
  for (double& x : state.position.x) x *= 1 + strain;
  state.time = time;
  return state;
}

TEST(YarnBreaks, GivenAYarnOverloadedEverywhere_ThenItBreaksOnceAndOtherPlacesOnlyAfterTheUnloadingHasHadItsTime) {
  // c = sqrt(20 N / (2e-11 t/mm x scaling 4)) = 5e5 mm/s, so 2 d / c = 4 us for each millimetre.
  const model::Model model = two_yarns();
  YarnBreaks breaks(model, beam::make_elements(model, 4, 0), 4);
  EXPECT_NEAR(breaks.wave_speed(0), 5e5, 1e-6);
  const std::vector<std::size_t> first = breaks.find(stretched(model, 0.11, 1.0));
  ASSERT_THAT(first, UnorderedElementsAre(testing::Lt(5U), testing::Ge(5U)));  // one of each yarn
  EXPECT_THAT(breaks.find(stretched(model, 0.11, 1.0 + 3.9e-6)), IsEmpty());
  EXPECT_FALSE(breaks.find(stretched(model, 0.11, 1.0 + 4.1e-6)).empty());
}

TEST(YarnBreaks, GivenAnElementThatBroke_ThenItNeverBreaksAgain) {
  const model::Model model = two_yarns();
  YarnBreaks breaks(model, beam::make_elements(model, 1, 0), 1);
  std::vector<std::size_t> all;
  for (int second = 0; second < 10; ++second) {
    for (const std::size_t element : breaks.find(stretched(model, 0.2, second))) all.push_back(element);
  }
  EXPECT_THAT(all, UnorderedElementsAre(0, 1, 2, 3, 5, 6, 7, 8));
}

TEST(BrokenYarns, GivenCuts_ThenTheModelHasThePieces) {
  const model::Model model = two_yarns();
  BrokenYarns yarns(model);
  EXPECT_EQ(&yarns.model(), &model);
  yarns.cut({6});
  yarns.cut({0, 1});
  EXPECT_THAT(yarns.elements(), ElementsAre(0, 1, 6));
  const std::vector<model::ModelYarn>& pieces = yarns.model().yarns;
  ASSERT_EQ(pieces.size(), 5U);  // nodes 0; 1; 2 3 4; 5 6; 7 8 9
  constexpr std::array<int, 5> kFirstNode = {0, 1, 2, 5, 7};
  constexpr std::array<int, 5> kNodes = {1, 1, 3, 2, 3};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(pieces[i].first_node, kFirstNode[i]) << "piece " << i;
    EXPECT_EQ(pieces[i].n_nodes, kNodes[i]) << "piece " << i;
  }
  EXPECT_EQ(model.yarns.size(), 2U);
}

TEST(BrokenYarns, GivenContactsOfPieces_ThenTheyAreNamedByTheWholeYarns) {
  const model::Model model = two_yarns();
  BrokenYarns yarns(model);
  yarns.cut({1, 6});  // pieces: nodes 0 1; 2 3 4; 5 6; 7 8 9
  std::vector<model::ContactRecord> contacts(1);
  contacts[0].first_yarn = 1;
  contacts[0].first_place = 0.25;
  contacts[0].second_yarn = 2;
  contacts[0].second_place = 0.75;
  yarns.name_whole_yarns(contacts);
  EXPECT_EQ(contacts[0].first_yarn, 0);
  EXPECT_NEAR(contacts[0].first_place, 2.25, 1e-14);
  EXPECT_EQ(contacts[0].second_yarn, 1);
  EXPECT_NEAR(contacts[0].second_place, 0.75, 1e-14);
}

TEST(BrokenYarns, GivenAnEndThatRavels_ThenItIsAnEndOfTheYarnOrABrokenOne) {
  const model::Model model = two_yarns();
  BrokenYarns yarns(model);
  yarns.cut({6});  // pieces: nodes 0 to 4; 5 6; 7 8 9
  const auto of = [&](int piece, contact::YarnEnd end) {
    return yarns.ravelling_of({piece, end, 0, 1.5, Vector3{1, 2, 3}});
  };
  const model::Ravelling own = of(1, contact::YarnEnd::first_node);
  EXPECT_EQ(own.yarn, 1);
  EXPECT_FALSE(own.is_last_end);
  EXPECT_FALSE(own.broken_end.has_value());
  EXPECT_EQ(own.other_place, 1.5);
  EXPECT_EQ(of(1, contact::YarnEnd::last_node).broken_end, 6);
  EXPECT_EQ(of(2, contact::YarnEnd::first_node).broken_end, 7);
  EXPECT_TRUE(of(2, contact::YarnEnd::last_node).is_last_end);
  EXPECT_FALSE(of(2, contact::YarnEnd::last_node).broken_end.has_value());
}

}  // namespace
}  // namespace knitmech::solve
