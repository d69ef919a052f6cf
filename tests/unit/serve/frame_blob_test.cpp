#include "serve/frame_blob.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "results/read_frame.h"
#include "results/read_run.h"
#include "runs_fixture.h"

namespace knitmech::serve {
namespace {

using testing::ElementsAre;

class FrameBlob : public RunsTest {
 protected:
  FrameBlob() {
    wait_for_end(runs_, runs_.start(case_text("0.25", "[0.1]"), "run"));
    stored_ = results::read_run(root_ / "run");
  }

  Runs runs_{root_, kQuick};
  results::StoredRun stored_;
};

void expect_same(const std::vector<float>& got, const std::vector<double>& wanted, double factor = 1) {
  ASSERT_EQ(got.size(), wanted.size());
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(got[i], static_cast<float>(factor * wanted[i])) << i;
}

std::vector<double> flat(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<double> all;
  for (const Eigen::Vector3d& vector : vectors) all.insert(all.end(), vector.begin(), vector.end());
  return all;
}

std::vector<double> norms(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<double> all;
  all.reserve(vectors.size());
  for (const Eigen::Vector3d& vector : vectors) all.push_back(std::hypot(vector.x(), vector.y(), vector.z()));
  return all;
}

TEST_F(FrameBlob, GivenAStoredFrame_ThenItsNumbersAreThoseOfTheFilesInSinglePrecision) {
  const model::Frame frame = results::read_frame(stored_, 2);
  const ReadBlob blob(runs_.frame_blob("run", 2));
  EXPECT_EQ(blob.head().at("index"), 2);
  EXPECT_EQ(blob.head().at("live"), 0);
  EXPECT_EQ(blob.head().at("strain"), frame.history.strain);
  EXPECT_EQ(blob.head().at("force"), frame.history.force_top);
  expect_same(blob.floats("positions"), flat(frame.points));
  expect_same(blob.floats("axial_force"), frame.axial_force);
  expect_same(blob.floats("shear_force"), frame.shear_force);
  expect_same(blob.floats("bending_moment"), frame.bending_moment);
  expect_same(blob.floats("torque"), frame.torque);
  expect_same(blob.floats("axial_strain"), frame.axial_strain, 100);
  expect_same(blob.floats("curvature"), frame.curvature);
  expect_same(blob.floats("contact_force"), norms(frame.contact_force));
  ASSERT_EQ(blob.floats("out_of_plane").size(), frame.points.size());
  EXPECT_EQ(blob.floats("out_of_plane")[5], static_cast<float>(frame.points[5].z()));
}

TEST_F(FrameBlob, GivenContacts_ThenEachIsThere) {
  const model::Frame frame = results::read_frame(stored_, 2);
  const ReadBlob blob(runs_.frame_blob("run", 2));
  ASSERT_FALSE(frame.contacts.empty());
  ASSERT_EQ(blob.head().at("contacts"), frame.contacts.size());
  for (std::size_t i = 0; i < frame.contacts.size(); ++i) {
    const model::ContactRecord& contact = frame.contacts[i];
    EXPECT_EQ(blob.floats("contact_positions")[3 * i + 2], static_cast<float>(contact.position.z()));
    EXPECT_EQ(blob.floats("contact_normals")[3 * i + 1], static_cast<float>(contact.normal.y()));
    EXPECT_EQ(blob.floats("contact_normal_force")[i], static_cast<float>(contact.normal_force));
    EXPECT_EQ(blob.floats("contact_friction")[i], static_cast<float>(contact.friction_force.norm()));
    EXPECT_EQ(blob.floats("contact_gap")[i], static_cast<float>(contact.gap));
    EXPECT_EQ(blob.floats("contact_slip")[i], static_cast<float>(contact.slip));
    EXPECT_EQ(blob.integers("contact_slips")[i], contact.slips ? 1 : 0);
    EXPECT_EQ(blob.integers("contact_yarns")[2 * i], contact.first_yarn);
    EXPECT_EQ(blob.integers("contact_yarns")[2 * i + 1], contact.second_yarn);
    EXPECT_EQ(blob.floats("contact_places")[2 * i + 1], static_cast<float>(contact.second_place));
  }
}

TEST_F(FrameBlob, GivenTheFields_ThenEachTellsLabelUnitAndARangeThatHoldsItsValues) {
  const ReadBlob blob(runs_.frame_blob("run", 2));
  std::vector<std::string> names;
  for (const Json& field : blob.head().at("fields")) {
    names.push_back(field.at("name"));
    EXPECT_FALSE(field.at("label").get<std::string>().empty());
    EXPECT_FALSE(field.at("unit").get<std::string>().empty());
    EXPECT_LT(field.at("lowest"), field.at("highest"));
    for (const float value : blob.floats(names.back())) {
      EXPECT_LE(field.at("lowest").get<double>(), value + 1e-12) << names.back();
      EXPECT_GE(field.at("highest").get<double>(), value - 1e-12) << names.back();
    }
  }
  EXPECT_THAT(names, ElementsAre("axial_force", "shear_force", "bending_moment", "torque", "axial_strain", "curvature",
                                 "contact_force", "out_of_plane"));
}

TEST_F(FrameBlob, GivenTheModel_ThenItIsTheFreeFabricWithItsYarns) {
  const ReadBlob blob(runs_.model_blob("run"));
  expect_same(blob.floats("positions"), flat(stored_.model.nodes));
  expect_same(blob.floats("arc_length"), stored_.model.arc_length);
  EXPECT_EQ(blob.integers("course"), stored_.model.course);
  EXPECT_EQ(blob.integers("wale"), stored_.model.wale);
  EXPECT_EQ(blob.head().at("title"), "Small");
  EXPECT_EQ(blob.head().at("diameter"), 0.12);
  EXPECT_TRUE(blob.head().at("edge_diameter").is_null());
  ASSERT_EQ(blob.head().at("yarns").size(), 2U);
  EXPECT_EQ(blob.head().at("yarns")[1].at("first_node"), stored_.model.yarns[1].first_node);
}

TEST_F(FrameBlob, GivenAYarnThatIsScattered_ThenItsPlacesAreNoNumbersAndTheHeadStaysSound) {
  model::Frame frame = results::read_frame(stored_, 1);
  for (Eigen::Vector3d& point : frame.points) point.setConstant(std::nan(""));
  frame.history.strain = std::nan("");
  frame.broken = {3, 4};
  const ReadBlob blob(frame_blob(stored_.model, frame, 5));
  EXPECT_TRUE(blob.head().at("strain").is_null());
  EXPECT_TRUE(blob.head().at("index").is_null());
  EXPECT_EQ(blob.head().at("live"), 5);
  EXPECT_TRUE(std::isnan(blob.floats("positions")[0]));
  EXPECT_THAT(blob.integers("broken"), ElementsAre(3, 4));
  for (const Json& field : blob.head().at("fields")) EXPECT_TRUE(field.at("highest").is_number()) << field;
}

}  // namespace
}  // namespace knitmech::serve
