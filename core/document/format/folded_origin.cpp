#include "core/document/format/folded_origin.hpp"

#include <cmath>
#include <span>

namespace hariko {
namespace {

/// Distance from zero, in sizes of the model, from which on positions count as far: they lose three digits.
constexpr double far_in_sizes = 1024;

/// Origin for positions that are far from zero, zero in each coordinate that is not.
Vector3 far_origin(std::span<const Vector3> positions) {
  Eigen::AlignedBox3d box;
  for (const Vector3& position : positions) box.extend(position);
  if (box.isEmpty() || !box.min().allFinite() || !box.max().allFinite()) return Vector3::Zero();
  const double size = box.sizes().maxCoeff();
  if (!std::isfinite(size) || !(size > 0)) return Vector3::Zero();
  return origin_for(positions).unaryExpr([size](double coordinate) {
    return std::isfinite(coordinate) && std::abs(coordinate) > far_in_sizes * size ? coordinate : 0.0;
  });
}

struct TakeFarOrigin {
  Vector3 operator()(SolidsSource& source) const {
    EnvelopeInput input = *source.input;
    std::vector<Vector3> corners;
    for (const Solid& solid : input.solids) {
      const Eigen::AlignedBox3d box = box_of(solid);
      corners.push_back(box.min());
      corners.push_back(box.max());
    }
    Vector3 origin = far_origin(corners);
    if (input.settings.symmetry != SymmetryPlane::none)
      origin[static_cast<Eigen::Index>(input.settings.symmetry) - 1] = 0;
    if (origin.isZero(0)) return origin;
    for (Solid& solid : input.solids) solid.position -= origin;
    source.input = std::move(input);
    return origin;
  }
  Vector3 operator()(SkinSource& source) const {
    Skin skin = *source.skin;
    std::vector<Vector3> positions;
    change_positions(skin, [&](const Vector3& position) { positions.push_back(position); });
    const Vector3 origin = far_origin(positions);
    if (origin.isZero(0)) return origin;
    change_positions(skin, [&](Vector3& position) { position -= origin; });
    if (skin.mirror) skin.mirror->position -= origin[skin.mirror->axis];
    source.skin = std::move(skin);
    return origin;
  }
  Vector3 operator()(OutlineSource& source) const {
    Outline outline = *source.outline;
    std::vector<Vector3> positions;
    for (const OutlineLoop& loop : outline.loops)
      positions.insert(positions.end(), loop.points.begin(), loop.points.end());
    const Vector3 origin = far_origin(positions);
    if (origin.isZero(0)) return origin;
    for (OutlineLoop& loop : outline.loops)
      for (Vector3& point : loop.points) point -= origin;
    source.outline = std::move(outline);
    return origin;
  }
  // Those with an origin of their own, or without points.
  Vector3 operator()(PolyhedronSource&) const { return Vector3::Zero(); }
  Vector3 operator()(MeshSource&) const { return Vector3::Zero(); }
  Vector3 operator()(PatchSource&) const { return Vector3::Zero(); }
  Vector3 operator()(BezierSource&) const { return Vector3::Zero(); }
  Vector3 operator()(PictureSource&) const { return Vector3::Zero(); }
  Vector3 operator()(UnknownSource&) const { return Vector3::Zero(); }
};

}  // namespace

bool origin_is_folded(const Source& source) {
  return std::holds_alternative<SolidsSource>(source) || std::holds_alternative<SkinSource>(source) ||
         std::holds_alternative<OutlineSource>(source);
}

Similarity with_origin(const Similarity& transform, const Vector3& origin) {
  Similarity out = transform;
  if (!origin.isZero(0)) out.translation = transform.apply(origin);
  return out;
}

Vector3 take_far_origin(Source& source) {
  return std::visit(TakeFarOrigin{}, source);
}

}  // namespace hariko
