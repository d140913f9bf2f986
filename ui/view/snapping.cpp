#include "ui/view/snapping.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/view/overlay_drawing.hpp"

namespace hariko {

namespace {

/// Spans near the pointer that are tried against each other; where there are more, the nearest ones.
constexpr std::size_t most_near_spans = 300;

/// 10^n for n >= 0, exact up to 10^22.
double power_of_ten(int n) {
  double power = 1;
  for (int i = 0; i < n; ++i) power *= 10;
  return power;
}

/// A piece of a span round a place on it, as it is seen: for steps of Newton's method on the picture.
struct SeenPiece {
  Vector2 begin, end;
  double from, width;  ///< fractions of the span

  double share(double of_piece) const { return std::clamp(from + of_piece * width, 0.0, 1.0); }
};

std::optional<SeenPiece> seen_piece(const Projector& projector, const SampledCurve& line, std::size_t span,
                                    double share) {
  constexpr double half = 0.01;
  const double from = std::clamp(share - half, 0.0, 1 - 2 * half);
  const auto begin = projector.project(point_of(line, span, from));
  const auto end = projector.project(point_of(line, span, from + 2 * half));
  if (!begin || !end) return {};
  return SeenPiece{begin->head<2>(), end->head<2>(), from, 2 * half};
}

constexpr int newton_steps = 5;

}  // namespace

const char* snap_name(SnapTarget::Kind kind) {
  return name_among(kind, {"Vertex", "Midpoint", "Centre", "Intersection", "Perpendicular", "Tangent",
                           "On a curve", "On a surface", "Grid"});
}

bool snaps_now(const Editor& editor, bool control) {
  return control != editor.settings.snaps.always;
}

double DecimalStep::size() const {
  return exponent < 0 ? mantissa / power_of_ten(-exponent) : mantissa * power_of_ten(exponent);
}

double DecimalStep::nearest(double value) const {
  const double count = std::round(value / size()) * mantissa;
  return exponent < 0 ? count / power_of_ten(-exponent) : count * power_of_ten(exponent);
}

DecimalStep grid_step(const ToolContext& context, const Vector3& at) {
  constexpr double least_pixels = 10;
  const double length = least_pixels * context.editor.pixel_scale * context.projector().pixel_length_at(at);
  return {1, std::clamp(static_cast<int>(std::ceil(std::log10(length))), -12, 12)};
}

Vector3 on_grid(const ToolContext& context, const PlaneFrame& plane, const Vector3& point) {
  const DecimalStep step = grid_step(context, point);
  Vector3 local = plane.local(point);
  for (int axis = 0; axis < 2; ++axis) local[axis] = step.nearest(local[axis]);
  local.z() = 0;
  return plane.at(local);
}

std::optional<Vector3> point_on_plane(const ToolContext& context, const PlaneFrame& plane, const Ray& ray,
                                      bool snaps) {
  constexpr double least_slope = 0.02;
  const auto t = where_ray_meets(plane, ray.origin, ray.direction, least_slope);
  if (!t || !(*t > 0)) return {};
  const Vector3 point = plane.foot(ray.at(*t));
  return snaps && context.editor.settings.snaps.grid ? on_grid(context, plane, point) : point;
}

/// The best place so far.
class SnapPlaces::Search {
 public:
  Search(const ToolContext& context, const Vector2& pointer)
      : projector(context.projector()),
        pixel(pointer),
        reach(snap_radius * context.editor.pixel_scale),
        least_(reach) {}

  std::optional<double> distance(const Vector3& point) const {
    const auto at = projector.project(point);
    return at ? std::optional((at->head<2>() - pixel).norm()) : std::nullopt;
  }
  bool better(const Vector3& point) const {
    const auto away = distance(point);
    return away && *away < least_;
  }
  void offer(SnapTarget::Kind kind, const Vector3& point, ObjectId object) {
    const auto away = distance(point);
    if (!away || !(*away < least_)) return;
    least_ = *away;
    best = SnapTarget{kind, point, object};
  }

