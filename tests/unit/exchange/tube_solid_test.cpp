#include "exchange/tube_solid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <limits>
#include <numbers>
#include <sstream>

#include "base/errors.h"
#include "deck_models.h"
#include "exchange/tube_files.h"
#include "yarn_rows.h"

// Open CASCADE integrates, measures and reads back here; the references are closed formulas.
namespace knitmech::exchange {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

double volume(const TopoDS_Shape& solid) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties, 1e-8);
  return properties.Mass();
}

double area(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties, 1e-8);
  return properties.Mass();
}

std::vector<TopoDS_Shape> parts(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  std::vector<TopoDS_Shape> found;
  for (TopExp_Explorer each(shape, kind); each.More(); each.Next()) found.push_back(each.Current());
  return found;
}

TEST(TubeSolid, GivenAStraightYarn_ThenItIsTheCylinder) {
  const TopoDS_Solid solid = tube_solid(straight_pieces());
  EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  EXPECT_EQ(parts(solid, TopAbs_FACE).size(), 3U);
  EXPECT_NEAR(volume(solid), pi * 0.01 * 6, 1e-9);
  EXPECT_NEAR(area(solid), 2 * pi * 0.1 * 6 + 2 * pi * 0.01, 1e-8);
}

// Pappus: the section times the length of the helix. Twelve elements a turn bend as much as those of a coarse loop.
TEST(TubeSolid, GivenAHelix_ThenItsVolumeAndAreaAreThoseOfPappus) {
  constexpr double kBend = 1, kClimb = 0.3, kRadius = 0.1;
  const double length = 2 * pi * 3 * std::hypot(kBend, kClimb);
  const auto pieces = helix_pieces(kBend, kClimb, 3, kRadius, 12);
  const TopoDS_Solid solid = tube_solid(pieces);
  EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  EXPECT_NEAR(volume(solid) / (pi * kRadius * kRadius * length), 1, 2e-4);
  EXPECT_NEAR(area(solid) / (2 * pi * kRadius * length + 2 * pi * kRadius * kRadius), 1, 2e-4);
}

/// Distance from a point to the helix of helix_pieces(), by Newton's method from the angle of the point.
double distance_to_helix(const Vector3d& point, double bend, double climb) {
  double angle = std::atan2(point.y(), point.x());
  angle += 2 * pi * std::round((point.z() / climb - angle) / (2 * pi));
  const auto at = [&](double a) { return Vector3d(bend * std::cos(a), bend * std::sin(a), climb * a); };
  for (int i = 0; i < 20; ++i) {
    const Vector3d along(-bend * std::sin(angle), bend * std::cos(angle), climb);
    angle += (point - at(angle)).dot(along) / along.squaredNorm();
  }
  return (point - at(angle)).norm();
}

std::vector<Vector3d> points_of_wall(const TopoDS_Solid& solid) {
  std::vector<Vector3d> points;
  for (const TopoDS_Shape& face : parts(solid, TopAbs_FACE)) {
    const BRepAdaptor_Surface wall(TopoDS::Face(face));
    if (wall.GetType() != GeomAbs_BSplineSurface) continue;
    for (int i = 0; i < 12; ++i) {
      for (int k = 10; k <= 990; ++k) {  // away from the ends, where another point of the curve may be nearer
        const double u = wall.FirstUParameter() + (wall.LastUParameter() - wall.FirstUParameter()) * i / 12;
        const double v = wall.FirstVParameter() + (wall.LastVParameter() - wall.FirstVParameter()) * k / 1000;
        const gp_Pnt point = wall.Value(u, v);
        points.emplace_back(point.X(), point.Y(), point.Z());
      }
    }
  }
  return points;
}

TEST(TubeSolid, GivenAHelix_ThenItsWallIsOneYarnRadiusFromTheHelixAllAlong) {
  const auto pieces = helix_pieces(1, 0.3, 2, 0.1, 12);
  const std::vector<Vector3d> points = points_of_wall(tube_solid(pieces));
  ASSERT_GT(points.size(), 10000U);
  for (const Vector3d& point : points) ASSERT_NEAR(distance_to_helix(point, 1, 0.3), 0.1, 0.005 * 0.1);
}

/// Distance from a point to the chords between samples.
double distance_to(const std::vector<YarnSample>& samples, const Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Vector3d chord = samples[i].point - samples[i - 1].point, there = point - samples[i - 1].point;
    const double share = std::clamp(there.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (there - share * chord).norm());
  }
  return least;
}

