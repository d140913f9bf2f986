#include "render/region_picking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hariko {

namespace {

// As for single picks: elements on the polyhedron are not hidden by the faces that they belong to.
constexpr double hiding_slack_pixels = 5;

bool inside(std::span<const Vector2> polygon, const Vector2& p) {
  bool odd = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector2 &a = polygon[i], &b = polygon[j];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) odd = !odd;
  }
  return odd;
}

Vector3 world_of(const SceneObject& object, Index vertex) {
  const Vector3 p = object.polyhedron->origin + object.polyhedron->position(vertex);
  return object.transform.topLeftCorner<3, 3>() * p + object.transform.topRightCorner<3, 1>();
}

}  // namespace

Highlights pick_lasso(const SceneObject& object, const Projector& projector,
                      std::span<const Vector2> polygon) {
  Highlights out;
  if (!object.polyhedron || polygon.size() < 3) return out;
  const DisplayPolyhedron& polyhedron = *object.polyhedron;
  std::vector<char> held(polyhedron.positions.size(), 0);
  for (Index v = 0; v < held.size(); ++v) {
    const auto at = projector.project(world_of(object, v));
    held[v] = at && inside(polygon, at->head<2>());
    if (held[v]) out.vertices.push_back(v);
  }
  for (Index e = 0; e < polyhedron.edges.size(); ++e)
    if (held[polyhedron.edges[e][0]] && held[polyhedron.edges[e][1]]) out.edges.push_back(e);
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const auto corners = polyhedron.face(f);
    if (std::all_of(corners.begin(), corners.end(), [&](Index v) { return held[v] != 0; }))
      out.faces.push_back(f);
  }
  return out;
}

Occlusion::Occlusion(const Scene& scene, const Projector& projector)
    : projector_(projector),
      section_(scene.section),
      nearest_(static_cast<std::size_t>(projector.size().width) *
                   static_cast<std::size_t>(projector.size().height),
               -std::numeric_limits<float>::infinity()) {
  for (const SceneObject& object : scene.objects) {
    if (!object.polyhedron) continue;
    for (Index f = 0; f < object.polyhedron->face_count(); ++f) {
      const auto corners = object.polyhedron->face(f);
      Vector3 centre = Vector3::Zero();
      for (const Index v : corners) centre += world_of(object, v);
      centre /= static_cast<double>(corners.size());
      Vector3 last = world_of(object, corners.back());
      for (const Index v : corners) {
        const Vector3 here = world_of(object, v);
        draw(centre, last, here);
        last = here;
      }
    }
  }
}

double Occlusion::nearness(double depth) const {
  return projector_.camera().orthographic ? -depth : 1 / depth;
}

void Occlusion::draw(const Vector3& a, const Vector3& b, const Vector3& c) {
  const auto pa = projector_.project(a), pb = projector_.project(b), pc = projector_.project(c);
  if (!pa || !pb || !pc) return;
  const Vector2 p = pa->head<2>(), u = pb->head<2>() - p, v = pc->head<2>() - p;
  const double area = u.x() * v.y() - u.y() * v.x();
  if (std::abs(area) < 1e-9) return;
  const double na = nearness(pa->z()), nb = nearness(pb->z()), nc = nearness(pc->z());
  // How far a point is beyond the section is linear on the screen when it is divided by the depth.
  const auto beyond = [&](const Vector3& world, double depth) {
    if (!section_) return -1.0;
    const double distance = section_->normal.dot(world) - section_->offset;
    return projector_.camera().orthographic ? distance : distance / depth;
  };
  const double ba = beyond(a, pa->z()), bb = beyond(b, pb->z()), bc = beyond(c, pc->z());
  const auto bound = [](double x, int most) {
    return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(most)));
  };
  const PixelSize size = projector_.size();
  const double left = std::min({pa->x(), pb->x(), pc->x()}), right = std::max({pa->x(), pb->x(), pc->x()});
  const double top = std::min({pa->y(), pb->y(), pc->y()}), bottom = std::max({pa->y(), pb->y(), pc->y()});
  for (int y = bound(std::floor(top), size.height); y < bound(std::ceil(bottom), size.height); ++y)
    for (int x = bound(std::floor(left), size.width); x < bound(std::ceil(right), size.width); ++x) {
      const Vector2 d = Vector2(x + 0.5, y + 0.5) - p;
      const double s = (d.x() * v.y() - d.y() * v.x()) / area, t = (u.x() * d.y() - u.y() * d.x()) / area;
      if (s < 0 || t < 0 || s + t > 1 || ba + s * (bb - ba) + t * (bc - ba) > 0) continue;
      float& nearest = nearest_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                static_cast<std::size_t>(x)];
      nearest = std::max(nearest, static_cast<float>(na + s * (nb - na) + t * (nc - na)));
    }
}

bool Occlusion::visible(const Vector3& world) const {
  if (section_ && section_->cuts(world)) return false;
  const auto at = projector_.project(world);
  if (!at) return false;
  const int x = static_cast<int>(std::floor(at->x())), y = static_cast<int>(std::floor(at->y()));
  const PixelSize size = projector_.size();
  if (x < 0 || y < 0 || x >= size.width || y >= size.height) return true;  // nothing is known there
  const double slack = hiding_slack_pixels * projector_.pixel_length_at(world);
  const double nearest =
      static_cast<double>(nearest_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                   static_cast<std::size_t>(x)]);
  return nearness(std::max(at->z() - slack, 0.5 * at->z())) >= nearest;
}

Highlights Occlusion::visible(const Highlights& elements, const SceneObject& object) const {
  Highlights out;
  for (const Index v : elements.vertices)
    if (visible(world_of(object, v))) out.vertices.push_back(v);
  for (const Index e : elements.edges) {
    const Vector3 a = world_of(object, object.polyhedron->edges[e][0]);
    const Vector3 b = world_of(object, object.polyhedron->edges[e][1]);
    if (visible(0.5 * (a + b)) || visible(0.8 * a + 0.2 * b) || visible(0.2 * a + 0.8 * b))
      out.edges.push_back(e);
  }
  for (const Index f : elements.faces) {
    const auto corners = object.polyhedron->face(f);
    Vector3 centre = Vector3::Zero();
    for (const Index v : corners) centre += world_of(object, v);
    centre /= static_cast<double>(corners.size());
    if (visible(centre) || std::any_of(corners.begin(), corners.end(), [&](Index v) {
          return visible(0.5 * (centre + world_of(object, v)));
        }))
      out.faces.push_back(f);
  }
  return out;
}

}  // namespace hariko