  const Projector projector;
  const Vector2 pixel;
  const double reach;  ///< pixels
  std::optional<SnapTarget> best;

 private:
  double least_;
};

bool SnapPlaces::stands(const SnapGesture& gesture, const Held& held) const {
  if (!gesture.moving) return true;
  const auto begin = vertices_of_.begin() + static_cast<std::ptrdiff_t>(held.first);
  return std::all_of(begin, begin + static_cast<std::ptrdiff_t>(held.count),
                     [&](VertexId id) { return gesture.moving->stands(held.object, id); });
}

std::optional<SnapTarget> SnapPlaces::nearest(const ToolContext& context, const SnapGesture& gesture,
                                              const Vector2& pixel) const {
  Search search(context, pixel);
  const auto look = [&](SnapTarget::Kind kind, const std::vector<Place>& places) {
    for (const Place& place : places)
      if (search.better(place.point) && stands(gesture, place.held))
        search.offer(kind, place.point, place.held.object);
  };
  const SnapSettings& on = gesture.kinds;
  if (on.vertices) look(SnapTarget::Kind::vertex, vertices_);
  if (search.best) return search.best;
  if (on.midpoints) look(SnapTarget::Kind::midpoint, middles_);
  if (on.centres) look(SnapTarget::Kind::centre, centres_);
  look_along_curves(gesture, search);
  if (!search.best && on.surfaces) look_on_surfaces(context, gesture, search);
  return search.best;
}

void SnapPlaces::look_along_curves(const SnapGesture& gesture, Search& search) const {
  const SnapSettings& on = gesture.kinds;
  const bool from_start = gesture.from && (on.perpendicular || on.tangent);
  if (!on.crossings && !on.curves && !from_start) return;
  const std::vector<NearSpan> spans = near_spans(gesture, search);
  if (on.crossings) look_for_crossings(spans, search);
  const Curve* last = nullptr;
  for (const NearSpan& near : spans) {
    if (!from_start || near.curve == last) continue;
    last = near.curve;
    const ObjectId object = last->held.object;
    if (on.perpendicular)
      for (const Vector3& foot : perpendicular_feet(last->line, *gesture.from))
        search.offer(SnapTarget::Kind::perpendicular, foot, object);
    if (on.tangent)
      for (const Vector3& place : tangent_places(last->line, *gesture.from, gesture.normal))
        search.offer(SnapTarget::Kind::tangent, place, object);
  }
  if (!search.best && on.curves) look_on_curves(spans, search);
}

/// In the order of the curves.
std::vector<SnapPlaces::NearSpan> SnapPlaces::near_spans(const SnapGesture& gesture,
                                                         const Search& search) const {
  std::vector<NearSpan> out;
  for (const Curve& curve : curves_) {
    const std::vector<Vector3>& points = curve.line.points;
    const std::size_t count = points.size() - (curve.line.closed ? 0 : 1);
    auto begin = search.projector.project(points.front());
    std::optional<bool> fixed;  // asked for once, where the curve is near
    for (std::size_t i = 0; i < count; ++i) {
      const auto end = search.projector.project(points[(i + 1) % points.size()]);
      const auto from = std::exchange(begin, end);
      if (!from || !end) continue;
      const Vector2 a = from->head<2>(), b = end->head<2>();
      const double away = (a + nearest_share(a, b, search.pixel) * (b - a) - search.pixel).norm();
      if (!(away < search.reach)) continue;
      if (!fixed) fixed = stands(gesture, curve.held);
      if (!*fixed) break;
      out.push_back({&curve, i, a, b, away});
    }
  }
  return out;
}

void SnapPlaces::look_for_crossings(const std::vector<NearSpan>& spans, Search& search) {
  std::vector<NearSpan> near = spans;
  std::stable_sort(near.begin(), near.end(),
                   [](const NearSpan& a, const NearSpan& b) { return a.distance < b.distance; });
  if (near.size() > most_near_spans) near.resize(most_near_spans);
  for (std::size_t i = 0; i < near.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const NearSpan &a = near[i], &b = near[j];
      if (a.curve == b.curve) continue;
      const auto begun = where_segments_cross(a.begin, a.end, b.begin, b.end);
      if (!begun) continue;
      Vector2 shares = *begun;
      // The chords cross near to where the curves do.
      for (int step = 0; step < newton_steps; ++step) {
        const auto of_a = seen_piece(search.projector, a.curve->line, a.span, shares.x());
        const auto of_b = seen_piece(search.projector, b.curve->line, b.span, shares.y());
        const auto next =
            of_a && of_b ? where_lines_cross(of_a->begin, of_a->end, of_b->begin, of_b->end) : std::nullopt;
        if (!next) break;
        shares = {of_a->share(next->x()), of_b->share(next->y())};
      }
      const Vector3 on_a = point_of(a.curve->line, a.span, shares.x()),
                    on_b = point_of(b.curve->line, b.span, shares.y());
      const auto seen_a = search.projector.project(on_a), seen_b = search.projector.project(on_b);
      if (!seen_a || !seen_b) continue;
      // Curves that pass each other are taken at the one in front.
      const bool a_in_front = seen_a->z() <= seen_b->z();
      search.offer(SnapTarget::Kind::crossing, a_in_front ? on_a : on_b,
                   (a_in_front ? a : b).curve->held.object);
    }
}

void SnapPlaces::look_on_curves(const std::vector<NearSpan>& spans, Search& search) {
  for (const NearSpan& near : spans) {
    double share = nearest_share(near.begin, near.end, search.pixel);
    for (int step = 0; step < newton_steps; ++step) {
      const auto piece = seen_piece(search.projector, near.curve->line, near.span, share);
      const Vector2 along = piece ? Vector2(piece->end - piece->begin) : Vector2(Vector2::Zero());
      if (!(along.squaredNorm() > 0)) break;
      share = piece->share((search.pixel - piece->begin).dot(along) / along.squaredNorm());
    }
    search.offer(SnapTarget::Kind::curve, point_of(near.curve->line, near.span, share),
                 near.curve->held.object);
  }
}

void SnapPlaces::look_on_surfaces(const ToolContext& context, const SnapGesture& gesture, Search& search) {
  Scene scene = context.scene.scene();
  std::vector<ObjectId> ids;
  std::vector<SceneObject> standing;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const ObjectId id = context.scene.object_id(i);
    if (gesture.moving && gesture.moving->changes(id)) continue;
    ids.push_back(id);
    standing.push_back(std::move(scene.objects[i]));
  }
  scene.objects = std::move(standing);
  const auto hit = pick_surface(scene, search.projector.ray(search.pixel));
  const Object* object = hit ? context.editor.document().find(ids[hit->object]) : nullptr;
  if (!object) return;
  Vector3 point = hit->point;
  const SurfaceView* view = context.editor.view_of(object->id);
  const SceneObject& standing_there = scene.objects[hit->object];
  if (view && view->mesh == standing_there.mesh && hit->patch < view->surface.patch_count()) {
    const Vector3 local = view->surface.origin() +
                          view->surface.patches().evaluate(hit->patch, hit->parameter, Order::first).position;
    point = standing_there.copy ? standing_there.to_world(local, {}) : object->transform.apply(local);
  }
  search.best = SnapTarget{SnapTarget::Kind::surface, point, object->id};
}

