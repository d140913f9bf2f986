#include "core/modeling/selection/selected.hpp"

#include <algorithm>
#include <utility>

#include "core/base/index_list.hpp"
#include "core/document/edits/edit_elements.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {
namespace {

/// Returns the dense indices of many edges at once: looking each up by itself would be quadratic at a vertex
/// of high valence.
std::vector<Index> find_all(const Polyhedron& polyhedron, std::span<const EdgeId> ids) {
  std::vector<std::pair<EdgeId, Index>> edges;
  edges.reserve(polyhedron.edge_count());
  for (Index e = 0; e < polyhedron.edge_count(); ++e) edges.emplace_back(polyhedron.edge_id(e), e);
  std::sort(edges.begin(), edges.end());
  std::vector<Index> out;
  out.reserve(ids.size());
  for (const EdgeId id : ids) {
    const auto found = std::lower_bound(edges.begin(), edges.end(), std::pair<EdgeId, Index>{id, 0});
    out.push_back(found != edges.end() && found->first == id ? found->second : no_index);
  }
  return out;
}

template <class Id>
std::vector<Index> find_all(const Polyhedron& polyhedron, std::span<const Id> ids) {
  std::vector<Index> out;
  out.reserve(ids.size());
  for (const Id id : ids) out.push_back(polyhedron.find(id));
  return out;
}

template <class Id>
Result<std::vector<Index>> checked(const Polyhedron& polyhedron, std::span<const Id> ids, const char* what,
                                   const char* remedy) {
  if (ids.empty()) return make_error(e_nothing_selected, std::string("No ") + what + " selected.", remedy);
  std::vector<Index> out = find_all(polyhedron, ids);
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (out[i] == no_index)
      return make_error(e_unknown_element, "The object has no such element.", "Select it again.",
                        element_of(ids[i]));
  sort_unique(out);
  return out;
}

}  // namespace

Result<std::vector<Index>> selected(const Polyhedron& polyhedron, std::span<const VertexId> ids,
                                    const char* remedy) {
  return checked(polyhedron, ids, "vertices are", remedy);
}

Result<std::vector<Index>> selected(const Polyhedron& polyhedron, std::span<const EdgeId> ids,
                                    const char* remedy) {
  return checked(polyhedron, ids, "edges are", remedy);
}

Result<std::vector<Index>> selected(const Polyhedron& polyhedron, std::span<const FaceId> ids,
                                    const char* remedy) {
  return checked(polyhedron, ids, "faces are", remedy);
}

}  // namespace hariko
