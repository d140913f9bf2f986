#include "core/patching/compare_surfaces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <map>
#include <tuple>

#include "core/g2/g2_patch_set.hpp"
#include "core/patching/quartic/quartic_patch.hpp"
#include "core/surface/bicubic_patch.hpp"

namespace hariko {

namespace {

enum class PatchKind { other, quartic, g2, bicubic };

/// Control points of patches, for the kinds of patches that have them.
class Controls {
 public:
  explicit Controls(const PatchSet& set)
      : quartic_(dynamic_cast<const QuarticPatchSet*>(&set)),
        g2_(dynamic_cast<const G2PatchSet*>(&set)),
        bicubic_(dynamic_cast<const BicubicPatchSet*>(&set)) {}

  PatchKind kind() const {
    if (quartic_) return PatchKind::quartic;
    if (g2_) return PatchKind::g2;
    return bicubic_ ? PatchKind::bicubic : PatchKind::other;
  }
  std::span<const Vector3> of(Index patch) {
    if (quartic_) return quartic_->patch(patch).control;
    if (g2_) return g2_->face(g2_->atlas()->face[patch]);
    points_.clear();
    for (int j = 0; bicubic_ && j < 4; ++j)
      for (int i = 0; i < 4; ++i)
        points_.push_back(bicubic_->net().points[bicubic_->net().index(patch, i, j)]);
    return points_;
  }
  /// Whether control `i` of a patch is a point in space and not a derivative.
  bool is_point(std::size_t i, Index patch) const {
    return !g2_ || i >= std::size_t(g2_->atlas()->chart[g2_->atlas()->face[patch]]->control_count());
  }

 private:
  const QuarticPatchSet* quartic_;
  const G2PatchSet* g2_;
  const BicubicPatchSet* bicubic_;
  std::vector<Vector3> points_;
};

using Source = std::tuple<Element::Kind, std::uint64_t, std::uint32_t>;
Source source_of(const Surface& surface, Index patch) {
  const Provenance& from = surface.provenance()[patch];
  return {from.element.kind, from.element.id, from.side};
}

}  // namespace

SurfaceComparison compare_surfaces(const Surface& surface, const Surface& other) {
  SurfaceComparison out;
  out.patches = surface.patch_count();
  if (surface.patch_count() == 0) return out;
  Controls own(surface.patches());
  std::map<Source, Index> there;
  for (Index p = 0; p < other.patch_count(); ++p) there[source_of(other, p)] = p;
  if (other.patch_count() == 0) {
    out.unmatched = out.patches;
    return out;
  }
  Controls others(other.patches());
  const bool comparable = own.kind() != PatchKind::other && own.kind() == others.kind();
  const Vector3 shift = other.origin() - surface.origin();
  Eigen::AlignedBox3d box;
  double largest = 0;
  for (Index p = 0; p < surface.patch_count(); ++p) {
    const auto partner = there.find(source_of(surface, p));
    const std::span<const Vector3> a = own.of(p);
    for (std::size_t i = 0; i < a.size(); ++i)
      if (own.is_point(i, p)) box.extend(a[i]);
    const std::span<const Vector3> b =
        comparable && partner != there.end() ? others.of(partner->second) : std::span<const Vector3>();
    if (a.empty() || a.size() != b.size()) {
      ++out.unmatched;
      continue;
    }
    const bool same = shift.isZero(0) && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
    ++(same ? out.unchanged : out.changed);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Vector3 moved = b[i] - a[i];
      largest = std::max(largest, (own.is_point(i, p) ? Vector3(moved + shift) : moved).norm());
    }
  }
  const double size = box.isEmpty() ? 0 : box.diagonal().norm();
  if (out.unmatched < out.patches) out.largest_distance = size > 0 ? largest / size : largest;
  return out;
}

}  // namespace hariko
