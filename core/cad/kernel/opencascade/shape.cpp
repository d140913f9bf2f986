#include "core/cad/kernel/opencascade/shape.hpp"

#include <BRep_Builder.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <map>

#include "core/cad/cad_shells.hpp"

namespace hariko {

namespace {

/// Tolerance that the kernel treats as equality, millimetres; no edge or vertex has a smaller one.
constexpr double least_tolerance = 1e-7;

struct Knots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;
  explicit Knots(const SplineSpace& space)
      : values(1, int(space.breaks.size())), multiplicities(1, int(space.breaks.size())) {
    for (std::size_t i = 0; i < space.breaks.size(); ++i) {
      values.SetValue(int(i) + 1, space.breaks[i]);
      const bool end = i == 0 || i + 1 == space.breaks.size();
      multiplicities.SetValue(int(i) + 1, end ? space.degree + 1 : 1);
    }
  }
};

class ShapeMaker {
 public:
  explicit ShapeMaker(const CadModel& model) : model_(model) {}

  TopoDS_Shape run(CadFileReport& report) {
    make_vertices();
    for (const CadEdge& edge : model_.edges) edges_.push_back(make(edge));
    for (Index f = 0; f < model_.faces.size(); ++f) faces_.push_back(make(f));
    report.faces += faces_.size();
    const std::vector<TopoDS_Shape> bodies = make_bodies(report);
    if (bodies.size() == 1) return bodies.front();
    TopoDS_Compound compound;
    builder_.MakeCompound(compound);
    for (const TopoDS_Shape& body : bodies) builder_.Add(compound, body);
    return compound;
  }

 private:
  gp_Pnt point(const Vector3& p) const {
    const Vector3 at = model_.origin + p;
    return {at.x(), at.y(), at.z()};
  }

  void make_vertices() {
    std::vector<double> tolerance(model_.vertices.size(), least_tolerance);
    for (const CadEdge& edge : model_.edges)
      for (const Index v : {edge.begin, edge.end}) tolerance[v] = std::max(tolerance[v], tolerance_of(edge));
    for (std::size_t v = 0; v < model_.vertices.size(); ++v) {
      TopoDS_Vertex vertex;
      builder_.MakeVertex(vertex, point(model_.vertices[v]), tolerance[v]);
      vertices_.push_back(vertex);
    }
  }

  static double tolerance_of(const CadEdge& edge) { return std::max(least_tolerance, 1.5 * edge.deviation); }

  TopoDS_Edge make(const CadEdge& edge) {
    TopoDS_Edge out;
    const double span = edge.curve.space.end();
    if (edge.degenerate) {
      builder_.MakeEdge(out);
      builder_.Degenerated(out, true);
    } else {
      TColgp_Array1OfPnt poles(1, int(edge.curve.points.size()));
      for (std::size_t i = 0; i < edge.curve.points.size(); ++i)
        poles.SetValue(int(i) + 1, point(edge.curve.points[i]));
      const Knots knots(edge.curve.space);
      const Handle(Geom_BSplineCurve) curve =
          new Geom_BSplineCurve(poles, knots.values, knots.multiplicities, edge.curve.space.degree);
      builder_.MakeEdge(out, curve, tolerance_of(edge));
      builder_.Range(out, 0, span);
    }
    builder_.Add(out, vertices_[edge.begin].Oriented(TopAbs_FORWARD));
    builder_.Add(out, vertices_[edge.end].Oriented(TopAbs_REVERSED));
    return out;
  }

  /// Curve of an edge in the face's parameters, over the edge's own parameter.
  Handle(Geom2d_Curve) image(const CadEdge& edge, std::size_t use_number) const {
    const CadUse& use = edge.uses[use_number];
    const CadPiece& piece = model_.pieces[use.piece];
    const Vector2 from = piece.parameter(use.side, use_number == 0 ? use.begin : use.end);
    const Vector2 to = piece.parameter(use.side, use_number == 0 ? use.end : use.begin);
    const double span = edge.curve.space.end(), length = (to - from).norm();
    if (length == span) {
      const Vector2 along = (to - from) / length;
      return new Geom2d_Line(gp_Pnt2d(from.x(), from.y()), gp_Dir2d(along.x(), along.y()));
    }
    TColgp_Array1OfPnt2d poles(1, 2);
    poles.SetValue(1, gp_Pnt2d(from.x(), from.y()));
    poles.SetValue(2, gp_Pnt2d(to.x(), to.y()));
    const Knots knots(SplineSpace{1, {0, span}});
    return new Geom2d_BSplineCurve(poles, knots.values, knots.multiplicities, 1);
  }

