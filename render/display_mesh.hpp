#pragma once

// DisplayMesh: tessellation of a surface for the screen. A value without GL: built by workers, uploaded by
// the renderer.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/surface/surface.hpp"
#include "render/camera.hpp"

namespace hariko {

/// Vertex of a display mesh.
struct DisplayVertex {
  std::array<float, 3> position;  ///< relative to the mesh's origin
  std::array<float, 3> normal;    ///< unit normal of the surface; zero where it has none
};

/// Map evaluated on surface points: values[k * n + i] for grid point i of patches[k], n =
/// pattern.point_count(). NaN where the map is undefined (drawn grey). Must be thread-safe.
using MapFunction = std::function<void(const Surface& surface, std::span<const Index> patches,
                                       const GridPattern& pattern, std::span<float> values)>;

/// Map evaluated along seams: values[i] at fraction i / density of seam `seam`'s first side.
using EdgeMapFunction =
    std::function<void(const Surface& surface, Index seam, int density, std::span<float> values)>;

/// Density and maps of a display mesh.
struct DisplayOptions {
  int density = 8;           ///< intervals along a patch side, >= 1
  MapFunction map;           ///< may be empty: no values
  EdgeMapFunction edge_map;  ///< may be empty
};

/// Density at which a surface with this number of patches looks smooth in close-up while its triangles stay
/// below about `triangle_budget`. Between 3 and 32.
int display_density(Index patch_count, Domain domain = Domain::triangle, double triangle_budget = 200'000);

/// Kinds of curves on a surface: source edges, creases, boundaries, and seams inside source faces.
enum class CurveKind : std::uint8_t { network, crease, boundary, split };
inline constexpr int curve_kind_count = 4;

/// Segment of a curve on the surface between two vertices of the mesh, with its neighbours for mitred joins
/// (equal to the segment's own end where the curve ends). Vertex numbers run over the whole mesh.
struct CurveSegment {
  std::array<Index, 4> vertices;  ///< previous, begin, end, next
};

/// Curve on the surface, with its origin.
struct DisplayCurve {
  CurveKind kind = CurveKind::network;
  Index first_segment = 0, segment_count = 0;  ///< into segments(kind)
  Element source;                              ///< source edge; kind none for split edges
  Index seam = no_index;                       ///< no_index for boundary sides
};

/// Immutable tessellation; copies of parts are shared between versions. Vertices come in a fixed block for
/// each patch, all blocks on the same grid: vertex i of patch p has number p * vertices_per_patch() + i.
/// Blocks are stored in chunks of `patches_per_chunk` patches; a refreshed mesh shares the chunks that it
/// does not change, by which the renderer knows what to upload.
class DisplayMesh {
 public:
  static constexpr Index patches_per_chunk = 32;
  /// Vertices of consecutive patches.
  struct Chunk {
    std::vector<DisplayVertex> vertices;
    std::vector<float> values;  ///< one per vertex, or empty
    Box3 box;                   ///< bounding box of the positions
  };
  /// Part that depends on adjacency and density only.
  struct Curves {
    std::array<std::vector<CurveSegment>, curve_kind_count> segments;
    std::vector<DisplayCurve> curves;
  };

  /// Evaluates the surface on every patch; null where cancelled. O(patches * density^2), in parallel.
  static std::shared_ptr<const DisplayMesh> build(const Surface& surface, const DisplayOptions& options,
                                                  const CancelToken& cancel = {});
  /// Copy with the `changed` patches evaluated anew; `surface` must have the same adjacency and origin.
  /// Values of the edge map are dropped; the options' map is applied to the changed patches. O(changed *
  /// density^2 + chunks).
  std::shared_ptr<const DisplayMesh> refreshed(const Surface& surface, std::span<const Index> changed) const;

  const Vector3& origin() const { return origin_; }
  const GridPattern& pattern() const { return pattern_; }
  const DisplayOptions& options() const { return options_; }
  Index patch_count() const { return patch_count_; }
  Index vertices_per_patch() const { return static_cast<Index>(pattern_.point_count()); }
  std::size_t vertex_count() const { return std::size_t(patch_count_) * vertices_per_patch(); }
  /// Number of triangles of all patches.
  std::size_t triangle_count() const;
  const std::vector<std::shared_ptr<const Chunk>>& chunks() const { return chunks_; }
  const DisplayVertex& vertex(std::size_t number) const;
  float value(std::size_t number) const;  ///< NaN without a map
  bool has_values() const { return static_cast<bool>(options_.map); }
  /// Bounding box of the positions, relative to the origin.
  const Box3& box() const { return box_; }
  const std::shared_ptr<const Curves>& curves() const { return curves_; }
  /// Values of the edge map, density + 1 for each seam, or empty.
  const std::shared_ptr<const std::vector<float>>& seam_values() const { return seam_values_; }
  /// Source element of a patch.
  const Provenance& provenance(Index patch) const { return (*provenance_)[patch]; }
  /// All defined values, to determine ranges. O(vertices).
  std::vector<float> defined_values() const;
  /// All defined values of the edge map. O(seams * density).
  std::vector<float> defined_seam_values() const;

 private:
  DisplayMesh() = default;
  Vector3 origin_ = Vector3::Zero();
  DisplayOptions options_;
  GridPattern pattern_{Domain::triangle, 1};
  Index patch_count_ = 0;
  std::vector<std::shared_ptr<const Chunk>> chunks_;
  Box3 box_;
  std::shared_ptr<const Curves> curves_;
  std::shared_ptr<const std::vector<float>> seam_values_;
  std::shared_ptr<const std::vector<Provenance>> provenance_;
};

}  // namespace hariko
