#pragma once

// QuarticPatchSet: extended quartic triangles as a PatchSet: polynomial quartic boundaries, rational inner
// points, G1 across edges (Kuriyama 1991, section 3).

#include <array>
#include <map>
#include <memory>
#include <mutex>

#include "core/base/chunked_array.hpp"
#include "core/patching/quartic/quartic_basis.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

/// Extended quartic triangle, by its control points.
struct QuarticPatch {
  std::array<Vector3, quartic_control_count> control;
};

/// Basis functions at the points of a grid, in the layout of the evaluation kernel: for each block of four
/// points and each table (value, d/ds, d/dt, then d2/ds2, d2/dsdt, d2/dt2), 18 groups of four doubles.
struct QuarticGridTable {
  static constexpr std::size_t width = 4;
  GridPattern pattern{Domain::triangle, 1};
  std::size_t blocks = 0;
  std::vector<double> first;   ///< blocks * 18 * 3 * width
  std::vector<double> second;  ///< blocks * 18 * 3 * width
};

/// Tables by density, computed once and shared by all patch sets of a producer. Thread-safe.
class QuarticTables {
 public:
  /// Table of a density, computed at its first use.
  std::shared_ptr<const QuarticGridTable> table(int density) const;

 private:
  mutable std::mutex mutex_;
  mutable std::map<int, std::shared_ptr<const QuarticGridTable>> tables_;
};

/// Array of patches whose copies share memory in chunks of four patches (a quad's).
using QuarticPatchArray = ChunkedArray<QuarticPatch, 4>;

/// Extended quartic triangles that share grid tables.
class QuarticPatchSet final : public PatchSet {
 public:
  QuarticPatchSet(QuarticPatchArray patches, std::shared_ptr<const QuarticTables> tables);

  const QuarticPatchArray& array() const { return patches_; }
  const QuarticPatch& patch(Index i) const { return patches_[i]; }
  const std::shared_ptr<const QuarticTables>& tables() const { return tables_; }

  Domain domain() const override { return Domain::triangle; }
  Index patch_count() const override { return static_cast<Index>(patches_.size()); }
  PatchPoint evaluate(Index patch, const Vector2& parameter, Order order) const override;
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern, std::span<Vector3> positions,
                     std::span<Vector3> normals) const override;
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                     std::span<PatchPoint> points) const override;
  std::unique_ptr<const BatchEvaluation> batch(std::vector<Vector2> parameters) const override;
  /// Exact where the corner's two inner points coincide (to 1e-12 of the patch's size), as the patch is an
  /// ordinary quartic there; direction-dependent elsewhere.
  CornerSecondOrder second_order_at_corner(Index patch, int corner) const override;

  void positions(Index patch, std::span<const Vector2> parameters, std::span<Vector3> out) const override;
  void first_order(Index patch, std::span<const Vector2> parameters,
                   std::span<PatchPoint> out) const override;
  int hull_degree(Index) const override { return 4; }
  /// Hull with radii from the intervals of the rational weights over the triangle, as each inner point is a
  /// blend of two control points.
  void hull(Index patch, const ParameterTriangle& triangle, std::span<const Vector3> samples,
            std::span<HullBall> out) const override;
  ExactForm exact_form(Index patch) const override;

 private:
  QuarticPatchArray patches_;
  std::shared_ptr<const QuarticTables> tables_;
};

/// Evaluates a point of one patch by the scalar formulas.
PatchPoint evaluate_patch(const QuarticPatch& patch, const Vector2& parameter, Order order);

/// Point at fraction x of a side; the arithmetic is symmetric under reversal, so that both neighbours get the
/// same bits.
Vector3 evaluate_side(const QuarticPatch& patch, int side, double x, double one_minus_x);

}  // namespace hariko
