#include "core/modeling/cuts/edge_points.hpp"

namespace hariko {

std::vector<VertexId> add_edge_points(MeshEditor& draft, VertexId a, VertexId b,
                                      std::span<const double> shares) {
  const Vector3 from = draft.position(a), to = draft.position(b);
  const double alpha_a = draft.shaping().alpha.get_or(a, 0), alpha_b = draft.shaping().alpha.get_or(b, 0);
  std::vector<VertexId> out;
  VertexId last = a;
  for (const double share : shares) {
    const EdgeId edge = EdgeId::of(a, b);
    const VertexId middle =
        draft.add_vertex((1 - share) * from + share * to, EdgePoint{edge, edge.low == a ? share : 1 - share});
    const double alpha = (1 - share) * alpha_a + share * alpha_b;
    if (alpha > 0) draft.shaping().alpha.set(middle, alpha);
    draft.split_edge(EdgeId::of(last, b), middle);
    out.push_back(middle);
    last = middle;
  }
  return out;
}

std::vector<double> even_shares(int count) {
  std::vector<double> out;
  for (int i = 1; i <= count; ++i) out.push_back(static_cast<double>(i) / (count + 1));
  return out;
}

}  // namespace hariko