namespace {

/// The mark of a kind of place: each has a shape of its own.
void draw_snap_mark(ImDrawList& list, SnapTarget::Kind kind, const ImVec2& c, float r, ImU32 colour,
                    float width) {
  const auto line = [&](float x0, float y0, float x1, float y1) {
    list.AddLine({c.x + x0 * r, c.y + y0 * r}, {c.x + x1 * r, c.y + y1 * r}, colour, width);
  };
  switch (kind) {
    case SnapTarget::Kind::vertex:
      return list.AddRect({c.x - r, c.y - r}, {c.x + r, c.y + r}, colour, 0, 0, width);
    case SnapTarget::Kind::midpoint:
      return list.AddTriangle({c.x, c.y - r}, {c.x + r, c.y + 0.75F * r}, {c.x - r, c.y + 0.75F * r}, colour,
                              width);
    case SnapTarget::Kind::centre:
      list.AddCircle(c, r, colour, 0, width);
      return list.AddCircleFilled(c, 0.3F * r, colour);
    case SnapTarget::Kind::crossing:
      line(-1, -1, 1, 1);
      return line(-1, 1, 1, -1);
    case SnapTarget::Kind::perpendicular:  // a right angle with its square
      line(-1, -1, -1, 1);
      line(-1, 1, 1, 1);
      line(-1, 0, 0, 0);
      return line(0, 0, 0, 1);
    case SnapTarget::Kind::tangent:
      list.AddCircle(c, 0.75F * r, colour, 0, width);
      return line(-1.2F, -0.75F, 1.2F, -0.75F);
    case SnapTarget::Kind::curve:  // an hourglass
      line(-1, -1, 1, -1);
      line(1, -1, -1, 1);
      line(-1, 1, 1, 1);
      return line(1, 1, -1, -1);
    case SnapTarget::Kind::surface:  // a diamond
      return list.AddQuad({c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}, {c.x - r, c.y}, colour, width);
    case SnapTarget::Kind::grid:
      line(-1, 0, 1, 0);
      return line(0, -1, 0, 1);
  }
}

}  // namespace

