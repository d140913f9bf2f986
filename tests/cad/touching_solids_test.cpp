// Solids of one part that touch stay apart as closed bodies; tiny ones have triangles as well.

#include <Eigen/Geometry>
#include <map>

#include "core/cad/kernel/cad_file.hpp"
#include "core/cad/kernel/read_cad_file.hpp"
#include "tests/support/temporary_folder.hpp"

#ifdef HARIKO_OPENCASCADE
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Compound.hxx>

namespace hariko::test {
namespace {

/// Mesh of boxes with given corners and sides, as one part of a STEP file.
PolygonMesh mesh_of_boxes(const std::vector<std::pair<Vector3, Vector3>>& boxes) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (const auto& [corner, sides] : boxes)
    builder.Add(
        all, BRepPrimAPI_MakeBox(gp_Pnt(corner.x(), corner.y(), corner.z()), sides.x(), sides.y(), sides.z())
                 .Shape());
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.step";
  STEPControl_Writer writer;  // makes the settings known
  EXPECT_TRUE(Interface_Static::SetIVal("write.step.assembly", 0)) << "one product";
  EXPECT_EQ(writer.Transfer(all, STEPControl_AsIs), IFSelect_RetDone);
  EXPECT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
  auto read = read_cad_file(path);
  if (!read.ok() || read->parts.size() != 1) {
    ADD_FAILURE() << (read.ok() ? "several parts" : to_string(read.error()));
    return {};
  }
  EXPECT_TRUE(read->warnings.empty());
  return read->parts[0].mesh;
}

/// Directed edges, by numbers of vertices, without a single opposite one.
std::size_t unmatched_half_edges(const PolygonMesh& mesh) {
  std::map<std::pair<Index, Index>, int> uses;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) ++uses[{face[k], face[(k + 1) % face.size()]}];
  }
  std::size_t out = 0;
  for (const auto& [edge, count] : uses) {
    const auto opposite = uses.find({edge.second, edge.first});
    out += count != 1 || opposite == uses.end() || opposite->second != 1;
  }
  return out;
}

double enclosed_volume(const PolygonMesh& mesh) {
  double out = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    out += mesh.positions[face[0]].dot(mesh.positions[face[1]].cross(mesh.positions[face[2]])) / 6;
  }
  return out;
}

TEST(TouchingSolids, StayClosedBodiesOfTheirOwn) {
  const Vector3 sides(10, 10, 10);
  const std::map<std::string, Vector3> second{
      {"face", {10, 0, 0}}, {"edge", {10, 10, 0}}, {"corner", {10, 10, 10}}, {"apart", {30, 0, 0}}};
  for (const auto& [name, corner] : second) {
    SCOPED_TRACE(name);
    const PolygonMesh mesh = mesh_of_boxes({{Vector3::Zero(), sides}, {corner, sides}});
    EXPECT_EQ(mesh.positions.size(), 16U);
    EXPECT_EQ(mesh.face_count(), 24U);
    EXPECT_EQ(unmatched_half_edges(mesh), 0U);
    EXPECT_NEAR(enclosed_volume(mesh), 2000, 1e-9);
  }
}

TEST(TouchingSolids, TinyOnesHaveTriangles) {
  for (const double size : {1e-6, 1e-5, 1e-3}) {
    SCOPED_TRACE(size);
    const PolygonMesh mesh = mesh_of_boxes({{Vector3::Zero(), Vector3(1, 2, 3) * size}});
    EXPECT_EQ(mesh.positions.size(), 8U);
    EXPECT_EQ(unmatched_half_edges(mesh), 0U);
    const double volume = 6 * size * size * size;
    EXPECT_NEAR(enclosed_volume(mesh), volume, 1e-9 * volume);
  }
}

}  // namespace
}  // namespace hariko::test
#endif
