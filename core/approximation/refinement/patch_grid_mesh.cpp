#include "core/approximation/refinement/patch_grid_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/assert.hpp"
#include "core/base/disjoint_sets.hpp"
#include "core/surface/adjacency.hpp"

namespace hariko {

namespace {

constexpr double same_parameter = 1e-10;
constexpr int side_samples = 16;
constexpr int max_cuts = 3;

/// Piece of a side, in the direction of the side, and its half-edge.
struct SidePiece {
  double begin, end;
  Index half_edge;
};

class InitialMesh {
 public:
  InitialMesh(const Surface& surface, std::span<const PatchCells> cells)
      : surface_(surface),
        corners_(corner_count(surface.domain())),
        cells_(cells),
        sides_(std::size_t(surface.patch_count()) * std::size_t(corners_)) {}

  ParameterMesh make() {
    find_collapsed();
    for (Index p = 0; p < surface_.patch_count(); ++p)
      if (surface_.domain() == Domain::square)
        add_square(p);
      else
        add_triangle(p);
    cut_at_joints();
    link_seams();
    number_vertices();
    return std::move(mesh_);
  }

 private:
  std::size_t slot(PatchSide side) const {
    return std::size_t(side.patch) * std::size_t(corners_) + side.side;
  }
  Vector3 at(Index patch, const Vector2& parameter) const {
    return surface_.patches().evaluate(patch, parameter, Order::first).position;
  }

  void find_collapsed() {
    collapsed_.assign(sides_.size(), 0);
    std::vector<double> extent(sides_.size(), 0.0);
    double size = 0;
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      const auto patch = Index(k / std::size_t(corners_));
      const int side = int(k % std::size_t(corners_));
      const Vector3 begin = at(patch, side_parameter(surface_.domain(), side, 0));
      for (int i = 1; i <= side_samples; ++i)
        extent[k] = std::max(
            extent[k],
            (at(patch, side_parameter(surface_.domain(), side, double(i) / side_samples)) - begin).norm());
      size = std::max(size, extent[k]);
    }
    for (std::size_t k = 0; k < sides_.size(); ++k) collapsed_[k] = extent[k] <= 1e-9 * size;
  }

  Index add_vertex(Index patch, const Vector2& parameter) {
    mesh_.positions.push_back(at(patch, parameter));
    return same_.add();
  }
  PatchCells cells_of(Index patch) const { return cells_[cells_.size() == 1 ? 0 : patch]; }

