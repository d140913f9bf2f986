#include "core/offset/wall_patch_set.hpp"

#include <algorithm>
#include <utility>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

/// Step of the differences for tangential second derivatives.
constexpr double second_order_step = 1e-5;

/// Unit normal along a sum of normals, and its derivatives along those of the sum. Ends keep their bits.
struct TurnedNormal {
  TurnedNormal(const Vector3& sum, const Vector3* exact)
      : length(sum.norm()), normal(exact ? *exact : Vector3(sum / length)) {}
  Vector3 derivative(const Vector3& of_sum) const { return (of_sum - normal * normal.dot(of_sum)) / length; }

  double length;
  Vector3 normal;
};

double on_base(const BaseSide& side, double x) {
  return side.begin + x * (side.end - side.begin);
}

double mixed(double from, double to, double t) {
  return t == 1 ? to : from + t * (to - from);
}

/// Parameter of the square of a patch.
Vector2 square_parameter(const WallPatch& patch, const Vector2& parameter) {
  Vector2 at = parameter;
  if (patch.flipped) std::swap(at.x(), at.y());
  if (patch.second_half) at = {1 - at.x(), 1 - at.y()};
  return at;
}

}  // namespace

WallPatchSet::WallPatchSet(std::shared_ptr<const BaseNormals> normals, std::vector<WallPatch> patches)
    : normals_(std::move(normals)), patches_(std::move(patches)) {}

NormalPoint WallPatchSet::face(const WallPatch& patch, const Vector2& at) const {
  NormalPoint p = normals_->at(patch.base, at);
  p.position += patch.from * p.normal;
  p.position_s += patch.from * p.normal_s;
  p.position_t += patch.from * p.normal_t;
  return p;
}

NormalPoint WallPatchSet::join(const WallPatch& patch, const Vector2& at) const {
  const double x = 1 - at.x(), t = at.y();
  const SidePoint a = normals_->on_side(patch.first.side, on_base(patch.first, x));
  const SidePoint b = normals_->on_side(patch.second.side, on_base(patch.second, x));
  const double speed_a = patch.first.end - patch.first.begin, speed_b = patch.second.end - patch.second.begin;
  const TurnedNormal turned((1 - t) * a.normal + t * b.normal, t == 0   ? &a.normal
                                                               : t == 1 ? &b.normal
                                                                        : nullptr);
  NormalPoint out;
  out.normal = turned.normal;
  out.normal_s = -turned.derivative((1 - t) * speed_a * a.normal_x + t * speed_b * b.normal_x);
  out.normal_t = turned.derivative(b.normal - a.normal);
  out.position = a.position + patch.from * out.normal;
  out.position_s = -speed_a * a.position_x + patch.from * out.normal_s;
  out.position_t = patch.from * out.normal_t;
  return out;
}

NormalPoint WallPatchSet::rim(const WallPatch& patch, const Vector2& at) const {
  const SidePoint a = normals_->on_side(patch.first.side, on_base(patch.first, 1 - at.x()));
  const double speed = patch.first.end - patch.first.begin;
  const double distance = mixed(patch.from, patch.to, at.y());
  NormalPoint out;
  out.normal = a.normal;
  out.normal_s = -speed * a.normal_x;
  out.position = a.position + distance * a.normal;
  out.position_s = -speed * a.position_x + distance * out.normal_s;
  out.position_t = (patch.to - patch.from) * a.normal;
  return out;
}

NormalPoint WallPatchSet::end(const WallPatch& patch, const Vector2& at) const {
  const double s = at.x(), distance = mixed(patch.from, patch.to, at.y());
  const auto& [begin, end, unused] = patch.normals;
  const TurnedNormal turned((1 - s) * begin + s * end, s == 0 ? &begin : s == 1 ? &end : nullptr);
  NormalPoint out;
  out.normal = turned.normal;
  out.normal_s = turned.derivative(end - begin);
  out.position = patch.position + distance * out.normal;
  out.position_s = distance * out.normal_s;
  out.position_t = (patch.to - patch.from) * out.normal;
  return out;
}

NormalPoint WallPatchSet::fan(const WallPatch& patch, const Vector2& at) const {
  const double s = at.x(), t = at.y();
  const auto& [begin, end, top] = patch.normals;
  const bool square = domain() == Domain::square;
  const Vector3 low = (1 - s) * begin + s * end;
  const Vector3 sum =
      square ? Vector3((1 - t) * low + t * top) : Vector3((1 - s - t) * begin + s * end + t * top);
  const Vector3* exact = t == 1 ? &top : t != 0 ? nullptr : s == 0 ? &begin : s == 1 ? &end : nullptr;
  const TurnedNormal turned(sum, exact);
  NormalPoint out;
  out.normal = turned.normal;
  out.normal_s = square ? turned.derivative((1 - t) * (end - begin)) : turned.derivative(end - begin);
  out.normal_t = square ? turned.derivative(top - low) : turned.derivative(top - begin);
  out.position = patch.position + patch.from * out.normal;
  out.position_s = patch.from * out.normal_s;
  out.position_t = patch.from * out.normal_t;
  return out;
}

