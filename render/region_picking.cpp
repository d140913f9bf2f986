#include "render/region_picking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/geometry/polygon.hpp"

namespace hariko {

namespace {

struct Rectangle {
  Vector2 low, high;
  bool holds(const Vector2& p) const {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  }
  /// Whether any part of a segment lies inside (Liang and Barsky 1984).
  bool touches(const Vector2& a, const Vector2& b) const {
    double first = 0, last = 1;
    const Vector2 d = b - a;
    for (int i = 0; i < 2; ++i) {
      if (d[i] == 0) {
        if (a[i] < low[i] || a[i] > high[i]) return false;
        continue;
      }
      const double x = (low[i] - a[i]) / d[i], y = (high[i] - a[i]) / d[i];
      first = std::max(first, std::min(x, y));
      last = std::min(last, std::max(x, y));
    }
    return first <= last;
  }
};

/// Region of a lasso, which only takes what lies wholly inside.
struct Lasso {
  std::span<const Vector2> polygon;
  bool holds(const Vector2& p) const { return inside_polygon(polygon, p); }
  bool touches(const Vector2&, const Vector2&) const { return false; }
};

Vector3 world_of(const SceneObject& object, Index vertex) {
  const Vector3 p = object.polyhedron->origin + object.polyhedron->position(vertex);
  return object.transform.topLeftCorner<3, 3>() * p + object.transform.topRightCorner<3, 1>();
}

using Pixels = std::vector<std::optional<Vector2>>;  // empty for points behind the eye

/// Whether a region takes a polyline: all points inside or, with `crossing`, a line between neighbours
/// touched.
template <class Region>
bool takes(const Region& region, bool crossing, std::span<const std::optional<Vector2>> points, bool closed) {
  const auto holds = [&](const std::optional<Vector2>& p) { return p && region.holds(*p); };
  if (!crossing) return !points.empty() && std::all_of(points.begin(), points.end(), holds);
  for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i) {
    const auto &a = points[i > 0 ? i - 1 : points.size() - 1], &b = points[i];
    if (a && b ? region.touches(*a, *b) : holds(a) || holds(b)) return true;
  }
  return false;
}

/// Pixels of the points of a curve.
Pixels pixels_of(const SceneObject& object, const Projector& projector,
                 std::span<const CurveSegment> segments) {
  Pixels out;
  const auto add = [&](Index vertex) {
    const auto at = projector.project(object.mesh_vertex(vertex));
    out.push_back(at ? std::optional<Vector2>(at->head<2>()) : std::nullopt);
  };
  add(segments.front().vertices[1]);
  for (const CurveSegment& segment : segments) add(segment.vertices[2]);
  return out;
}

/// Consecutive patches of one face: the face itself, or its image in a live mirror.
struct FacePatches {
  Index face = no_index, first = 0, end = 0;
};
std::vector<FacePatches> faces_on_surface(const SceneObject& object) {
  std::vector<FacePatches> out;
  const DisplayMesh& mesh = *object.mesh;
  const auto& ids = object.polyhedron->face_ids;
  for (Index p = 0; p < mesh.patch_count(); ++p) {
    const Element& element = mesh.provenance(p).element;
    Index face = no_index;
    if (element.kind == Element::Kind::face) {
      const FaceId id{static_cast<std::uint32_t>(element.id)};
      const auto at = std::lower_bound(ids.begin(), ids.end(), id);
      if (at != ids.end() && *at == id) face = static_cast<Index>(at - ids.begin());
    }
    if (face != no_index && !out.empty() && out.back().face == face && out.back().end == p)
      ++out.back().end;
    else if (face != no_index)
      out.push_back({face, p, p + 1});
  }
  return out;
}

/// Whether a region takes the patches of a face: all points inside or, with `crossing`, a grid line touched.
template <class Region>
bool takes(const Region& region, bool crossing, const SceneObject& object, const Projector& projector,
           const FacePatches& patches) {
  const DisplayMesh& mesh = *object.mesh;
  const auto triangles = mesh.pattern().triangles();
  const std::size_t n = mesh.vertices_per_patch();
  Pixels pixels(n);
  for (std::size_t p = patches.first; p < patches.end; ++p) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = projector.project(object.mesh_vertex(p * n + i));
      pixels[i] = at ? std::optional<Vector2>(at->head<2>()) : std::nullopt;
    }
    if (!crossing && !takes(region, false, pixels, false)) return false;
    for (const auto& t : triangles) {
      const std::array corners{pixels[std::size_t(t[0])], pixels[std::size_t(t[1])],
                               pixels[std::size_t(t[2])]};
      if (crossing && takes(region, true, corners, true)) return true;
    }
  }
  return !crossing;
}

