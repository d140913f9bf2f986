#include "core/cad/kernel/opencascade/triangulated.hpp"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

/// Joins the triangles of a body's faces. Faces take the points along common edges from the edge, bit for bit
/// equal.
class Welder {
 public:
  explicit Welder(PolygonMesh& mesh) : mesh_(mesh) {}

  Index number(const gp_Pnt& point) {
    const std::array<double, 3> key{point.X() + 0.0, point.Y() + 0.0, point.Z() + 0.0};
    const auto [found, made] = numbers_.try_emplace(key, Index(mesh_.positions.size()));
    if (made) mesh_.positions.push_back({key[0], key[1], key[2]});
    return found->second;
  }

 private:
  PolygonMesh& mesh_;
  std::map<std::array<double, 3>, Index> numbers_;
};

/// Adds the triangles of a face; false where it has none.
bool add(const TopoDS_Face& face, Welder& welder, PolygonMesh& mesh) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
  if (triangles.IsNull() || triangles->NbTriangles() == 0) return false;
  std::vector<Index> numbers;
  for (int i = 1; i <= triangles->NbNodes(); ++i)
    numbers.push_back(welder.number(triangles->Node(i).Transformed(location.Transformation())));
  for (int i = 1; i <= triangles->NbTriangles(); ++i) {
    int a = 0, b = 0, c = 0;
    triangles->Triangle(i).Get(a, b, c);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
    const std::array<Index, 3> corners{numbers[std::size_t(a - 1)], numbers[std::size_t(b - 1)],
                                       numbers[std::size_t(c - 1)]};
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      mesh.add_face(corners);
  }
  return true;
}

}  // namespace

Triangulated triangulated(const TopoDS_Shape& shape, std::span<const Index> bodies, double tolerance,
                          double angle, const Message_ProgressRange& range) {
  IMeshTools_Parameters parameters;
  parameters.Deflection = std::max(tolerance, Precision::Confusion());  // the mesher refuses less
  parameters.Angle = angle;
  parameters.InParallel = false;
  const BRepMesh_IncrementalMesh meshed(shape, parameters, range);
  Triangulated out;
  std::map<Index, Welder> welders;
  std::size_t number = 0;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next(), ++number) {
    HARIKO_ASSERT(number < bodies.size(), "one number a face");
    Welder& welder = welders.try_emplace(bodies[number], out.mesh).first->second;
    if (!add(TopoDS::Face(face.Current()), welder, out.mesh)) ++out.failed;
  }
  return out;
}

}  // namespace hariko
