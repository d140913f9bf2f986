#include "core/cad/kernel/opencascade/whole_splines.hpp"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomConvert.hxx>
#include <GeomConvert_BSplineSurfaceToBezierSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace hariko {

namespace {

/// Tolerance of parameters on the border, relative to the rectangle's sides.
constexpr double on_border = 1e-6;

struct Rectangle {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  double width() const { return u1 - u0; }
  double height() const { return v1 - v0; }
};

/// Whether the edge lies on one side of the rectangle.
bool along_side(const TopoDS_Edge& edge, const TopoDS_Face& face, const Rectangle& rectangle) {
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull() || !std::isfinite(first) || !std::isfinite(last)) return false;
  std::array<double, 4> farthest{};
  constexpr int steps = 8;
  for (int k = 0; k <= steps; ++k) {
    const gp_Pnt2d at = curve->Value(first + (last - first) * k / steps);
    const std::array<double, 4> away{std::abs(at.X() - rectangle.u0) / rectangle.width(),
                                     std::abs(at.X() - rectangle.u1) / rectangle.width(),
                                     std::abs(at.Y() - rectangle.v0) / rectangle.height(),
                                     std::abs(at.Y() - rectangle.v1) / rectangle.height()};
    for (std::size_t i = 0; i < 4; ++i) farthest[i] = std::max(farthest[i], away[i]);
  }
  return *std::min_element(farthest.begin(), farthest.end()) <= on_border;
}

/// Parameter rectangle of a face; nothing where its border leaves the sides.
std::optional<Rectangle> rectangle_of(const TopoDS_Face& face) {
  int wires = 0;
  for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next()) ++wires;
  if (wires != 1) return {};
  Rectangle out;
  BRepTools::UVBounds(face, out.u0, out.u1, out.v0, out.v1);
  if (!(out.width() > 0) || !(out.height() > 0) || !std::isfinite(out.width()) ||
      !std::isfinite(out.height()))
    return {};
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
    if (!along_side(TopoDS::Edge(edge.Current()), face, out)) return {};
  return out;
}

Handle(Geom_BSplineSurface) spline_of(const TopoDS_Face& face) {
  Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface); !trimmed.IsNull())
    surface = trimmed->BasisSurface();
  if (surface.IsNull() || !(surface->IsKind(STANDARD_TYPE(Geom_BSplineSurface)) ||
                            surface->IsKind(STANDARD_TYPE(Geom_BezierSurface))))
    return {};
  const Handle(Geom_BSplineSurface) spline = GeomConvert::SurfaceToBSplineSurface(surface);
  if (spline.IsNull() || spline->UDegree() > max_bezier_degree || spline->VDegree() > max_bezier_degree)
    return {};
  if (spline->IsUPeriodic()) spline->SetUNotPeriodic();
  if (spline->IsVPeriodic()) spline->SetVNotPeriodic();
  return spline;
}

/// Snaps bounds that equal those of the spline but for rounding; false where the rectangle leaves the spline.
bool fits(Rectangle& rectangle, const Geom_BSplineSurface& spline) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  spline.Bounds(u0, u1, v0, v1);
  const auto snap = [](double& low, double& high, double least, double most) {
    const double near = on_border * (high - low);
    if (std::abs(low - least) <= near) low = least;
    if (std::abs(high - most) <= near) high = most;
    return low >= least && high <= most && low < high;
  };
  return snap(rectangle.u0, rectangle.u1, u0, u1) && snap(rectangle.v0, rectangle.v1, v0, v1);
}

BezierPatch patch_of(const Geom_BezierSurface& surface) {
  BezierPatch out;
  out.degree_s = surface.UDegree();
  out.degree_t = surface.VDegree();
  const bool rational = surface.IsURational() || surface.IsVRational();
  for (int j = 1; j <= surface.NbVPoles(); ++j)
    for (int i = 1; i <= surface.NbUPoles(); ++i) {
      const gp_Pnt p = surface.Pole(i, j);
      out.points.push_back({p.X(), p.Y(), p.Z()});
      if (rational) out.weights.push_back(surface.Weight(i, j));
    }
  return out;
}

}  // namespace

std::vector<BezierPatch> whole_spline(const TopoDS_Face& face) {
  const Handle(Geom_BSplineSurface) spline = spline_of(face);
  if (spline.IsNull()) return {};
  std::optional<Rectangle> rectangle = rectangle_of(face);
  if (!rectangle || !fits(*rectangle, *spline)) return {};
  GeomConvert_BSplineSurfaceToBezierSurface pieces(spline, rectangle->u0, rectangle->u1, rectangle->v0,
                                                   rectangle->v1, 1e-12);
  std::vector<BezierPatch> out;
  for (int j = 1; j <= pieces.NbVPatches(); ++j)
    for (int i = 1; i <= pieces.NbUPatches(); ++i) {
      BezierPatch patch = patch_of(*pieces.Patch(i, j));
      if (check_patch(patch, 0)) return {};
      out.push_back(face.Orientation() == TopAbs_REVERSED ? flipped(patch) : std::move(patch));
    }
  return out;
}

}  // namespace hariko
