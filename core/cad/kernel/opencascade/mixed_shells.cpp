#include "core/cad/kernel/opencascade/mixed_shells.hpp"

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>

#include "core/base/assert.hpp"
#include "core/base/disjoint_sets.hpp"

namespace hariko {

std::vector<bool> beside_others(const TopoDS_Shape& shape, const std::vector<bool>& whole) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopTools_IndexedDataMapOfShapeListOfShape around;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, around);
  DisjointSets sets(std::size_t(faces.Extent()) + 1);  // the kernel counts from 1
  for (int e = 1; e <= around.Extent(); ++e) {
    const TopTools_ListOfShape& own = around(e);
    for (TopTools_ListOfShape::Iterator face(own); face.More(); face.Next())
      sets.join(Index(faces.FindIndex(own.First())), Index(faces.FindIndex(face.Value())));
  }
  std::vector<bool> mixed(sets.size(), false);
  std::vector<Index> set_of_face;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    HARIKO_ASSERT(set_of_face.size() < whole.size(), "one flag a face");
    const Index set = sets.find(Index(faces.FindIndex(face.Current())));
    if (!whole[set_of_face.size()]) mixed[set] = true;
    set_of_face.push_back(set);
  }
  std::vector<bool> out;
  for (const Index set : set_of_face) out.push_back(mixed[set]);
  return out;
}

}  // namespace hariko
