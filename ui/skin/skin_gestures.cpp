// Gestures: the meaning of strokes over a skin.

#include <algorithm>
#include <limits>
#include <map>

#include "core/geometry/polygon.hpp"
#include "ui/skin/skin_tools.hpp"

namespace hariko {

namespace {

Message no_gesture(const char* text, const char* remedy) {
  return make_error(e_no_gesture, text, remedy);
}

class Gesture {
 public:
  Gesture(const Skin& skin, const SkinView& view, const Object& object, const Projector& projector,
          double pixel_scale, const std::set<std::uint32_t>& hidden)
      : skin_(skin),
        view_(view),
        object_(object),
        projector_(projector),
        scale_(pixel_scale),
        hidden_(hidden) {
    for (const SkinView::Handle& handle : view.handles) {
      if (handle.kind == SkinView::Handle::Kind::path || handle.kind == SkinView::Handle::Kind::place)
        continue;
      const auto at = pixel(handle.position);
      if (!at) continue;
      // Limit points come after control points and take their place: they are what is seen.
      Point& point = points_[handle.id];
      if (handle.kind == SkinView::Handle::Kind::control) point.control = *at;
      point.at = *at;
      point.section = handle.section;
      point.depth = projector.project(object.transform.apply(handle.position))->z();
    }
  }

  Result<CorrespondenceEdit> line(const Vector2& from, const Vector2& to) const {
    const auto first = point_at(from), last = point_at(to);
    if (!first || !last)
      return no_gesture("The line does not begin and end at points.", "Draw from a point to a point.");
    const int a = points_.at(*first).section, b = points_.at(*last).section;
    if (a == b)
      return no_gesture("The line stays on one section.", "Draw from one section to its neighbour.");
    std::vector<std::uint32_t> chain{*first};
    for (const int k : sections_between(a, b)) {
      const auto crossing = crossing_with(k, from, to);
      if (!crossing)
        return no_gesture("The line passes a section beside its curve.",
                          "Draw from one section to its neighbour.");
      chain.push_back(nearest_of(k, crossing->pixel));
    }
    chain.push_back(*last);
    return join_points(skin_, chain);
  }

  Result<CorrespondenceEdit> lasso(const std::vector<Vector2>& polygon) const {
    std::vector<std::uint32_t> inside;
    std::map<int, int> sections;
    for (const auto& [id, point] : points_)
      if (!hidden_.contains(id) && inside_polygon(polygon, point.at))
        inside.push_back(id), ++sections[point.section];
    if (sections.size() < 2)
      return no_gesture("The curve goes round points of one section or none.",
                        "Draw it round points of neighbouring sections.");
    return group_points(skin_, inside);
  }

  Result<CorrespondenceEdit> wedge(const Vector2& from, const Vector2& tip, const Vector2& to) const {
    // The members are on the section that both legs cross farthest from the tip.
    int own = -1, crossed = 0;
    double farthest = 0, first = 0, last = 0;
    for (int k = 0; k < skin_.section_count(); ++k) {
      const auto x = crossing_with(k, from, tip), y = crossing_with(k, to, tip);
      if (!x || !y) continue;
      ++crossed;
      const double distance = std::min((x->pixel - tip).norm(), (y->pixel - tip).norm());
      if (distance > farthest) farthest = distance, own = k, first = x->parameter, last = y->parameter;
    }
    if (own < 0)
      return no_gesture("The legs of the wedge do not cross a section.",
                        "Begin and end the wedge on a section, around the points to merge.");
    const std::vector<std::uint32_t> members = points_between(own, first, last);
    if (members.size() < 2)
      return no_gesture("The wedge holds fewer than two points.",
                        "Draw it around more points of the section.");
    return merge_at(own, members, tip, crossed > 1);
  }

 private:
  struct Point {
    Vector2 at = Vector2::Zero(), control = Vector2::Zero();
    int section = -1;
    double depth = 0;
  };
  struct Crossing {
    Vector2 pixel = Vector2::Zero();
    double parameter = 0;  ///< parameter of the section's curve, 0 .. 1
  };

  std::optional<Vector2> pixel(const Vector3& point) const { return pixel_of(object_, projector_, point); }

  /// Within 14 pixels; of equally near ones that nearer to the eye.
  std::optional<std::uint32_t> point_at(const Vector2& place, int section = -1, double radius = 14) const {
    std::optional<std::uint32_t> best;
    double least = radius * scale_, depth = 0;
    for (const auto& [id, point] : points_) {
      if ((section >= 0 && point.section != section) || hidden_.contains(id)) continue;
      const double distance =
          std::min((point.at - place).norm(), (point.control - place).norm() + 2 * scale_);
      const bool nearer = distance < least - 2 * scale_ ||
                          (distance < least && best && point.depth < depth) || (distance < least && !best);
      if (nearer) best = id, least = std::max(distance, 0.0), depth = point.depth;
    }
    return best;
  }

