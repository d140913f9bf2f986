#pragma once

// G2PatchSet: the patches of mode G2 as a PatchSet: one per triangle (centre, vertex, next vertex) of a face;
// all patches of a face share its controls.

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "core/g2/faces/face_chart.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

/// Basis functions of a triangle's active controls at the points of a grid, in the layout of the kernel: for
/// each block of four points and each control three groups (value, d/ds, d/dt, or the second derivatives) of
/// four doubles.
struct G2GridTable {
  static constexpr std::size_t width = 4;
  std::size_t blocks = 0;
  std::vector<double> value;
};

/// Cache of tables, computed once and shared by the patch sets of a producer, up to a limit of memory; beyond
/// it tables are computed and dropped, with the same numbers. Thread-safe.
class G2Tables {
 public:
  enum class Derivatives { first, second };
  explicit G2Tables(std::size_t byte_limit = std::size_t(256) << 20) : byte_limit_(byte_limit) {}
  /// Table of a triangle; `chart` must live as long as this object.
  std::shared_ptr<const G2GridTable> table(const FaceChart& chart, int side, int density,
                                           Derivatives which) const;

 private:
  struct Key {
    const FaceChart* chart;
    int side, density;
    Derivatives which;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  std::size_t byte_limit_;
  mutable std::mutex mutex_;
  mutable std::size_t bytes_ = 0;
  mutable std::map<Key, std::shared_ptr<const G2GridTable>> tables_;
};

/// Map from patches to triangles of charts, with the charts' tables.
struct G2Atlas {
  std::vector<std::shared_ptr<const FaceChart>> chart;  ///< per face
  std::vector<Index> face;                              ///< per patch
  std::vector<int> side;                                ///< per patch: side of the face's chart
  G2Tables tables;
};

/// Controls of a face: those of its chart, then seven Bezier points of each side's curve, so that both faces
/// of an edge have the same bits along it. In the chart's numbering of sides.
using G2Face = std::vector<Vector3>;

/// Patches of mode G2, one per triangle (centre, vertex, next vertex) of a face.
class G2PatchSet final : public PatchSet, public ChartEvaluation {
 public:
  G2PatchSet(std::shared_ptr<const G2Atlas> atlas, std::vector<std::shared_ptr<const G2Face>> faces);

  const std::shared_ptr<const G2Atlas>& atlas() const { return atlas_; }
  const std::vector<std::shared_ptr<const G2Face>>& faces() const { return faces_; }
  const G2Face& face(Index face) const { return *faces_[face]; }

  const std::vector<Vector2>& polygon(Index face) const override { return atlas_->chart[face]->vertices(); }
  PatchPoint evaluate_chart(Index face, const Vector2& point, Order order) const override;
  /// Normal of the tangent plane at a patch's corner: 0 centre, 1 origin, 2 target of its half-edge. Zero if
  /// there is none.
  Vector3 corner_normal(Index patch, int corner) const;

  std::array<Vector3, 4> side_cross_derivative(Index patch) const override;

  Domain domain() const override { return Domain::triangle; }
  Index patch_count() const override { return static_cast<Index>(atlas_->face.size()); }
  PatchPoint evaluate(Index patch, const Vector2& parameter, Order order) const override;
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern, std::span<Vector3> positions,
                     std::span<Vector3> normals) const override;
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                     std::span<PatchPoint> points) const override;
  /// Exact, since every sector of a vertex has one quadratic form; direction-dependent where a joined side
  /// departs from it.
  CornerSecondOrder second_order_at_corner(Index patch, int corner) const override;
  ExactForm exact_form(Index patch) const override;

 private:
  const FaceChart& chart_of(Index patch) const { return *atlas_->chart[atlas_->face[patch]]; }
  Vector3 side_position(Index patch, double x, double one_minus_x) const;
  template <class Each>
  void for_tables(std::span<const Index> patches, int density, G2Tables::Derivatives which,
                  const Each& each) const;

  std::shared_ptr<const G2Atlas> atlas_;
  std::vector<std::shared_ptr<const G2Face>> faces_;
};

}  // namespace hariko
