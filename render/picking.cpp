#include "render/picking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/ray_cast.hpp"
#include "render/scene.hpp"

namespace hariko {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double tie_pixels = 0.5;  // design pixels

struct FaceHit {
  Index face = no_index;
  double t = infinity;  ///< world distance along the ray
};

Vector3 world_position(const SceneObject& object, Index vertex) {
  const Vector3 p = object.polyhedron->origin + object.polyhedron->position(vertex);
  return object.transform.topLeftCorner<3, 3>() * p + object.transform.topRightCorner<3, 1>();
}

using Section = std::optional<SectionPlane>;

bool cut_away(const Section& section, const Vector3& world) {
  return section && section->cuts(world);
}

/// Foremost face of a polyhedron on the kept side of the section; faces are fans round their centres, as
/// drawn.
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
    // The coefficient opposite of a corner or side has no part in it, even where it is infinite.
    if (weights[i] > 0) out->value += weights[i] * double(mesh.value(corners[i]));
  }
  out->t = best * local.scale;
  out->point = ray.at(out->t);
  return out;
}

/// Distance along the ray to the nearest occluder: shown surfaces, and polyhedra without one.
double opaque_at(const Scene& scene, const Ray& ray, bool use_surface) {
  double best = infinity;
  for (const SceneObject& object : scene.objects) {
    if (use_surface && object.draws_surface()) {
      if (const auto hit = hit_surface(object, ray, best, scene.section)) best = hit->t;
    } else if (object.polyhedron) {
      best = std::min(best, hit_faces(object, ray, scene.section).t);
    }
  }
  return best;
}

/// Pixels and depths of the polyhedron's vertices; NaN behind the eye.
std::vector<Vector3> project_vertices(const SceneObject& object, const Projector& projector) {
  const std::size_t count = object.polyhedron->positions.size();
  std::vector<Vector3> out(count);
  for (std::size_t v = 0; v < count; ++v)
    out[v] = projector.project(world_position(object, static_cast<Index>(v)))
                 .value_or(Vector3::Constant(std::numeric_limits<double>::quiet_NaN()));
  return out;
}

/// Edge on the screen; an end behind the eye is moved to just in front of it.
struct ScreenEdge {
  Vector3 a, b;              ///< pixels and depth
  Vector3 world_a, world_b;  ///< world ends of the visible part
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
  const auto depth = [&](const Vector3& p) { return (p - camera.eye()).dot(camera.picture_forward()); };
  const double near_depth = camera.distance * 1e-3, da = depth(out.world_a), db = depth(out.world_b);
  if (std::max(da, db) <= near_depth) return std::nullopt;
  const Vector3 cut = out.world_a + (near_depth - da) / (db - da) * (out.world_b - out.world_a);
  const auto pixel = projector.project(cut);
  if (!pixel) return std::nullopt;
  (bad_a ? out.a : out.b) = *pixel;
  (bad_a ? out.world_a : out.world_b) = cut;
  return out;
}

/// State of one pick, with the hits so far.
class Search {
 public:
  Search(const Scene& scene, const Projector& projector, const Vector2& pixel, const PickOptions& options)
      : scene_(scene), projector_(projector), pixel_(pixel), options_(options) {}

  std::vector<PickHit> vertices();
  std::vector<PickHit> edges();
  std::vector<PickHit> faces();

 private:
  PickHit* add_if_near(std::size_t o, Index e, const ScreenEdge& edge, std::vector<PickHit>& hits) const;
  void add_curves(std::size_t o, std::vector<PickHit>& hits) const;
  bool has_pickable_elements(const SceneObject& object) const {
    return object.elements_pickable && (options_.copies || !object.copy);
  }
  bool visible(const PickHit& hit) const {
    if (!options_.visible_only) return true;
    // A straight line inside the surface is hidden where a curve represents the edge.
    const bool surface_hides =
        hit.kind == Element::Kind::edge && scene_.objects[hit.object].curves_pickable();
    const auto at = projector_.project(hit.point);
    if (!at) return false;
    const Ray ray = projector_.ray(at->head<2>());
    const double reach = (hit.point - ray.origin).norm();
    const double slack = hiding_slack_pixels * scene_.pixel_scale * projector_.pixel_length_at(hit.point);
    return opaque_at(scene_, ray, options_.use_surface || surface_hides) >= reach - slack;
  }
  /// Hits nearest to the cursor first, then nearest to the eye, without hidden ones.
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
    if (!object.polyhedron || !has_pickable_elements(object)) continue;
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
    if (!object.polyhedron || !has_pickable_elements(object)) continue;
    if (object.curves_pickable()) add_curves(o, hits);
    const std::vector<Vector3> pixels = project_vertices(object, projector_);
    for (Index e = 0; e < object.polyhedron->edges.size(); ++e)
      if (object.line_pickable(e))
        if (const auto edge = screen_edge(object, projector_, pixels, e)) add_if_near(o, e, *edge, hits);
  }
  return sorted(std::move(hits));
}