  void add_square(Index patch) {
    const int columns = cells_of(patch).columns, rows = cells_of(patch).rows;
    const auto width = std::size_t(columns + 1);
    std::vector<Index> vertex;
    std::vector<Vector2> parameter;
    for (int j = 0; j <= rows; ++j)
      for (int i = 0; i <= columns; ++i) {
        parameter.emplace_back(grid_fraction(i, columns), grid_fraction(j, rows));
        vertex.push_back(add_vertex(patch, parameter.back()));
      }
    const auto is_collapsed = [&](std::uint8_t side) { return collapsed_[slot({patch, side})] != 0; };
    const auto index = [&](int i, int j) { return std::size_t(j) * width + std::size_t(i); };
    if (is_collapsed(0))
      for (int i = 0; i < columns; ++i) same_.join(vertex[index(i, 0)], vertex[index(i + 1, 0)]);
    if (is_collapsed(2))
      for (int i = 0; i < columns; ++i) same_.join(vertex[index(i, rows)], vertex[index(i + 1, rows)]);
    if (is_collapsed(1))
      for (int j = 0; j < rows; ++j) same_.join(vertex[index(columns, j)], vertex[index(columns, j + 1)]);
    if (is_collapsed(3))
      for (int j = 0; j < rows; ++j) same_.join(vertex[index(0, j)], vertex[index(0, j + 1)]);
    // Half-edges of each cell's sides, no_index for a side that is shrunk.
    std::vector<std::array<Index, 4>> cells;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        const std::array<std::size_t, 4> c{index(i, j), index(i + 1, j), index(i + 1, j + 1),
                                           index(i, j + 1)};
        const std::array<bool, 4> shrunk{j == 0 && is_collapsed(0), i + 1 == columns && is_collapsed(1),
                                         j + 1 == rows && is_collapsed(2), i == 0 && is_collapsed(3)};
        std::array<Index, 4> v;
        std::array<Vector2, 4> w;
        for (std::size_t k = 0; k < 4; ++k) v[k] = vertex[c[k]], w[k] = parameter[c[k]];
        cells.push_back(add_cell(patch, v, w, shrunk));
      }
    const auto cell = [&](int i, int j) -> const std::array<Index, 4>& {
      return cells[std::size_t(j * columns + i)];
    };
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        if (i + 1 < columns) link(cell(i, j)[1], cell(i + 1, j)[3]);
        if (j + 1 < rows) link(cell(i, j)[2], cell(i, j + 1)[0]);
      }
    for (int i = 0; i < columns; ++i) {
      add_piece({patch, 0}, i, columns, cell(i, 0)[0]);
      add_piece({patch, 2}, i, columns, cell(columns - 1 - i, rows - 1)[2]);
    }
    for (int j = 0; j < rows; ++j) {
      add_piece({patch, 1}, j, rows, cell(columns - 1, j)[1]);
      add_piece({patch, 3}, j, rows, cell(0, rows - 1 - j)[3]);
    }
  }
  void link(Index a, Index b) {
    if (a != no_index && b != no_index) mesh_.link(a, b);
  }
  void add_piece(PatchSide side, int i, int count, Index half_edge) {
    if (half_edge == no_index) return;
    sides_[slot(side)].push_back({grid_fraction(i, count), grid_fraction(i + 1, count), half_edge});
  }

  /// Adds the facets of one quadrilateral; returns the half-edges of its sides.
  std::array<Index, 4> add_cell(Index patch, const std::array<Index, 4>& v, const std::array<Vector2, 4>& w,
                                const std::array<bool, 4>& shrunk) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (!shrunk[k]) continue;
      // Corners k and k + 1 are the pole: edges leave it at k + 1 and arrive at k.
      const std::size_t b = (k + 1) % 4, c = (k + 2) % 4, d = (k + 3) % 4;
      ParameterFacet facet;
      facet.patch = patch;
      facet.vertex = {v[k], v[c], v[d]};
      facet.parameter = {w[b], w[c], w[d]};
      facet.pole = 0;
      facet.pole_parameter = w[k];
      const Index f = mesh_.add_facet(facet);
      std::array<Index, 4> out;
      out[k] = no_index;
      out[b] = 3 * f;
      out[c] = 3 * f + 1;
      out[d] = 3 * f + 2;
      return out;
    }
    const auto distance = [&](std::size_t a, std::size_t b) {
      return (mesh_.positions[v[a]] - mesh_.positions[v[b]]).norm();
    };
    const bool first = distance(0, 2) <= distance(1, 3) * (1 + 1e-12);
    const std::size_t k = first ? 0 : 1;  // the diagonal runs from k to k + 2
    const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
      ParameterFacet facet;
      facet.patch = patch;
      facet.vertex = {v[a], v[b], v[c]};
      facet.parameter = {w[a], w[b], w[c]};
      return mesh_.add_facet(facet);
    };
    const Index f = triangle(k, k + 1, k + 2), g = triangle(k, k + 2, (k + 3) % 4);
    mesh_.link(3 * f + 2, 3 * g);
    std::array<Index, 4> out;
    out[k] = 3 * f;
    out[k + 1] = 3 * f + 1;
    out[k + 2] = 3 * g + 1;
    out[(k + 3) % 4] = 3 * g + 2;
    return out;
  }

  void add_triangle(Index patch) {
    const int n = cells_of(patch).columns;
    const GridPattern grid{Domain::triangle, n};
    const std::vector<Vector2> parameters = grid.parameters();
    std::vector<Index> vertex;
    for (const Vector2& w : parameters) vertex.push_back(add_vertex(patch, w));
    for (int side = 0; side < 3; ++side) {
      if (!collapsed_[slot({patch, std::uint8_t(side)})]) continue;
      const std::vector<int> points = grid.side(side);
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        same_.join(vertex[std::size_t(points[i])], vertex[std::size_t(points[i + 1])]);
    }
    std::map<std::pair<int, int>, Index> half_edges;
    for (const auto& t : grid.triangles()) {
      ParameterFacet facet;
      facet.patch = patch;
      for (std::size_t c = 0; c < 3; ++c) {
        facet.vertex[c] = vertex[std::size_t(t[c])];
        facet.parameter[c] = parameters[std::size_t(t[c])];
      }
      const Index f = mesh_.add_facet(facet);
      for (std::size_t c = 0; c < 3; ++c) {
        const int a = t[c], b = t[(c + 1) % 3];
        half_edges[{a, b}] = 3 * f + Index(c);
        if (const auto other = half_edges.find({b, a}); other != half_edges.end())
          mesh_.link(3 * f + Index(c), other->second);
      }
    }
    for (int side = 0; side < 3; ++side) {
      const std::vector<int> points = grid.side(side);
      for (int i = 0; i < n; ++i)
        add_piece({patch, std::uint8_t(side)}, i, n,
                  half_edges.at({points[std::size_t(i)], points[std::size_t(i) + 1]}));
    }
  }

  /// Cuts both sides of every partial seam at the ends of the seam and at each other's cuts.
  void cut_at_joints() {
    std::vector<const Seam*> partial;
    for (const Seam& seam : surface_.seams())
      if (!is_full(seam) || sides_[slot(seam.first)].size() != sides_[slot(seam.second)].size())
        partial.push_back(&seam);
    // A cut may propagate along a chain of joints; each round takes it one seam further.
    for (int round = 0; round < 16; ++round) {
      bool changed = false;
      for (const Seam* seam : partial) {
        for (const bool cut :
             {cut_side(seam->first, seam->first_begin), cut_side(seam->first, seam->first_end),
              cut_side(seam->second, seam->second_begin), cut_side(seam->second, seam->second_end)})
          changed = changed || cut;
        changed |= copy_cuts(seam->first, seam->first_begin, seam->first_end, seam->second,
                             seam->second_begin, seam->second_end);
        changed |= copy_cuts(seam->second, seam->second_begin, seam->second_end, seam->first,
                             seam->first_begin, seam->first_end);
      }
      if (!changed) return;
    }
  }
  bool copy_cuts(PatchSide from, double from_begin, double from_end, PatchSide to, double to_begin,
                 double to_end) {
    bool changed = false;
    const std::vector<SidePiece> pieces = sides_[slot(from)];
    for (const SidePiece& piece : pieces) {
      const double x = (piece.end - from_begin) / (from_end - from_begin);
      if (x > same_parameter && x < 1 - same_parameter)
        changed |= cut_side(to, to_begin + x * (to_end - to_begin));
    }
    return changed;
  }
  bool cut_side(PatchSide side, double x) {
    std::vector<SidePiece>& pieces = sides_[slot(side)];
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const SidePiece piece = pieces[k];
      if (x <= piece.begin + same_parameter || x >= piece.end - same_parameter) continue;
      same_.add();
      const double t = (x - piece.begin) / (piece.end - piece.begin);
      const bool forward = mesh_.from(piece.half_edge) < mesh_.to(piece.half_edge);
      const auto cut = mesh_.split(piece.half_edge, forward ? t : 1 - t,
                                   at(side.patch, side_parameter(surface_.domain(), side.side, x)));
      pieces[k].end = x;
      // At a border, the third edge of a cut is the second half.
      pieces.insert(pieces.begin() + std::ptrdiff_t(k) + 1, {x, piece.end, cut.edges[2]});
      renumber_moved(cut, side);
      return true;
    }
    return false;
  }
  /// Updates the piece of a side that moved to the new facet of a cut, where that side is a border.
  void renumber_moved(const ParameterMesh::Split& cut, PatchSide side) {
    const Index old_facet = cut.facets[0], new_facet = cut.facets[1];
    const Index corner = (cut.edges[1] % 3 + 1) % 3;
    const Index before = 3 * old_facet + corner, after = 3 * new_facet + corner;
    for (int k = 0; k < corners_; ++k)
      for (SidePiece& piece : sides_[slot({side.patch, std::uint8_t(k)})])
        if (piece.half_edge == before) piece.half_edge = after;
  }

  void link_seams() {
    for (const Seam& seam : surface_.seams()) {
      const double low = std::min(seam.first_begin, seam.first_end) - same_parameter;
      const double high = std::max(seam.first_begin, seam.first_end) + same_parameter;
      const std::vector<SidePiece>& others = sides_[slot(seam.second)];
      for (const SidePiece& piece : sides_[slot(seam.first)]) {
        if (piece.begin < low || piece.end > high) continue;
        const auto across = [&](double x) {
          const double fraction = (x - seam.first_begin) / (seam.first_end - seam.first_begin);
          return seam.second_begin + fraction * (seam.second_end - seam.second_begin);
        };
        const double begin = across(piece.end), end = across(piece.begin);
        const auto found = std::find_if(others.begin(), others.end(), [&](const SidePiece& other) {
          return std::abs(other.begin - begin) < 8 * same_parameter &&
                 std::abs(other.end - end) < 8 * same_parameter;
        });
        if (found == others.end() || mesh_.twin[piece.half_edge] != no_index ||
            mesh_.twin[found->half_edge] != no_index)
          continue;
        mesh_.link(piece.half_edge, found->half_edge);
        same_.join(mesh_.from(piece.half_edge), mesh_.to(found->half_edge));
        same_.join(mesh_.to(piece.half_edge), mesh_.from(found->half_edge));
      }
    }
    // Corners that are one node, and the pieces at a side's corner that belong to it.
    std::vector<Index> first(surface_.node_count(), no_index);
    for (Index p = 0; p < surface_.patch_count(); ++p)
      for (int c = 0; c < corners_; ++c) {
        const std::vector<SidePiece>& leaving = sides_[slot({p, std::uint8_t(c)})];
        const std::vector<SidePiece>& arriving =
            sides_[slot({p, std::uint8_t((c + corners_ - 1) % corners_)})];
        Index vertex = no_index;
        if (!leaving.empty())
          vertex = mesh_.from(leaving.front().half_edge);
        else if (!arriving.empty())
          vertex = mesh_.to(arriving.back().half_edge);
        if (vertex == no_index) continue;
        Index& known = first[surface_.node(p, c)];
        if (known == no_index)
          known = vertex;
        else
          same_.join(known, vertex);
      }
  }

  void number_vertices() {
    std::vector<Index> number(same_.size(), no_index), used(same_.size(), 0);
    for (const ParameterFacet& facet : mesh_.facets)
      for (const Index v : facet.vertex) used[same_.find(v)] = 1;
    std::vector<Vector3> positions;
    for (Index v = 0; v < same_.size(); ++v) {
      if (same_.find(v) != v || !used[v]) continue;
      number[v] = static_cast<Index>(positions.size());
      positions.push_back(mesh_.positions[v]);
    }
    for (ParameterFacet& facet : mesh_.facets)
      for (Index& v : facet.vertex) v = number[same_.find(v)];
    mesh_.positions = std::move(positions);
  }

  const Surface& surface_;
  int corners_;
  std::span<const PatchCells> cells_;  ///< one per patch, or one for all
  std::vector<std::vector<SidePiece>> sides_;
  std::vector<char> collapsed_;
  DisjointSets same_;  ///< vertices that coincide
  ParameterMesh mesh_;
};

