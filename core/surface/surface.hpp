#pragma once

// Surface: the common representation between the producers and the consumers of surfaces.

#include <array>
#include <memory>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/vector.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

enum class Continuity : std::uint8_t { g0, g1, g2 };

/// Side number `side` of patch number `patch`.
struct PatchSide {
  Index patch = no_index;
  std::uint8_t side = 0;
  friend bool operator==(const PatchSide&, const PatchSide&) = default;
};

/// Seam: two sides (or parts of sides) that meet. Fraction x of the first part lies on fraction x of the
/// second part: first_begin + x (first_end - first_begin), and the same for second. Neighbours traverse a
/// common side in opposite directions, so a full seam runs 0..1 on the first and 1..0 on the second.
struct Seam {
  PatchSide first, second;
  Continuity intended = Continuity::g1;
  double first_begin = 0, first_end = 1;
  double second_begin = 1, second_end = 0;
  /// Edge of the source that the seam lies on; kind none for seams inside a source element (split edges).
  Element source;
};

/// Provenance of a patch: the element of the source, and which side (row, ...) of it.
struct Provenance {
  Element element;
  std::uint32_t side = 0;
};

/// Immutable surface: patches, seams and provenance, all positions relative to `origin`. Sides without a seam
/// are boundary. Nodes are the welded corners of patches: corners joined by full seams are one node.
class Surface {
 public:
  struct Parts {
    Vector3 origin = Vector3::Zero();
    std::shared_ptr<const PatchSet> patches;
    std::shared_ptr<const std::vector<Seam>> seams;
    std::shared_ptr<const std::vector<Provenance>> provenance;  ///< one per patch
    /// Node of each corner, corner_count(domain) per patch; nodes are numbered 0 .. node_count - 1.
    std::shared_ptr<const std::vector<Index>> corner_nodes;
    Index node_count = 0;
    /// Unit outward normal of the common tangent plane at each node, zero where the patches have none in
    /// common (creases, corners). Size node_count.
    std::shared_ptr<const std::vector<Vector3>> node_normals;
    /// Source edges that lie on boundary sides, aligned with `boundary_sides`.
    std::shared_ptr<const std::vector<PatchSide>> boundary_sides;
    std::shared_ptr<const std::vector<Element>> boundary_sources;
  };

  Surface() = default;
  /// Takes parts that are all given and fit each other (asserted). O(patches + seams).
  explicit Surface(Parts parts);

  const Vector3& origin() const { return parts_.origin; }
  Index patch_count() const { return parts_.patches ? parts_.patches->patch_count() : 0; }
  Domain domain() const { return parts_.patches->domain(); }
  const PatchSet& patches() const { return *parts_.patches; }
  const std::vector<Seam>& seams() const { return *parts_.seams; }
  const std::vector<Provenance>& provenance() const { return *parts_.provenance; }
  const std::vector<PatchSide>& boundary_sides() const { return *parts_.boundary_sides; }
  const std::vector<Element>& boundary_sources() const { return *parts_.boundary_sources; }
  Index node_count() const { return parts_.node_count; }
  Index node(Index patch, int corner) const {
    return (*parts_.corner_nodes)[patch * static_cast<Index>(corner_count(domain())) +
                                  static_cast<Index>(corner)];
  }
  const Vector3& node_normal(Index node) const { return (*parts_.node_normals)[node]; }

  /// Copy with other patches of the same type and number (after positions moved). O(1).
  Surface with_patches(std::shared_ptr<const PatchSet> patches,
                       std::shared_ptr<const std::vector<Vector3>> node_normals) const;

  /// True when both share everything but patch geometry, so that results derived from adjacency may be kept.
  bool same_adjacency(const Surface& other) const {
    return parts_.seams == other.parts_.seams && parts_.corner_nodes == other.parts_.corner_nodes;
  }

  /// Size of a patch: the largest distance between two of its corners. Zero for a patch shrunk to a point.
  double patch_scale(Index patch) const;

  /// Unit outward normal at a parameter. Where |ds x dt| is at most 1e-12 patch_scale^2, it is taken from the
  /// node's plane (at corners), or else from the normal 1e-4 further towards the patch's centre. Zero if all
  /// fail. For single points; for many points `PatchSet::evaluate_grid` is cheaper.
  Vector3 normal(Index patch, const Vector2& parameter) const;

 private:
  Parts parts_;
};

}  // namespace hariko