template <class Region>
Highlights elements_in(const SceneObject& object, const Projector& projector, const Region& region,
                       bool crossing, const ElementKinds& kinds) {
  Highlights out;
  const DisplayPolyhedron& polyhedron = *object.polyhedron;
  Pixels corners(polyhedron.positions.size());
  for (Index v = 0; v < corners.size(); ++v) {
    if (const auto at = projector.project(world_of(object, v))) corners[v] = at->head<2>();
    if (kinds.vertices && corners[v] && region.holds(*corners[v])) out.vertices.push_back(v);
  }
  for (Index e = 0; kinds.edges && e < polyhedron.edges.size(); ++e) {
    const std::array ends{corners[polyhedron.edges[e][0]], corners[polyhedron.edges[e][1]]};
    bool taken = object.line_pickable(e) && takes(region, crossing, ends, false);
    if (!taken && object.curves_pickable())
      for (const EdgeCurves::Run& run : object.edge_curves->of(e))
        taken = taken || takes(region, crossing,
                               pixels_of(object, projector, object.edge_curves->segments(run)), false);
    if (taken) out.edges.push_back(e);
  }
  if (!kinds.faces) return out;
  std::vector<char> taken(polyhedron.face_count(), 0), seen(polyhedron.face_count(), 0);
  if (object.elements_on_surface())
    for (const FacePatches& patches : faces_on_surface(object)) {
      seen[patches.face] = 1;
      taken[patches.face] = taken[patches.face] || takes(region, crossing, object, projector, patches);
    }
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    if (!seen[f]) {
      Pixels own;
      for (const Index v : polyhedron.face(f)) own.push_back(corners[v]);
      taken[f] = takes(region, crossing, own, true);
    }
    if (taken[f]) out.faces.push_back(f);
  }
  return out;
}

}  // namespace

Highlights pick_box(const SceneObject& object, const Projector& projector, const PixelBox& box, bool crossing,
                    const ElementKinds& kinds) {
  if (!object.polyhedron) return {};
  return elements_in(object, projector,
                     Rectangle{box.first.cwiseMin(box.second), box.first.cwiseMax(box.second)}, crossing,
                     kinds);
}

Highlights pick_lasso(const SceneObject& object, const Projector& projector, std::span<const Vector2> polygon,
                      const ElementKinds& kinds) {
  if (!object.polyhedron || polygon.size() < 3) return {};
  return elements_in(object, projector, Lasso{polygon}, false, kinds);
}

Occlusion::Occlusion(const Scene& scene, const Projector& projector)
    : projector_(projector),
      section_(scene.section),
      slack_(hiding_slack_pixels * scene.pixel_scale),
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
  // Distance beyond the section plane; divided by the depth it is linear on the screen.
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
  const double slack = slack_ * projector_.pixel_length_at(world);
  const double nearest =
      static_cast<double>(nearest_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                   static_cast<std::size_t>(x)]);
  return nearness(std::max(at->z() - slack, 0.5 * at->z())) >= nearest;
}

RegionSight::RegionSight(const Scene& scene, const Projector& projector)
    : section_(scene.section),
      polyhedra_(scene, projector),
      surfaces_(scene.objects, scene.section, projector, 4 * scene.pixel_scale) {}

bool RegionSight::on_surface(const Vector3& world) const {
  return !(section_ && section_->cuts(world)) && !surfaces_.hides(world);
}

bool RegionSight::edge_visible(const SceneObject& object, Index edge) const {
  if (object.curves_pickable() && object.edge_curves->covers(edge)) {
    for (const EdgeCurves::Run& run : object.edge_curves->of(edge)) {
      const auto segments = object.edge_curves->segments(run);
      const std::size_t step = std::max<std::size_t>(1, segments.size() / 6);
      for (std::size_t i = 0; i < segments.size(); i += step)
        if (on_surface(object.mesh_vertex(segments[i].vertices[2]))) return true;
    }
    return false;
  }
  const Vector3 a = world_of(object, object.polyhedron->edges[edge][0]);
  const Vector3 b = world_of(object, object.polyhedron->edges[edge][1]);
  return polyhedra_.visible(0.5 * (a + b)) || polyhedra_.visible(0.8 * a + 0.2 * b) ||
         polyhedra_.visible(0.2 * a + 0.8 * b);
}

bool RegionSight::face_visible(const SceneObject& object, Index face) const {
  const auto corners = object.polyhedron->face(face);
  Vector3 centre = Vector3::Zero();
  for (const Index v : corners) centre += world_of(object, v);
  centre /= static_cast<double>(corners.size());
  return polyhedra_.visible(centre) || std::any_of(corners.begin(), corners.end(), [&](Index v) {
           return polyhedra_.visible(0.5 * (centre + world_of(object, v)));
         });
}

Highlights RegionSight::visible(const Highlights& elements, const SceneObject& object) const {
  Highlights out;
  for (const Index v : elements.vertices)
    if (polyhedra_.visible(world_of(object, v))) out.vertices.push_back(v);
  for (const Index e : elements.edges)
    if (edge_visible(object, e)) out.edges.push_back(e);
  std::vector<char> on_mesh(object.polyhedron->face_count(), 0), seen(on_mesh.size(), 0);
  if (object.elements_on_surface() && !elements.faces.empty()) {
    const std::size_t n = object.mesh->vertices_per_patch(), step = std::max<std::size_t>(1, n / 12);
    for (const FacePatches& patches : faces_on_surface(object)) {
      on_mesh[patches.face] = 1;
      for (std::size_t i = patches.first * n; i < patches.end * n && !seen[patches.face]; i += step)
        seen[patches.face] = on_surface(object.mesh_vertex(i));
    }
  }
  for (const Index f : elements.faces)
    if (on_mesh[f] ? seen[f] != 0 : face_visible(object, f)) out.faces.push_back(f);
  return out;
}

}  // namespace hariko