  TopoDS_Face make(Index number) {
    const CadFace& face = model_.faces[number];
    const SplineSurface& spline = face.surface;
    TColgp_Array2OfPnt poles(1, int(spline.s.size()), 1, int(spline.t.size()));
    for (std::size_t j = 0; j < spline.t.size(); ++j)
      for (std::size_t i = 0; i < spline.s.size(); ++i)
        poles.SetValue(int(i) + 1, int(j) + 1, point(spline.points[spline.index(i, j)]));
    const Knots s(spline.s), t(spline.t);
    const Handle(Geom_BSplineSurface) surface = new Geom_BSplineSurface(
        poles, s.values, t.values, s.multiplicities, t.multiplicities, spline.s.degree, spline.t.degree);
    TopoDS_Face out;
    builder_.MakeFace(out, surface, TopLoc_Location(), least_tolerance);
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (int side = 0; side < 4; ++side)
      for (const Index e : face.sides[std::size_t(side)]) {
        const CadEdge& edge = model_.edges[e];
        const bool first = edge.uses[0].piece == number && edge.uses[0].side == side;
        const bool both = edge.use_count == 2 && edge.uses[0].piece == edge.uses[1].piece;
        if (!both)
          builder_.UpdateEdge(edges_[e], image(edge, first ? 0 : 1), out, tolerance_of(edge));
        else if (first)  // along an edge where the face meets itself both curves are set at once
          builder_.UpdateEdge(edges_[e], image(edge, 0), image(edge, 1), out, tolerance_of(edge));
        if (edge.degenerate) builder_.Range(edges_[e], out, 0, edge.curve.space.end());
        builder_.Add(wire, edges_[e].Oriented(first ? TopAbs_FORWARD : TopAbs_REVERSED));
      }
    wire.Closed(true);
    builder_.Add(out, wire);
    builder_.NaturalRestriction(out, true);
    return out;
  }

  TopoDS_Shell make(const CadShell& shell) {
    TopoDS_Shell out;
    builder_.MakeShell(out);
    for (const Index f : shell.faces) builder_.Add(out, faces_[f]);
    out.Closed(shell.closed);
    return out;
  }

  std::vector<TopoDS_Shape> make_bodies(CadFileReport& report) {
    const std::vector<CadShell> shells = cad_shells(model_);
    std::map<Index, TopoDS_Solid> solids;
    for (Index k = 0; k < shells.size(); ++k)
      if (shells[k].closed && shells[k].hollows == no_index) {
        builder_.MakeSolid(solids[k]);
        builder_.Add(solids[k], make(shells[k]));
      }
    for (const CadShell& shell : shells)
      if (shell.hollows != no_index) {
        builder_.Add(solids.at(shell.hollows), make(shell));
        ++report.voids;
      }
    std::vector<TopoDS_Shape> out;
    for (Index k = 0; k < shells.size(); ++k) {
      const auto solid = solids.find(k);
      if (solid != solids.end()) {
        if (shells[k].volume < 0) solid->second.Reverse();
        ++report.solids;
        out.push_back(solid->second);
      } else if (!shells[k].closed) {
        ++report.open_shells;
        out.push_back(make(shells[k]));
      }
    }
    return out;
  }

  const CadModel& model_;
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<TopoDS_Edge> edges_;
  std::vector<TopoDS_Face> faces_;
};

}  // namespace

TopoDS_Shape shape_of(const CadModel& model, CadFileReport& report) {
  return ShapeMaker(model).run(report);
}

}  // namespace hariko
