#include "core/cad/reversed_model.hpp"

#include <utility>

namespace hariko {

namespace {

/// Side on which a side lies where s and t are exchanged; it runs the other way there, x being length - x.
constexpr int side_behind(int side) {
  return 3 - side;
}

SplineSurface with_exchanged_parameters(const SplineSurface& surface) {
  SplineSurface out{surface.t, surface.s, {}};
  out.points.reserve(surface.points.size());
  for (std::size_t i = 0; i < surface.s.size(); ++i)
    for (std::size_t j = 0; j < surface.t.size(); ++j)
      out.points.push_back(surface.points[surface.index(i, j)]);
  return out;
}

CadPiece with_exchanged_parameters(const CadPiece& piece) {
  CadPiece out;
  out.s = piece.t;
  out.t = piece.s;
  for (int side = 0; side < 4; ++side) {
    const std::vector<double>& knots = piece.side_knots[std::size_t(side)];
    for (auto knot = knots.rbegin(); knot != knots.rend(); ++knot)
      out.side_knots[std::size_t(side_behind(side))].push_back(piece.length(side) - *knot);
  }
  return out;
}

/// Edges run along their first use, which runs the other way now. `pieces`: as they were before.
void run_backward(CadEdge& edge, const std::vector<CadPiece>& pieces) {
  std::swap(edge.begin, edge.end);
  edge.curve = reversed(edge.curve);
  for (int u = 0; u < edge.use_count; ++u) {
    CadUse& use = edge.uses[std::size_t(u)];
    const double length = pieces[use.piece].length(use.side);
    use = CadUse{use.piece, side_behind(use.side), length - use.end, length - use.begin};
  }
}

}  // namespace

CadModel reversed(CadModel model) {
  for (CadEdge& edge : model.edges) run_backward(edge, model.pieces);
  for (CadPiece& piece : model.pieces) piece = with_exchanged_parameters(piece);
  for (CadFace& face : model.faces) {
    face.surface = with_exchanged_parameters(face.surface);
    std::array<std::vector<Index>, 4> sides;
    for (int side = 0; side < 4; ++side) {
      const std::vector<Index>& old = face.sides[std::size_t(side)];
      sides[std::size_t(side_behind(side))].assign(old.rbegin(), old.rend());
    }
    face.sides = std::move(sides);
  }
  return model;
}

}  // namespace hariko
