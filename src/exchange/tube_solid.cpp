#include "exchange/tube_solid.h"

#include <fmt/format.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GeomAPI_Interpolate.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>
#include <numbers>

#include "base/errors.h"
#include "exchange/constants.h"

namespace knitmech::exchange {
namespace {

using Eigen::Vector3d;
using Spline = opencascade::handle<Geom_BSplineCurve>;

gp_Pnt point_of(const Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

gp_Dir direction_of(const Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

struct Sections {
  std::vector<YarnSample> samples;
  std::vector<Vector3d> axes;   ///< across, unit
  std::vector<double> lengths;  ///< of the chords up to each section [mm]
};

Sections sections_of(YarnRow row) {
  Sections sections;
  sections.samples = samples_of(row, kSolidStepsPerElement);
  const std::vector<YarnSample>& samples = sections.samples;
  sections.axes.push_back(samples.front().tangent.unitOrthogonal());
  sections.lengths.push_back(0);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    sections.axes.push_back(carried_across(sections.axes.back(), samples[i - 1], samples[i]));
    sections.lengths.push_back(sections.lengths.back() + (samples[i].point - samples[i - 1].point).norm());
  }
  return sections;
}

/// The cubic spline through a point at each section, over the length.
template <class PointAt>
Spline spline_through(const Sections& sections, const PointAt& point_at) {
  const int n = static_cast<int>(sections.samples.size());
  const opencascade::handle<TColgp_HArray1OfPnt> points(new TColgp_HArray1OfPnt(1, n));
  const opencascade::handle<TColStd_HArray1OfReal> lengths(new TColStd_HArray1OfReal(1, n));
  for (std::size_t i = 0; i < sections.samples.size(); ++i) {
    points->SetValue(static_cast<int>(i) + 1, point_of(point_at(i)));
    lengths->SetValue(static_cast<int>(i) + 1, sections.lengths[i]);
  }
  GeomAPI_Interpolate interpolation(points, lengths, false, kSolidTolerance);
  interpolation.Perform();
  if (!interpolation.IsDone()) throw InputError("step: there is no smooth curve through the nodes of a yarn");
  return interpolation.Curve();
}

Spline unit_circle() {
  const gp_Ax2 plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  const opencascade::handle<Geom_TrimmedCurve> round =
      new Geom_TrimmedCurve(new Geom_Circle(plane, 1), 0, 2 * std::numbers::pi);
  return GeomConvert::CurveToBSplineCurve(round, Convert_RationalC1);
}

struct KnotsOfSpline {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;
  explicit KnotsOfSpline(const Spline& spline) : values(1, spline->NbKnots()), multiplicities(1, spline->NbKnots()) {
    spline->Knots(values);
    spline->Multiplicities(multiplicities);
  }
};

/// The circle, moved along the splines of its centre and of two points a quarter of a turn apart on it: its poles, put
/// together of theirs, for a section with its weights is the same combination of these three points everywhere. All
/// three move on from section to section, as Open CASCADE wants of points of a curve; the axes of a straight yarn would
/// not.
opencascade::handle<Geom_BSplineSurface> wall_surface(const Sections& sections, double radius) {
  const auto place = [&](std::size_t i) -> const Vector3d& { return sections.samples[i].point; };
  const auto other_axis = [&](std::size_t i) { return sections.samples[i].tangent.cross(sections.axes[i]); };
  const Spline centre = spline_through(sections, place);
  const Spline across =
      spline_through(sections, [&](std::size_t i) -> Vector3d { return place(i) + radius * sections.axes[i]; });
  const Spline other =
      spline_through(sections, [&](std::size_t i) -> Vector3d { return place(i) + radius * other_axis(i); });
  const Spline section = unit_circle();
  TColgp_Array2OfPnt poles(1, section->NbPoles(), 1, centre->NbPoles());
  TColStd_Array2OfReal weights(1, section->NbPoles(), 1, centre->NbPoles());
  for (int i = 1; i <= section->NbPoles(); ++i) {
    for (int k = 1; k <= centre->NbPoles(); ++k) {
      const gp_XYZ middle = centre->Pole(k).XYZ();
      poles(i, k) = gp_Pnt(middle + (across->Pole(k).XYZ() - middle) * section->Pole(i).X() +
                           (other->Pole(k).XYZ() - middle) * section->Pole(i).Y());
      weights(i, k) = section->Weight(i);
    }
  }
  const KnotsOfSpline around(section), along(centre);
  return new Geom_BSplineSurface(poles, weights, around.values, along.values, around.multiplicities,
                                 along.multiplicities, section->Degree(), centre->Degree());
}

/// The flat end at a section.
TopoDS_Face end_face(const TopoDS_Edge& edge, const YarnSample& section) {
  TopoDS_Wire wire;
  const BRep_Builder builder;
  builder.MakeWire(wire);
  builder.Add(wire, edge);
  wire.Closed(true);
  return BRepBuilderAPI_MakeFace(gp_Pln(point_of(section.point), direction_of(section.tangent)), wire).Face();
}

/// The faces of a tube: its wall, and an end at each edge of the wall that is not its seam.
std::vector<TopoDS_Face> faces_of(const Sections& sections, double radius) {
  const TopoDS_Face wall = BRepBuilderAPI_MakeFace(wall_surface(sections, radius), kSolidTolerance).Face();
  std::vector<TopoDS_Face> faces{wall};
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(wall, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i));
    if (BRep_Tool::IsClosed(edge, wall)) continue;
    const gp_Pnt place = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
    const auto distance = [&](const YarnSample& section) { return place.Distance(point_of(section.point)); };
    const YarnSample &first = sections.samples.front(), &last = sections.samples.back();
    faces.push_back(end_face(edge, distance(first) < distance(last) ? first : last));
  }
  return faces;
}

/// Whether the wall would fold over itself: where the radius of the yarn is more than that of its bend.
bool folds(const Sections& sections, double radius) {
  for (std::size_t i = 1; i < sections.samples.size(); ++i) {
    const YarnSample &from = sections.samples[i - 1], &to = sections.samples[i];
    if (radius * (to.tangent - from.tangent).norm() > (to.point - from.point).norm()) return true;
  }
  return false;
}

}  // namespace

TopoDS_Solid tube_solid(YarnRow row) {
  const double radius = row.front().radius;
  const Sections sections = sections_of(row);
  if (folds(sections, radius)) {
    throw InputError(
        fmt::format("step: yarn {} bends more sharply than it is thick, and no solid has such a wall; take -f gltf or "
                    "-f vtp",
                    row.front().yarn + 1));
  }
  BRepBuilderAPI_Sewing sewing(kSolidTolerance);
  for (const TopoDS_Face& face : faces_of(sections, radius)) sewing.Add(face);
  sewing.Perform();
  const TopoDS_Shape sewn = sewing.SewedShape();
  TopoDS_Solid solid;
  if (sewn.ShapeType() == TopAbs_SHELL) solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewn)).Solid();
  if (solid.IsNull() || !BRepLib::OrientClosedSolid(solid) || !BRepCheck_Analyzer(solid).IsValid()) {
    throw InputError(fmt::format("step: Open CASCADE makes no closed solid of yarn {}; take -f gltf or -f vtp",
                                 row.front().yarn + 1));
  }
  return solid;
}

}  // namespace knitmech::exchange