/// Whether the mesh has facets with two equal corners, or two edges between the same vertices.
bool needs_cuts(const ParameterMesh& mesh) {
  std::vector<std::pair<Index, Index>> edges;
  for (Index f = 0; f < mesh.facets.size(); ++f) {
    if (mesh.facets[f].degenerate()) return true;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) edges.emplace_back(mesh.from(h), mesh.to(h));
  }
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) != edges.end();
}

}  // namespace

ParameterMesh grid_mesh(const Surface& surface, std::span<const PatchCells> cells) {
  if (surface.patch_count() == 0) return {};
  HARIKO_ASSERT(cells.size() == 1 || cells.size() == surface.patch_count(), "cells of every patch");
  return InitialMesh(surface, cells).make();
}

ParameterMesh initial_mesh(const Surface& surface, std::span<const PatchCells> cells) {
  std::vector<PatchCells> tried(cells.begin(), cells.end());
  if (tried.empty()) tried.emplace_back();
  for (int cuts = 1;; ++cuts) {
    for (PatchCells& one : tried) one = {std::max(one.columns, cuts), std::max(one.rows, cuts)};
    ParameterMesh mesh = grid_mesh(surface, tried);
    if (cuts == max_cuts || !needs_cuts(mesh)) return mesh;
  }
}

}  // namespace hariko
