#include "render/picking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/ray_cast.hpp"

namespace hariko {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double tie_pixels = 0.5;  // design pixels, as below
// Elements of an interpolated polyhedron lie on the surface; so many pixels' length in front of them do not
// hide them.
constexpr double hiding_slack_pixels = 5;

struct FaceHit {
  Index face = no_index;
  double t = infinity;  ///< world length along the ray
};

Vector3 world_position(const SceneObject& object, Index vertex) {
  const Vector3 p = object.polyhedron->origin + object.polyhedron->position(vertex);
  return object.transform.topLeftCorner<3, 3>() * p + object.transform.topRightCorner<3, 1>();
}

using Section = std::optional<SectionPlane>;

bool cut_away(const Section& section, const Vector3& world) {
  return section && section->cuts(world);
}

/// The front-most face of a polyhedron that the section leaves; faces are fans round their centres, as they
/// are drawn.
FaceHit hit_faces(const SceneObject& object, const Ray& ray, const Section& section) {
  const DisplayPolyhedron& polyhedron = *object.polyhedron;
  const LocalRay local = to_local(ray, object.transform, polyhedron.origin);
  FaceHit best;
  if (polyhedron.box.isEmpty() || !meets(local.ray, polyhedron.box, infinity)) return best;
  for (std::size_t f = 0; f < polyhedron.face_count(); ++f) {
    const auto vertices = polyhedron.face(f);
    Vector3 centre = Vector3::Zero();
    for (const Index v : vertices) centre += polyhedron.position(v);
    centre /= static_cast<double>(vertices.size());
    Vector3 last = polyhedron.position(vertices.back());
    for (const Index v : vertices) {
      const Vector3 here = polyhedron.position(v);
      const auto hit = hit_triangle(local.ray, centre, last, here);
      if (hit && hit->t * local.scale < best.t && !cut_away(section, ray.at(hit->t * local.scale)))
        best = {static_cast<Index>(f), hit->t * local.scale};
      last = here;
    }
  }
  return best;
}

bool shows_surface(const SceneObject& object) {
  return object.mesh && object.show_surface && object.mesh->patch_count() > 0;
}

std::optional<SurfaceHit> hit_surface(const SceneObject& object, const Ray& ray, double limit,
                                      const Section& section) {
  const DisplayMesh& mesh = *object.mesh;
  const LocalRay local = to_local(ray, object.transform, mesh.origin());
  const auto triangles = mesh.pattern().triangles();
  const std::size_t n = mesh.vertices_per_patch();
  double best = limit / local.scale;
  std::optional<SurfaceHit> out;
  std::array<std::size_t, 3> corners{};
  TriangleHit where;
  if (!meets(local.ray, mesh.box(), best)) return out;
  for (std::size_t c = 0; c < mesh.chunks().size(); ++c) {
    const DisplayMesh::Chunk& chunk = *mesh.chunks()[c];
    if (!meets(local.ray, chunk.box, best)) continue;
    const auto at = [&](std::size_t i) {
      const auto& p = chunk.vertices[i].position;
      return Vector3(double(p[0]), double(p[1]), double(p[2]));
    };
    for (std::size_t base = 0; base < chunk.vertices.size(); base += n)
      for (const auto& triangle : triangles) {
        const std::size_t i = base + std::size_t(triangle[0]), j = base + std::size_t(triangle[1]),
                          k = base + std::size_t(triangle[2]);
        const auto hit = hit_triangle(local.ray, at(i), at(j), at(k));
        if (!hit || hit->t >= best || cut_away(section, ray.at(hit->t * local.scale))) continue;
        best = hit->t;
        where = *hit;
        const std::size_t offset = c * DisplayMesh::patches_per_chunk * n;
        corners = {offset + i, offset + j, offset + k};
        out = SurfaceHit{};
        out->patch = static_cast<Index>((offset + base) / n);
      }
  }
  if (!out) return out;
  const std::vector<Vector2> parameters = mesh.pattern().parameters();
  const std::array<double, 3> weights{1 - where.b - where.c, where.b, where.c};
  for (std::size_t i = 0; i < 3; ++i) {
    out->parameter += weights[i] * parameters[corners[i] % n];
    out->value += weights[i] * double(mesh.value(corners[i]));
  }
  out->t = best * local.scale;
  out->point = ray.at(out->t);
  return out;
}

/// Distance along the ray at which the scene is opaque: what is drawn hides, surfaces before bare polyhedra.
double opaque_at(const Scene& scene, const Ray& ray, bool use_surface) {
  double best = infinity;
  for (const SceneObject& object : scene.objects) {
    if (use_surface && shows_surface(object)) {
      if (const auto hit = hit_surface(object, ray, best, scene.section)) best = hit->t;
    } else if (object.polyhedron) {
      best = std::min(best, hit_faces(object, ray, scene.section).t);
    }
  }
  return best;
}

/// Polyhedron vertices as pixels and depths; NaN behind the eye.
std::vector<Vector3> project_vertices(const SceneObject& object, const Projector& projector) {
  const std::size_t count = object.polyhedron->positions.size();
  std::vector<Vector3> out(count);
  for (std::size_t v = 0; v < count; ++v)
    out[v] = projector.project(world_position(object, static_cast<Index>(v)))
                 .value_or(Vector3::Constant(std::numeric_limits<double>::quiet_NaN()));
  return out;
}

/// An edge on the screen. Where an end lies behind the eye it is moved to just in front.
struct ScreenEdge {
  Vector3 a, b;              ///< pixels and depth
  Vector3 world_a, world_b;  ///< the ends of that piece
};
std::optional<ScreenEdge> screen_edge(const SceneObject& object, const Projector& projector,
                                      const std::vector<Vector3>& pixels, Index edge) {
  const auto [i, j] = object.polyhedron->edges[edge];
  ScreenEdge out{pixels[i], pixels[j], {}, {}};
  const bool bad_a = std::isnan(out.a.z()), bad_b = std::isnan(out.b.z());
  if (bad_a && bad_b) return std::nullopt;
  out.world_a = world_position(object, i);
  out.world_b = world_position(object, j);
  if (!bad_a && !bad_b) return out;
  const Camera& camera = projector.camera();
  const auto depth = [&](const Vector3& p) { return (p - camera.eye()).dot(camera.forward()); };
  const double near_depth = camera.distance * 1e-3, da = depth(out.world_a), db = depth(out.world_b);
  if (std::max(da, db) <= near_depth) return std::nullopt;
  const Vector3 cut = out.world_a + (near_depth - da) / (db - da) * (out.world_b - out.world_a);
  const auto pixel = projector.project(cut);
  if (!pixel) return std::nullopt;
  (bad_a ? out.a : out.b) = *pixel;
  (bad_a ? out.world_a : out.world_b) = cut;
  return out;
}

/// Everything that one pick needs, and the hits so far.
class Search {
 public:
  Search(const Scene& scene, const Projector& projector, const Vector2& pixel, const PickOptions& options)
      : scene_(scene), projector_(projector), pixel_(pixel), options_(options) {}