TEST(TubeSolid, GivenAKnittedYarn_ThenItsWallIsOneYarnRadiusFromTheCentrelineAllAlong) {
  const model::Model fabric = model::build_model(fabric_case(2, 1));
  const std::vector<model::CurvePiece> pieces = model::yarn_curves(fabric);
  const std::vector<YarnSample> centreline = samples_of(pieces, 50);
  const std::vector<Vector3d> points = points_of_wall(tube_solid(pieces));
  ASSERT_GT(points.size(), 10000U);
  for (const Vector3d& point : points) ASSERT_NEAR(distance_to(centreline, point), 0.06, 0.02 * 0.06);
}

TEST(TubeSolid, GivenAYarnThatBendsMoreSharplyThanItIsThick_ThenItIsRefused) {
  const auto sharp = helix_pieces(0.09, 0.02, 0.5, 0.1);
  EXPECT_THAT([&] { (void)tube_solid(sharp); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("yarn 1 bends more sharply than it is thick")));
}

std::vector<std::string> product_names(const StepData_StepModel& model) {
  std::vector<std::string> names;
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const auto product = opencascade::handle<StepBasic_Product>::DownCast(model.Value(i));
    if (!product.IsNull()) names.emplace_back(product->Name()->ToCString());
  }
  return names;
}

/// Two yarns, the second of which has a break.
YarnTubes two_yarns() {
  YarnTubes tubes{.title = "Yarns's 2", .pieces = straight_pieces()};
  for (model::CurvePiece piece : helix_pieces(1, 0.3, 1, 0.1)) {
    piece.yarn = 1;
    piece.continues_piece_before = piece.node != 0 && piece.node != 7;
    tubes.pieces.push_back(piece);
  }
  return tubes;
}

TEST(StepText, GivenTubes_ThenAReaderFindsTheSameSolidsInMillimetresUnderTheirNames) {
  const YarnTubes tubes = two_yarns();
  std::istringstream text(step_text(tubes));
  STEPControl_Reader reader;
  ASSERT_EQ(reader.ReadStream("tubes.step", text), IFSelect_RetDone);
  EXPECT_THAT(product_names(*reader.StepModel()), testing::ElementsAre("Yarns's 2", "yarn 1", "yarn 2", "yarn 2"));
  ASSERT_EQ(reader.TransferRoots(), 1);
  const std::vector<TopoDS_Shape> solids = parts(reader.OneShape(), TopAbs_SOLID);
  const std::vector<YarnRow> rows = tube_rows(tubes.pieces);
  ASSERT_EQ(solids.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(BRepCheck_Analyzer(solids[i]).IsValid());
    EXPECT_NEAR(volume(solids[i]), volume(tube_solid(rows[i])), 1e-8);
  }
}

TEST(StepText, GivenAFabricThatWouldFillTheMemory_ThenItIsRefusedAtOnce) {
  YarnTubes tubes;
  tubes.pieces.resize(400000, straight_pieces().front());
  EXPECT_THAT([&] { (void)step_text(tubes); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("1000000 are the most")));
}

TEST(StepText, GivenTheSameTubes_ThenTheBytesAreTheSameAndNothingIsPrinted) {
  testing::internal::CaptureStdout();
  const std::string first = step_text(two_yarns()), second = step_text(two_yarns());
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_TRUE(first == second);
  EXPECT_THAT(first, testing::StartsWith("ISO-10303-21;"));
  EXPECT_THAT(first, testing::HasSubstr("FILE_NAME('Yarns''s 2','',"));  // no date
}

// ISO 10303-21, 6.4.3: letters outside of ASCII are their numbers between \X2\, or \X4\, and \X0\.
TEST(StepText, GivenATitleWithUmlauts_ThenTheFileIsAsciiAndNamesThem) {
  YarnTubes tubes = two_yarns();
  tubes.title = "Prüfung \\ 😀";
  const std::string text = step_text(tubes);
  const auto is_ascii = [](char letter) { return letter == '\n' || (letter >= ' ' && letter <= '~'); };
  EXPECT_TRUE(std::ranges::all_of(text, is_ascii));
  EXPECT_THAT(text, testing::HasSubstr("'Pr\\X2\\00FC\\X0\\fung \\\\ \\X4\\0001F600\\X0\\'"));
}

}  // namespace
}  // namespace knitmech::exchange