void SnapCatcher::update(const ToolContext& context) {
  const Editor& editor = context.editor;
  std::vector<std::shared_ptr<const DisplayMesh>> meshes;
  for (const SceneObject& object : context.scene.scene().objects) meshes.push_back(object.mesh);
  const bool same = places_ && kinds_ == editor.settings.snaps && document_ == editor.documents &&
                    serial_ == editor.history.serial() && meshes_ == meshes;
  if (same) return;
  meshes_ = std::move(meshes);
  kinds_ = editor.settings.snaps;
  document_ = editor.documents;
  serial_ = editor.history.serial();
  places_ = std::make_shared<const SnapPlaces>(context, kinds_);
}

std::optional<SnapTarget> SnapCatcher::find(const ToolContext& context, const Vector2& pixel,
                                            const std::optional<Vector3>& from, const Vector3& normal) const {
  if (!places_) return {};
  return places_->nearest(context, {kinds_, from, normal, nullptr}, pixel);
}

void draw_snap_target(const ToolContext& context, const ToolOverlay& overlay, const SnapTarget& target,
                      bool warning) {
  const auto at = context.projector().project(target.point);
  if (!at) return;
  const Metrics& m = overlay.metrics;
  const ImVec2 c = on_screen(overlay, at->head<2>());
  const float r = m.px(7), thick = m.px(1.8F);
  draw_snap_mark(overlay.list, target.kind, c, r, with_alpha(palette().window, 0.8F), 2.2F * thick);
  draw_snap_mark(overlay.list, target.kind, c, r, warning ? palette().warning : palette().hot, thick);
  const char* name = context.editor.language(snap_name(target.kind));
  const ImVec2 size = ImGui::CalcTextSize(name), padding(m.px(5), m.px(2));
  const ImVec2 low = overlay.list.GetClipRectMin(), high = overlay.list.GetClipRectMax();
  // Above the mark: the value stands below it.
  const float x = std::clamp(c.x + m.px(12), low.x, std::max(low.x, high.x - size.x - 2 * padding.x));
  const float y = std::max(low.y, c.y - m.px(14) - size.y - 2 * padding.y);
  overlay.list.AddRectFilled({x, y}, {x + size.x + 2 * padding.x, y + size.y + 2 * padding.y},
                             with_alpha(palette().popup, 0.9F), m.px(3));
  overlay.list.AddText({x + padding.x, y + padding.y}, palette().text, name);
}

}  // namespace hariko
