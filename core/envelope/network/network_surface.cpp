#include <Eigen/Geometry>
#include <algorithm>

#include "core/envelope/closed_surface.hpp"
#include "core/envelope/network/curve_network.hpp"

namespace hariko {

namespace {

struct Piece {
  EnvelopePart part;
  ClosedPatch place;
};

class SurfaceAssembler {
 public:
  SurfaceAssembler(const CurveNetwork& network, const Vector3& origin) : network_(network), origin_(origin) {
    split_ = std::ranges::any_of(network.splits, [](const auto& split) { return split.has_value(); });
    middles_ = Index(network.cage.vertices.size());
    centres_ = middles_ + Index(split_ ? network.curves.size() : 0);
    normals_.assign(centres_ + (split_ ? network.cage.faces.size() : 0), Vector3::Zero());
  }

  Surface assemble() {
    for (Index v = 0; v < middles_; ++v) normals_[v] = network_.cage.vertices[v].normal;
    if (split_)
      for (Index e = 0; e < network_.curves.size(); ++e) {
        const RibbonCurve& ribbon = network_.curves[e].ribbon;
        normals_[middles_ + e] =
            ribbon.middle_derivative().cross(ribbon.across[0] + ribbon.across[1]).stableNormalized();
      }
    for (Index patch = 0; patch < network_.patches.size(); ++patch) {
      const Index face = network_.patch_places[patch].face;
      if (network_.splits[face])
        add_star_piece(patch);
      else if (split_)
        add_quarters(patch);
      else
        add_whole(patch);
    }
    return make();
  }

 private:
  RibbonCurve side(Index face, std::size_t k) const {
    const auto& loop = network_.cage.faces[face].loop;
    return network_.ribbon(loop[k % loop.size()], loop[(k + 1) % loop.size()]);
  }
  Index corner(Index face, std::size_t k) const {
    const auto& loop = network_.cage.faces[face].loop;
    return loop[k % loop.size()];
  }
  Index middle(Index face, std::size_t k) const {
    return middles_ + network_.find(corner(face, k), corner(face, k + 1));
  }
  Element source(Index face, std::size_t k) const {
    return element_of(EdgeId::of(VertexId{corner(face, k)}, VertexId{corner(face, k + 1)}));
  }

  void add_whole(Index patch) {
    const Index face = network_.patch_places[patch].face;
    Piece piece{{patch}, {{}, {element_of(FaceId{face}), 0}, {}}};
    for (std::size_t k = 0; k < 4; ++k) {
      piece.place.nodes[k] = corner(face, k);
      piece.part.sides[k] = side(face, k).curve;
      piece.place.sources[k] = source(face, k);
    }
    pieces_.push_back(std::move(piece));
  }

  void add_star_piece(Index patch) {
    const auto [face, k] = network_.patch_places[patch];
    const std::size_t n = network_.cage.faces[face].loop.size(), before = (k + n - 1) % n;
    const FaceSplit& split = *network_.splits[face];
    Piece piece{{patch}, {{}, {element_of(FaceId{face}), std::uint32_t(k)}, {}}};
    piece.place.nodes = {corner(face, k), middle(face, k), centres_ + face, middle(face, before)};
    piece.part.sides = {side(face, k).halves().first.curve, split.spokes[k].curve,
                        split.spokes[before].reversed().curve, side(face, before).halves().second.curve};
    piece.place.sources = {source(face, k), Element{}, Element{}, source(face, before)};
    normals_[centres_ + face] = split.normal;
    pieces_.push_back(std::move(piece));
  }

  /// Adds the four parts of a patch; part k holds corner k. The halves of the patch's sides equal those of
  /// divided neighbours.
  void add_quarters(Index patch) {
    const Index face = network_.patch_places[patch].face;
    static constexpr double at[4][2] = {{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t before = (k + 3) % 4;
      Piece piece{{patch, at[k][0], at[k][1], 0.5}, {{}, {element_of(FaceId{face}), std::uint32_t(k)}, {}}};
      // Sides and corners are those of the square, so part k begins at the patch's corner k.
      const auto slot = [&](std::size_t i) { return (k + i) % 4; };
      piece.place.nodes[slot(0)] = corner(face, k);
      piece.place.nodes[slot(1)] = middle(face, k);
      piece.place.nodes[slot(2)] = centres_ + face;
      piece.place.nodes[slot(3)] = middle(face, before);
      piece.part.sides[slot(0)] = side(face, k).halves().first.curve;
      piece.part.sides[slot(3)] = side(face, before).halves().second.curve;
      piece.place.sources[slot(0)] = source(face, k);
      piece.place.sources[slot(3)] = source(face, before);
      pieces_.push_back(std::move(piece));
    }
    quartered_.push_back({face, Index(pieces_.size() - 4)});
  }

  Surface make() {
    std::vector<EnvelopePart> parts;
    std::vector<ClosedPatch> places;
    for (const Piece& piece : pieces_) parts.push_back(piece.part), places.push_back(piece.place);
    auto patches = std::make_shared<const EnvelopePatchSet>(network_.patches, std::move(parts));
    for (const auto& [face, first] : quartered_)
      normals_[centres_ + face] = unit_normal(patches->evaluate(first, Vector2(1, 1), Order::first));
    return closed_surface(origin_, std::move(patches), places, std::move(normals_));
  }

  const CurveNetwork& network_;
  Vector3 origin_;
  bool split_ = false;
  Index middles_ = 0, centres_ = 0;
  std::vector<Piece> pieces_;
  std::vector<std::pair<Index, Index>> quartered_;  ///< face, first piece
  std::vector<Vector3> normals_;
};

}  // namespace

Surface network_surface(const CurveNetwork& network, const Vector3& origin) {
  return SurfaceAssembler(network, origin).assemble();
}

std::size_t folded_patches(const Surface& surface) {
  constexpr int cells = 10;
  const GridPattern pattern{Domain::square, cells};
  std::vector<Vector3> positions(std::size_t(pattern.point_count())), normals(positions.size());
  std::size_t out = 0;
  for (Index p = 0; p < surface.patch_count(); ++p) {
    const Index one[]{p};
    surface.patches().evaluate_grid(one, pattern, positions, normals);
    const auto at = [&](int i, int j) -> const Vector3& { return normals[std::size_t(pattern.index(i, j))]; };
    bool fold = false;
    for (int j = 1; j < cells; ++j)
      for (int i = 1; i < cells; ++i) {
        const double u = double(i) / cells, v = double(j) / cells;
        const Vector3 blend = (1 - u) * (1 - v) * at(0, 0) + u * (1 - v) * at(cells, 0) +
                              u * v * at(cells, cells) + (1 - u) * v * at(0, cells);
        fold = fold || !(at(i, j).dot(blend) > 0);
      }
    out += fold;
  }
  return out;
}

}  // namespace hariko
