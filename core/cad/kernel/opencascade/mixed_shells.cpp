#include "core/cad/kernel/opencascade/mixed_shells.hpp"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <utility>

#include "core/base/assert.hpp"
#include "core/base/disjoint_sets.hpp"

namespace hariko {

namespace {

/// Whether an edge bounds a face: it is neither shrunk to a point nor inside a face.
bool bounds(const TopoDS_Shape& edge) {
  return !BRep_Tool::Degenerated(TopoDS::Edge(edge)) && edge.Orientation() != TopAbs_INTERNAL &&
         edge.Orientation() != TopAbs_EXTERNAL;
}

/// Numbers the solids that faces bound, in the explorer's order, which is that of nesting.
class SolidNumbers {
 public:
  std::vector<Index> run(const TopoDS_Shape& shape) {
    add(shape, no_index);
    return std::move(of_face_);
  }

 private:
  void add(const TopoDS_Shape& shape, Index solid) {
    if (shape.ShapeType() == TopAbs_FACE) return of_face_.push_back(solid);
    const Index inner = shape.ShapeType() == TopAbs_SOLID ? solids_++ : solid;
    for (TopoDS_Iterator at(shape); at.More(); at.Next())
      if (at.Value().ShapeType() <= TopAbs_FACE) add(at.Value(), inner);
  }

  std::vector<Index> of_face_;
  Index solids_ = 0;
};

}  // namespace

ConnectedFaces connected_faces(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  // A face appears twice at an edge where it closes on itself.
  TopTools_IndexedDataMapOfShapeListOfShape around;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, around);
  DisjointSets sets(std::size_t(faces.Extent()) + 1);  // the kernel counts from 1
  for (int e = 1; e <= around.Extent(); ++e) {
    const TopTools_ListOfShape& own = around(e);
    for (TopTools_ListOfShape::Iterator face(own); face.More(); face.Next())
      sets.join(Index(faces.FindIndex(own.First())), Index(faces.FindIndex(face.Value())));
  }
  ConnectedFaces out;
  out.solid_of_face = SolidNumbers().run(shape);
  std::vector<Index> number(sets.size(), no_index);
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    Index& set = number[sets.find(Index(faces.FindIndex(face.Current())))];
    if (set == no_index) {
      set = Index(out.closed.size());
      out.closed.push_back(true);
    }
    out.set_of_face.push_back(set);
  }
  for (int e = 1; e <= around.Extent(); ++e) {
    const TopTools_ListOfShape& own = around(e);
    if (own.Extent() % 2 == 0 || !bounds(around.FindKey(e))) continue;
    out.closed[number[sets.find(Index(faces.FindIndex(own.First())))]] = false;
  }
  HARIKO_ASSERT(out.solid_of_face.size() == out.set_of_face.size(), "both orders are that of nesting");
  return out;
}

std::vector<bool> beside_others(const ConnectedFaces& faces, const std::vector<bool>& whole) {
  HARIKO_ASSERT(whole.size() == faces.set_of_face.size(), "one flag a face");
  std::vector<bool> mixed(faces.closed.size(), false), out;
  for (std::size_t k = 0; k < whole.size(); ++k)
    if (!whole[k]) mixed[faces.set_of_face[k]] = true;
  for (const Index set : faces.set_of_face) out.push_back(mixed[set]);
  return out;
}

}  // namespace hariko
