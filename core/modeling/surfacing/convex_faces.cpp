#include "core/modeling/surfacing/convex_faces.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "core/geometry/polygon.hpp"
#include "core/modeling/mesh_editor.hpp"
#include "core/polyhedron/face_decomposition.hpp"

namespace hariko {
namespace {

using Pieces = std::vector<std::vector<Index>>;

/// Visits the inner edges of a decomposition, as pairs of the face's corner numbers.
template <class Visit>
void for_each_diagonal(const Pieces& pieces, std::size_t sides, Visit&& visit) {
  for (const std::vector<Index>& piece : pieces)
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const Index a = piece[i], b = piece[(i + 1) % piece.size()];
      if ((a + 1) % sides != b && a < b) visit(a, b);  // each diagonal occurs in both of its pieces
    }
}

/// Finds the cuts of the concave faces in order: a diagonal may not repeat an edge or an earlier diagonal.
class CutFinder {
 public:
  CutFinder(const Polyhedron& polyhedron, const ConvexFaces* previous)
      : polyhedron_(polyhedron), mesh_(polyhedron.topology()), previous_(previous) {}

  void find(std::vector<FaceCut>& cuts, std::vector<Index>& concave) {
    std::vector<char> was_concave(mesh_.face_count(), previous_ ? 0 : 1);
    if (previous_)
      for (const Index f : previous_->concave) was_concave[f] = 1;
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      if (mesh_.side_count(f) == 3 || (!was_concave[f] && !moved(f))) continue;
      const std::vector<Vector3> points = polyhedron_.corners(f);
      if (classify_face(points) != FaceShape::concave) continue;
      concave.push_back(f);
      if (auto pieces = pieces_of(f, points)) take(cuts, {f, std::move(*pieces)});
    }
  }

 private:
  bool moved(Index f) const {
    const auto corners = mesh_.face_vertices(f);
    return std::any_of(corners.begin(), corners.end(), [&](Index v) {
      return polyhedron_.position(v) != previous_->before.polyhedron.position(v);
    });
  }
  bool may_join(Index a, Index b) const {
    return mesh_.find_half_edge(a, b) == no_index && mesh_.find_half_edge(b, a) == no_index &&
           !diagonals_.contains(std::minmax(a, b));
  }
  std::optional<Pieces> pieces_of(Index f, std::span<const Vector3> points) const {
    const auto corners = mesh_.face_vertices(f);
    auto pieces = convex_pieces(points, [&](Index a, Index b) { return may_join(corners[a], corners[b]); });
    return pieces && pieces->size() > 1 ? std::move(pieces) : std::nullopt;
  }
  void take(std::vector<FaceCut>& cuts, FaceCut cut) {
    const auto corners = mesh_.face_vertices(cut.face);
    for_each_diagonal(cut.pieces, corners.size(),
                      [&](Index a, Index b) { diagonals_.insert(std::minmax(corners[a], corners[b])); });
    cuts.push_back(std::move(cut));
  }

  const Polyhedron& polyhedron_;
  const HalfEdgeMesh& mesh_;
  const ConvexFaces* previous_;
  std::set<std::pair<Index, Index>> diagonals_;
};

/// Cuts the faces, and records which face each piece and inner edge belongs to.
Result<ConvexFaces> cut(const PolyhedronSource& source, std::vector<Index> concave,
                        std::vector<FaceCut> cuts) {
  MeshEditor draft(source);
  auto aliases = std::make_shared<ElementAliases>();
  for (const FaceCut& cut : cuts) {
    const FaceId face = source.polyhedron.face_id(cut.face);
    const auto old = draft.face(face);
    const std::vector<VertexId> corners(old.begin(), old.end());
    for (std::size_t k = 0; k < cut.pieces.size(); ++k) {
      std::vector<VertexId> own;
      for (const Index i : cut.pieces[k]) own.push_back(corners[i]);
      if (k == 0)
        draft.set_face(face, std::move(own));
      else
        aliases->pieces.set(draft.add_face(std::move(own)), face);
    }
    for_each_diagonal(cut.pieces, corners.size(), [&](Index a, Index b) {
      aliases->inner_edges.set(EdgeId::of(corners[a], corners[b]), face);
    });
  }
  auto finished = std::move(draft).finish();
  if (!finished) return finished.error();
  // Kept forms may refer to inner edges; pieces together are weighted as their face.
  if (!source.shaping->form.empty() || !source.shaping->kept_area.empty()) {
    Shaping shaping = *finished->shaping;
    shaping.form = source.shaping->form;
    shaping.kept_area = source.shaping->kept_area;
    for (const auto& [piece, face] : aliases->pieces)
      if (const double* area = source.shaping->kept_area.find(face)) shaping.kept_area.set(piece, *area);
    finished.value().shaping = std::move(shaping);
  }
  return ConvexFaces{source, std::move(concave), std::move(cuts), std::move(finished).value(),
                     std::move(aliases)};
}

/// `previous` with the present positions.
Result<ConvexFaces> moved(const PolyhedronSource& source, std::vector<Index> concave,
                          const ConvexFaces& previous) {
  const Polyhedron &before = previous.before.polyhedron, &whole = previous.source.polyhedron;
  std::vector<Index> vertices;
  std::vector<Vector3> positions;
  Index to = 0;  // isolated vertices were dropped: ids are ascending in both
  for (Index v = 0; v < source.polyhedron.vertex_count(); ++v) {
    const Vector3& position = source.polyhedron.position(v);
    while (to < whole.vertex_count() && whole.vertex_id(to) < before.vertex_id(v)) ++to;
    if (to == whole.vertex_count() || whole.vertex_id(to) != before.vertex_id(v)) continue;
    if (position == whole.position(to)) continue;
    vertices.push_back(to);
    positions.push_back(position);
  }
  auto polyhedron = whole.with_positions(vertices, positions);
  if (!polyhedron) return polyhedron.error();
  ConvexFaces out = previous;
  out.before = source;
  out.concave = std::move(concave);
  out.source.polyhedron = std::move(polyhedron).value();
  return out;
}

}  // namespace

Result<ConvexFaces> with_convex_faces(const PolyhedronSource& source, const ConvexFaces* previous) {
  if (previous && (previous->before.polyhedron.shared_topology() != source.polyhedron.shared_topology() ||
                   previous->before.origin != source.origin))
    previous = nullptr;
  std::vector<FaceCut> cuts;
  std::vector<Index> concave;
  CutFinder(source.polyhedron, previous).find(cuts, concave);
  if (cuts.empty()) return ConvexFaces{source, std::move(concave), {}, source, nullptr};
  if (previous && previous->cuts == cuts && previous->before.shaping == source.shaping &&
      previous->before.mirror == source.mirror)
    return moved(source, std::move(concave), *previous);
  return cut(source, std::move(concave), std::move(cuts));
}

}  // namespace hariko
