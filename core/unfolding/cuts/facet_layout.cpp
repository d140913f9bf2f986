#include "core/unfolding/cuts/facet_layout.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <complex>

namespace hariko {

namespace {

using Complex = std::complex<double>;

Complex complex_of(const Vector2& v) {
  return {v.x(), v.y()};
}

}  // namespace

double longest_side(const FacetCorners& shape) {
  double out = 0;
  for (std::size_t k = 0; k < 3; ++k) out = std::max(out, (shape[(k + 1) % 3] - shape[k]).norm());
  return out;
}

double longest_side(std::span<const FacetCorners> shapes) {
  double out = 0;
  for (const FacetCorners& shape : shapes) out = std::max(out, longest_side(shape));
  return out;
}

std::vector<FacetCorners> facet_shapes(const FacetGraph& graph, double scale) {
  std::vector<FacetCorners> out(graph.facet_count());
  for (Index f = 0; f < out.size(); ++f) {
    const auto& corners = graph.triangle(f);
    const Vector3 first = graph.positions()[corners[1]] - graph.positions()[corners[0]];
    const Vector3 second = graph.positions()[corners[2]] - graph.positions()[corners[0]];
    const double length = first.norm();
    out[f] = {Vector2(0, 0), Vector2(scale * length, 0),
              Vector2(scale * first.dot(second) / length, scale * first.cross(second).norm() / length)};
  }
  return out;
}

FacetCorners hinge(const FacetCorners& shape, Index side, const Vector2& a, const Vector2& b) {
  const Index next = (side + 1) % 3, opposite = (side + 2) % 3;
  const Complex ta = complex_of(shape[side]), tb = complex_of(shape[next]);
  const Complex turn = (complex_of(b) - complex_of(a)) * std::conj(tb - ta);
  const Complex w = turn / std::abs(turn);
  const Complex from_middle = complex_of(shape[opposite]) - 0.5 * (ta + tb);
  const Vector2 moved(w.real() * from_middle.real() - w.imag() * from_middle.imag(),
                      w.real() * from_middle.imag() + w.imag() * from_middle.real());
  FacetCorners out;
  out[side] = a;
  out[next] = b;
  out[opposite] = 0.5 * (a + b) + moved;
  return out;
}

FacetCorners hinge_neighbour(const FacetGraph& graph, const std::vector<FacetCorners>& shapes, Index facet,
                             const FacetCorners& corners, Index side) {
  // Adjacent facets run along their common edge in opposite directions.
  return hinge(shapes[graph.neighbour(facet, side)], graph.mate_side(facet, side), corners[(side + 1) % 3],
               corners[side]);
}

FlatLayout lay_out(const FacetGraph& graph, const std::vector<FacetCorners>& shapes, const Folds& folds) {
  FlatLayout out;
  out.piece_of.assign(graph.facet_count(), no_index);
  out.corners.resize(graph.facet_count());
  std::vector<Index> entered_by(graph.facet_count(), no_index);  // edge to each facet's parent
  for (Index root = 0; root < graph.facet_count(); ++root) {
    if (out.piece_of[root] != no_index) continue;
    LaidPiece piece{{root}};
    out.piece_of[root] = static_cast<Index>(out.pieces.size());
    out.corners[root] = shapes[root];
    for (std::size_t k = 0; k < piece.facets.size(); ++k) {
      const Index facet = piece.facets[k];
      for (Index side = 0; side < 3; ++side) {
        const Index edge = graph.edge_at(facet, side);
        if (!folds[edge] || edge == entered_by[facet]) continue;
        const Index next = graph.neighbour(facet, side);
        HARIKO_ASSERT(next != no_index && out.piece_of[next] == no_index, "folds close a cycle");
        out.piece_of[next] = static_cast<Index>(out.pieces.size());
        out.corners[next] = hinge_neighbour(graph, shapes, facet, out.corners[facet], side);
        entered_by[next] = edge;
        piece.facets.push_back(next);
      }
    }
    out.pieces.push_back(std::move(piece));
  }
  return out;
}

}  // namespace hariko
