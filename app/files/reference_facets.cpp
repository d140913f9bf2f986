#include "app/files/reference_facets.hpp"

#include "core/exchange/repair/triangulate.hpp"
#include "core/surface/facets.hpp"

namespace hariko {

TriangleMesh triangles_of(const MeshSource& source) {
  return {source.origin, source.mesh->positions, triangulate(*source.mesh).triangles, {}, {}};
}

Surface facets_of(const MeshSource& source) {
  FaceTriangles cut = triangulate(*source.mesh);
  std::vector<Element> sources;
  sources.reserve(cut.faces.size());
  for (const Index face : cut.faces) sources.push_back({Element::Kind::face, face});
  return facet_surface(source.origin, source.mesh->positions, std::move(cut.triangles), sources);
}

}  // namespace hariko