NormalPoint WallPatchSet::shape(const WallPatch& patch, const Vector2& at) const {
  switch (patch.kind) {
    case WallPatch::Kind::face:
      return face(patch, at);
    case WallPatch::Kind::join:
      return join(patch, at);
    case WallPatch::Kind::rim:
      return rim(patch, at);
    case WallPatch::Kind::end:
      return end(patch, at);
    case WallPatch::Kind::fan:
      return fan(patch, at);
  }
  HARIKO_ASSERT(false, "a kind without a shape");
  return {};
}

void WallPatchSet::add_second_order(const WallPatch& patch, const Vector2& at, const NormalPoint& here,
                                    PatchPoint& out) const {
  constexpr double h = second_order_step;
  // The differences stay in the domain.
  Vector2 middle = at.cwiseMax(h).cwiseMin(1 - h);
  const bool base_triangle = patch.kind == WallPatch::Kind::face || patch.kind == WallPatch::Kind::fan;
  if (domain() == Domain::triangle && base_triangle && middle.sum() > 1 - h) {
    middle -= Vector2::Constant((middle.sum() - (1 - h)) / 2);
    middle = middle.cwiseMax(h);
    if (middle.sum() > 1 - h) middle *= (1 - h) / middle.sum();
  }
  const auto difference = [&](const Vector2& step) {
    const NormalPoint above = shape(patch, middle + step), below = shape(patch, middle - step);
    return std::pair<Vector3, Vector3>((above.position_s - below.position_s) / (2 * h),
                                       (above.position_t - below.position_t) / (2 * h));
  };
  const auto [ss, ts] = difference({h, 0.0});
  const auto [st, tt] = difference({0.0, h});
  out.dss = ss;
  out.dst = (ts + st) / 2;
  out.dtt = tt;
  if (!patch.parallel()) return;
  const Vector3& n = here.normal;
  out.dss -= n * (n.dot(out.dss) + here.position_s.dot(here.normal_s));
  out.dst -= n * (n.dot(out.dst) + here.position_s.dot(here.normal_t));
  out.dtt -= n * (n.dot(out.dtt) + here.position_t.dot(here.normal_t));
}

PatchPoint WallPatchSet::evaluate(Index index, const Vector2& parameter, Order order) const {
  const WallPatch& patch = patches_[index];
  const Vector2 at = square_parameter(patch, parameter);
  PatchPoint out;
  if (patch.kind == WallPatch::Kind::face && patch.from == 0) {
    out = normals_->base().patches().evaluate(patch.base, at, order);
  } else {
    const NormalPoint here = shape(patch, at);
    out.position = here.position;
    out.ds = here.position_s;
    out.dt = here.position_t;
    if (order == Order::second) add_second_order(patch, at, here, out);
  }
  if (patch.second_half) {
    out.ds = -out.ds;
    out.dt = -out.dt;
  }
  if (patch.flipped) {
    std::swap(out.ds, out.dt);
    std::swap(out.dss, out.dtt);
  }
  return out;
}

void WallPatchSet::positions(Index index, std::span<const Vector2> parameters, std::span<Vector3> out) const {
  const WallPatch& patch = patches_[index];
  if (patch.kind != WallPatch::Kind::face) return PatchSet::positions(index, parameters, out);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const Vector2 at = square_parameter(patch, parameters[k]);
    const PatchPoint point = normals_->base().patches().evaluate(patch.base, at, Order::first);
    out[k] = point.position;
    if (patch.from != 0) out[k] += patch.from * normals_->normal(patch.base, at, point);
  }
}

CornerSecondOrder WallPatchSet::second_order_at_corner(Index index, int corner) const {
  const WallPatch& patch = patches_[index];
  if (patch.kind != WallPatch::Kind::face) return PatchSet::second_order_at_corner(index, corner);
  const int corners = corner_count(domain());
  return normals_->base().patches().second_order_at_corner(
      patch.base, patch.flipped ? (corners - corner) % corners : corner);
}

Vector3 WallPatchSet::corner_normal(Index index, int corner) const {
  const WallPatch& patch = patches_[index];
  if (!patch.parallel()) return Vector3::Zero();
  const Vector3 normal = shape(patch, square_parameter(patch, corner_parameter(domain(), corner))).normal;
  return patch.flipped ? Vector3(-normal) : normal;
}

}  // namespace hariko