  std::uint32_t nearest_of(int section, const Vector2& place) const {
    std::uint32_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [id, point] : points_)
      if (point.section == section && (point.at - place).norm() < least)
        least = (point.at - place).norm(), best = id;
    return best;
  }

  /// Those passed on the shorter way from one section to another.
  std::vector<int> sections_between(int a, int b) const {
    const int n = skin_.section_count();
    int step = a < b ? 1 : -1;
    if (skin_.path.closed && std::abs(a - b) > n / 2) step = -step;
    std::vector<int> out;
    for (int k = (a + step + n) % n; k != b; k = (k + step + n) % n) out.push_back(k);
    return out;
  }

  const SkinView::Section* shown(int section) const {
    const std::uint32_t id = skin_.sections[std::size_t(section)].id;
    for (const auto& s : view_.sections)
      if (s.id == id) return &s;
    return nullptr;
  }

  /// Crossing of a straight stroke with a section's curve on the screen; a beginning within 10 pixels of it
  /// counts.
  std::optional<Crossing> crossing_with(int section, const Vector2& from, const Vector2& to) const {
    const auto* curve = shown(section);
    if (!curve || curve->curve.size() < 2) return {};
    const double count = double(curve->curve.size() - 1);
    std::optional<Crossing> near, crossing;
    double least = 10 * scale_, along = 2;
    for (std::size_t i = 0; i + 1 < curve->curve.size(); ++i) {
      const auto p = pixel(curve->curve[i]), q = pixel(curve->curve[i + 1]);
      if (!p || !q) continue;
      // An arch seen from the side may be crossed twice: where the stroke comes first counts.
      const auto cross = cross_segments(from, to, *p, *q);
      if (cross.crosses && cross.along_a < along) {
        along = cross.along_a;
        crossing = Crossing{from + cross.along_a * (to - from), (double(i) + cross.along_b) / count};
      }
      const SegmentFoot foot = foot_on_segment(*p, *q, from);
      if (foot.distance >= least) continue;
      least = foot.distance;
      near = Crossing{*p + foot.along * (*q - *p), (double(i) + foot.along) / count};
    }
    return near ? near : crossing;
  }

  /// Ids of the points with parameters between two; round the shorter side of closed sections.
  std::vector<std::uint32_t> points_between(int section, double first, double last) const {
    const SkinSection& s = skin_.sections[std::size_t(section)];
    const SubdivisionCurve curve = s.curve();
    if (first > last) std::swap(first, last);
    const bool outside = curve.closed && last - first > 0.5;
    std::vector<std::uint32_t> out;
    for (int i = 0; i < s.size(); ++i) {
      const double u = curve.parameter(i);
      if ((u >= first && u <= last) != outside) out.push_back(s.points[std::size_t(i)].id);
    }
    return out;
  }

  Result<CorrespondenceEdit> merge_at(int own, const std::vector<std::uint32_t>& members, const Vector2& tip,
                                      bool beyond) const {
    const int n = skin_.section_count();
    std::vector<int> strips;
    if (own < skin_.strip_count()) strips.push_back(own);
    if (own > 0 || skin_.path.closed) strips.push_back((own + n - 1) % n);
    // At a point of the other section the merge is there.
    for (const int strip : strips) {
      const int other = strip == own ? (own + 1) % n : strip;
      if (const auto at = point_at(tip, other, beyond ? 60 : 10))
        return merge_points(skin_, members, *at, strip == own ? 1 : 0);
    }
    std::vector<std::uint32_t> beginnings;
    for (const int strip : strips) beginnings.push_back(skin_.sections[std::size_t(strip)].id);
    const auto hit = nearest_line(view_, object_, projector_, tip, beginnings);
    if (!hit)
      return no_gesture("The tip of the wedge is beside the surface.", "Draw its tip between two sections.");
    const SkinView::Line& line = view_.lines[hit->line];
    const bool behind = line.first == skin_.sections[std::size_t(own)].id;
    return merge_points(skin_, members, behind ? line.b : line.a, hit->along);
  }

  const Skin& skin_;
  const SkinView& view_;
  const Object& object_;
  const Projector& projector_;
  const double scale_;
  const std::set<std::uint32_t>& hidden_;
  std::map<std::uint32_t, Point> points_;
};

}  // namespace

Result<CorrespondenceEdit> gesture_edit(const Skin& skin, const SkinView& view, const Object& object,
                                        const Projector& projector, const Stroke& stroke, double pixel_scale,
                                        const std::set<std::uint32_t>& hidden) {
  const Gesture gesture(skin, view, object, projector, pixel_scale, hidden);
  switch (stroke.kind) {
    case StrokeKind::line:
      return gesture.line(stroke.points[0], stroke.points[1]);
    case StrokeKind::lasso:
      return gesture.lasso(stroke.points);
    case StrokeKind::wedge:
      return gesture.wedge(stroke.points[0], stroke.points[1], stroke.points[2]);
    case StrokeKind::none:
      break;
  }
  return no_gesture("The stroke is no line, no closed curve and no wedge.",
                    "Draw a straight line, a closed curve, or two straight legs with a tip.");
}

}  // namespace hariko