  std::vector<PickHit> vertices();
  std::vector<PickHit> edges();
  std::vector<PickHit> faces();

 private:
  bool visible(const PickHit& hit) const {
    if (!options_.visible_only) return true;
    const auto at = projector_.project(hit.point);
    if (!at) return false;
    const Ray ray = projector_.ray(at->head<2>());
    const double reach = (hit.point - ray.origin).norm();
    const double slack = hiding_slack_pixels * scene_.pixel_scale * projector_.pixel_length_at(hit.point);
    return opaque_at(scene_, ray, options_.use_surface) >= reach - slack;
  }
  /// Nearest to the cursor first, then nearest to the eye; hidden ones dropped.
  std::vector<PickHit> sorted(std::vector<PickHit> hits) const {
    const double tie = tie_pixels * scene_.pixel_scale;
    std::sort(hits.begin(), hits.end(), [tie](const PickHit& x, const PickHit& y) {
      const double dx = std::floor(x.distance / tie), dy = std::floor(y.distance / tie);
      return dx != dy ? dx < dy : x.depth < y.depth;
    });
    std::erase_if(hits, [&](const PickHit& hit) { return !visible(hit); });
    return hits;
  }

  const Scene& scene_;
  const Projector& projector_;
  Vector2 pixel_;
  const PickOptions& options_;
};

std::vector<PickHit> Search::vertices() {
  std::vector<PickHit> hits;
  for (std::size_t o = 0; o < scene_.objects.size(); ++o) {
    const SceneObject& object = scene_.objects[o];
    if (!object.polyhedron || !object.elements_pickable) continue;
    for (std::size_t v = 0; v < object.polyhedron->positions.size(); ++v) {
      const Vector3 world = world_position(object, static_cast<Index>(v));
      const auto at = projector_.project(world);
      if (!at) continue;
      const double distance = (at->head<2>() - pixel_).norm();
      if (distance <= options_.vertex_radius * scene_.pixel_scale && !cut_away(scene_.section, world))
        hits.push_back({o, Element::Kind::vertex, static_cast<Index>(v),
                        element_of(object.polyhedron->vertex_ids[v]), world, distance, at->z()});
    }
  }
  return sorted(std::move(hits));
}

std::vector<PickHit> Search::edges() {
  std::vector<PickHit> hits;
  for (std::size_t o = 0; o < scene_.objects.size(); ++o) {
    const SceneObject& object = scene_.objects[o];
    if (!object.polyhedron || !object.elements_pickable) continue;
    const std::vector<Vector3> pixels = project_vertices(object, projector_);
    for (Index e = 0; e < object.polyhedron->edges.size(); ++e) {
      const auto edge = screen_edge(object, projector_, pixels, e);
      if (!edge) continue;
      const Vector2 a = edge->a.head<2>(), along = edge->b.head<2>() - a;
      const double length2 = along.squaredNorm();
      const double x = length2 > 0 ? std::clamp((pixel_ - a).dot(along) / length2, 0.0, 1.0) : 0.0;
      const double distance = (a + x * along - pixel_).norm();
      if (distance > options_.edge_radius * scene_.pixel_scale) continue;
      // Equal steps on the screen are not equal steps in space: weigh by depth.
      const double da = edge->a.z(), db = edge->b.z();
      const double y = projector_.camera().orthographic ? x : x * da / (x * da + (1 - x) * db);
      const Vector3 point = edge->world_a + y * (edge->world_b - edge->world_a);
      if (cut_away(scene_.section, point)) continue;
      hits.push_back({o, Element::Kind::edge, e, element_of(object.polyhedron->edge_id(e)), point, distance,
                      da + y * (db - da)});
    }
  }
  return sorted(std::move(hits));
}

std::vector<PickHit> Search::faces() {
  std::vector<PickHit> hits;
  const Ray ray = projector_.ray(pixel_);
  const double slope = ray.direction.dot(projector_.camera().forward());
  for (std::size_t o = 0; o < scene_.objects.size(); ++o) {
    const SceneObject& object = scene_.objects[o];
    PickHit hit{o, Element::Kind::face, no_index, {}, {}, 0, infinity};
    double t = infinity;
    if (options_.use_surface && shows_surface(object)) {
      if (const auto at = hit_surface(object, ray, infinity, scene_.section)) {
        t = at->t;
        hit.element = object.mesh->provenance(at->patch).element;
        if (object.polyhedron && hit.element.kind == Element::Kind::face) {
          const auto& ids = object.polyhedron->face_ids;
          const FaceId id{static_cast<std::uint32_t>(hit.element.id)};
          const auto found = std::lower_bound(ids.begin(), ids.end(), id);
          if (found != ids.end() && *found == id) hit.index = static_cast<Index>(found - ids.begin());
        }
      }
    } else if (object.polyhedron) {
      const FaceHit at = hit_faces(object, ray, scene_.section);
      t = at.t;
      hit.index = at.face;
      if (at.face != no_index) hit.element = element_of(object.polyhedron->face_ids[at.face]);
    }
    if (!std::isfinite(t)) continue;
    hit.point = ray.at(t);
    hit.depth = t * slope;
    hits.push_back(hit);
  }
  std::sort(hits.begin(), hits.end(), [](const PickHit& x, const PickHit& y) { return x.depth < y.depth; });
  return hits;
}

struct Rectangle {
  Vector2 low, high;
  bool holds(const Vector2& p) const {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  }
  /// Liang and Barsky: does any part of the segment lie inside?
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

}  // namespace

std::vector<PickHit> pick_all(const Scene& scene, const Projector& projector, const Vector2& pixel,
                              const PickOptions& options) {
  Search search(scene, projector, pixel, options);
  std::vector<PickHit> hits;
  if (options.vertices) hits = search.vertices();
  if (hits.empty() && options.edges) hits = search.edges();
  if (hits.empty() && options.faces) hits = search.faces();
  return hits;
}

std::optional<PickHit> pick(const Scene& scene, const Projector& projector, const Vector2& pixel,
                            const PickOptions& options) {
  const std::vector<PickHit> hits = pick_all(scene, projector, pixel, options);
  return hits.empty() ? std::nullopt : std::optional<PickHit>(hits.front());
}

std::optional<SurfaceHit> pick_surface(const Scene& scene, const Ray& ray) {
  std::optional<SurfaceHit> best;
  for (std::size_t o = 0; o < scene.objects.size(); ++o) {
    if (!shows_surface(scene.objects[o])) continue;
    if (auto hit = hit_surface(scene.objects[o], ray, best ? best->t : infinity, scene.section)) {
      hit->object = o;
      best = hit;
    }
  }
  return best;
}

Highlights pick_box(const SceneObject& object, const Projector& projector, const PixelBox& box,
                    bool crossing) {
  Highlights out;
  if (!object.polyhedron) return out;
  const DisplayPolyhedron& polyhedron = *object.polyhedron;
  const Rectangle area{box.first.cwiseMin(box.second), box.first.cwiseMax(box.second)};
  const std::vector<Vector3> pixels = project_vertices(object, projector);
  std::vector<char> inside(pixels.size(), 0);
  for (std::size_t v = 0; v < pixels.size(); ++v) {
    inside[v] = !std::isnan(pixels[v].z()) && area.holds(pixels[v].head<2>());
    if (inside[v]) out.vertices.push_back(static_cast<Index>(v));
  }
  const auto edge_touches = [&](Index a, Index b) {
    if (std::isnan(pixels[a].z()) || std::isnan(pixels[b].z())) return inside[a] != 0 || inside[b] != 0;
    return area.touches(pixels[a].head<2>(), pixels[b].head<2>());
  };
  for (Index e = 0; e < polyhedron.edges.size(); ++e) {
    const auto [a, b] = polyhedron.edges[e];
    if (crossing ? edge_touches(a, b) : (inside[a] && inside[b])) out.edges.push_back(e);
  }
  for (std::size_t f = 0; f < polyhedron.face_count(); ++f) {
    const auto vertices = polyhedron.face(f);
    bool taken = !crossing;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (crossing)
        taken = taken || edge_touches(vertices[i], vertices[(i + 1) % vertices.size()]);
      else
        taken = taken && inside[vertices[i]];
    }
    if (taken) out.faces.push_back(static_cast<Index>(f));
  }
  return out;
}

}  // namespace hariko
