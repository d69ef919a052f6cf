#include <gtest/gtest.h>

#include "contact/chord_contacts.h"

namespace knitmech::contact {
namespace {

ChordContact contact_of(std::int32_t first, std::int32_t second, Vector3 normal, double elastic_slip) {
  ChordContact contact{};
  contact.key = chord_key(first, second);
  contact.point.first = {first, 0.5};
  contact.point.second = {second, 0.5};
  contact.point.normal = normal;
  contact.point.stick.normal = normal;
  contact.point.stick.elastic_slip = {elastic_slip, 0, 0};
  return contact;
}

TEST(ChordContacts, GivenTheSameChords_ThenTheirMemoryIsKept) {
  const std::vector<ChordContact> before = {contact_of(3, 70, {0, 0, 1}, 1), contact_of(4, 90, {0, 0, 1}, 2)};
  std::vector<ChordContact> now = {contact_of(4, 90, {0, 0, 1}, 0)};
  recall(before, now);
  EXPECT_EQ(now[0].point.stick.elastic_slip.x, 2.0);
}

TEST(ChordContacts, GivenAContactThatSlidOnToTheNextChord_ThenItsMemoryIsFound) {
  const std::vector<ChordContact> before = {contact_of(4, 90, {0, 0, 1}, 1), contact_of(4, 92, {0, 0, -1}, 2)};
  std::vector<ChordContact> now = {contact_of(4, 91, {0, 0, 1}, 0)};
  recall(before, now);
  EXPECT_EQ(now[0].point.stick.elastic_slip.x, 1.0);  // (4, 92) presses the other way: another contact
}

TEST(ChordContacts, GivenANewContactFarFromOthers_ThenItRemembersNothing) {
  const std::vector<ChordContact> before = {contact_of(4, 90, {0, 0, 1}, 1)};
  std::vector<ChordContact> now = {contact_of(4, 95, {0, 0, 1}, 0)};
  recall(before, now);
  EXPECT_EQ(now[0].point.stick.elastic_slip.x, 0.0);
}

TEST(ChordContacts, GivenAContactThatStaysWhereItWas_ThenTheOneBesideItDoesNotTakeItsMemory) {
  const std::vector<ChordContact> before = {contact_of(4, 90, {0, 0, 1}, 1)};
  std::vector<ChordContact> now = {contact_of(4, 90, {0, 0, 1}, 0), contact_of(4, 91, {0, 0, 1}, 0)};
  recall(before, now);
  EXPECT_EQ(now[0].point.stick.elastic_slip.x, 1.0);
  EXPECT_EQ(now[1].point.stick.elastic_slip.x, 0.0);
}

}  // namespace
}  // namespace knitmech::contact