/// Adds a hit where the pixel is near part of an edge; null where it is not.
PickHit* Search::add_if_near(std::size_t o, Index e, const ScreenEdge& edge,
                             std::vector<PickHit>& hits) const {
  const Vector2 a = edge.a.head<2>(), along = edge.b.head<2>() - a;
  const double length2 = along.squaredNorm();
  const double x = length2 > 0 ? std::clamp((pixel_ - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  const double distance = (a + x * along - pixel_).norm();
  if (distance > options_.edge_radius * scene_.pixel_scale) return nullptr;
  // Weighs by depth: equal steps on the screen are not equal steps in space.
  const double da = edge.a.z(), db = edge.b.z();
  const double y = projector_.camera().orthographic ? x : x * da / (x * da + (1 - x) * db);
  const Vector3 point = edge.world_a + y * (edge.world_b - edge.world_a);
  if (cut_away(scene_.section, point)) return nullptr;
  const DisplayPolyhedron& polyhedron = *scene_.objects[o].polyhedron;
  PickHit hit{o,        Element::Kind::edge, e, element_of(polyhedron.edge_id(e)), point,
              distance, da + y * (db - da)};
  const Vector3 first = world_position(scene_.objects[o], polyhedron.edges[e][0]);
  const Vector3 last = world_position(scene_.objects[o], polyhedron.edges[e][1]);
  const Vector3 way = last - first;
  if (way.squaredNorm() > 0) hit.share = std::clamp((point - first).dot(way) / way.squaredNorm(), 0.0, 1.0);
  hits.push_back(hit);
  return &hits.back();
}

/// Adds the nearest point of each curve.
void Search::add_curves(std::size_t o, std::vector<PickHit>& hits) const {
  const SceneObject& object = scene_.objects[o];
  const EdgeCurves& curves = *object.edge_curves;
  std::vector<PickHit> near;
  for (Index e = 0; e < object.polyhedron->edges.size(); ++e)
    for (const EdgeCurves::Run& run : curves.of(e)) {
      near.clear();
      const auto segments = curves.segments(run);
      const double step = 1.0 / static_cast<double>(segments.size());
      Vector3 last = object.mesh_vertex(segments.front().vertices[1]);
      auto last_pixel = projector_.project(last);
      for (std::size_t i = 0; i < segments.size(); ++i) {
        const Vector3 here = object.mesh_vertex(segments[i].vertices[2]);
        const auto pixel = projector_.project(here);
        PickHit* hit =
            last_pixel && pixel ? add_if_near(o, e, {*last_pixel, *pixel, last, here}, near) : nullptr;
        if (hit) {
          const double within = (here - last).norm();
          hit->on_curve = true;
          hit->share = step * (double(i) + (within > 0 ? (hit->point - last).norm() / within : 0.0));
        }
        last = here;
        last_pixel = pixel;
      }
      const auto best = std::min_element(near.begin(), near.end(), [](const PickHit& a, const PickHit& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.depth < b.depth;
      });
      if (best == near.end()) continue;
      const auto forward = runs_forward(object, e, run);
      best->share = forward ? std::optional(*forward ? *best->share : 1 - *best->share) : std::nullopt;
      hits.push_back(*best);
    }
}

std::vector<PickHit> Search::faces() {
  std::vector<PickHit> hits;
  const Ray ray = projector_.ray(pixel_);
  const double slope = ray.direction.dot(projector_.camera().picture_forward());
  for (std::size_t o = 0; o < scene_.objects.size(); ++o) {
    const SceneObject& object = scene_.objects[o];
    PickHit hit{o, Element::Kind::face, no_index, {}, {}, 0, infinity};
    double t = infinity;
    if (options_.use_surface && object.draws_surface()) {
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
    if (!scene.objects[o].draws_surface()) continue;
    if (auto hit = hit_surface(scene.objects[o], ray, best ? best->t : infinity, scene.section)) {
      hit->object = o;
      best = hit;
    }
  }
  return best;
}

}  // namespace hariko
