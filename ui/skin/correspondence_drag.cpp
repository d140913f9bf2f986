#include "ui/skin/correspondence_drag.hpp"

#include <algorithm>
#include <limits>

namespace hariko {

namespace {

constexpr double snap_reach = 8, end_reach = 8;  ///< design pixels
constexpr double end_distance = 24;              ///< distance of a handle from the end of its line
constexpr double least_along = 0.02;             ///< a merge nearer to a section is a group there

}  // namespace

MergeDrag::MergeDrag(const Skin& skin, const SkinView& view, std::size_t diamond)
    : skin_(skin), view_(view), diamond_(view.diamonds[diamond]) {}

Result<CorrespondenceEdit> MergeDrag::to(const DragPlace& place) {
  const auto merge =
      std::ranges::find_if(skin_.merges, [&](const SkinMerge& m) { return m.id == diamond_.merge; });
  const auto hit = nearest_line(view_, place.object, place.projector, place.pixel, {diamond_.first});
  if (merge == skin_.merges.end() || !hit)
    return make_error(e_no_correspondence, "There is no such correspondence.", "Select one of the lines.");
  const SkinView::Line& line = view_.lines[hit->line];
  along_ = hit->along;
  double least = snap_reach * place.pixel_scale;
  for (std::size_t i = 1; i + 1 < line.points.size() && !place.free; ++i) {
    const auto row = pixel_of(place.object, place.projector, line.points[i]);
    if (!row || (*row - place.pixel).norm() >= least) continue;
    least = (*row - place.pixel).norm();
    along_ = line.along[i];
  }
  along_ = std::clamp(along_, least_along, 1 - least_along);
  return move_merge(skin_, merge->id, along_, merge->side == StripSide::a ? line.b : line.a);
}

std::vector<LineEnd> line_ends(const SkinView& view, const Object& object, const Projector& projector,
                               std::size_t line, const Vector2& pixel, double pixel_scale) {
  std::vector<Vector2> shown;
  for (const Vector3& p : view.lines[line].points) {
    const auto at = pixel_of(object, projector, p);
    if (!at) return {};
    shown.push_back(*at);
  }
  const double distance = end_distance * pixel_scale;
  double length = 0;
  for (std::size_t i = 0; i + 1 < shown.size(); ++i) length += (shown[i + 1] - shown[i]).norm();
  if (length < 2.5 * distance) return {};
  std::vector<LineEnd> out;
  for (const bool at_b : {false, true}) {
    double left = distance;
    for (std::size_t i = 0; i + 1 < shown.size(); ++i) {
      const double step = (shown[i + 1] - shown[i]).norm();
      if (step < left) {
        left -= step;
        continue;
      }
      out.push_back({line, at_b, shown[i] + left / step * (shown[i + 1] - shown[i])});
      break;
    }
    std::reverse(shown.begin(), shown.end());
  }
  std::sort(out.begin(), out.end(), [&](const LineEnd& a, const LineEnd& b) {
    return (a.pixel - pixel).norm() < (b.pixel - pixel).norm();
  });
  return out;
}

std::optional<LineEnd> line_end_at(const SkinView& view, const Object& object, const Projector& projector,
                                   std::size_t line, const Vector2& pixel, double pixel_scale) {
  const auto ends = line_ends(view, object, projector, line, pixel, pixel_scale);
  if (ends.empty() || (ends[0].pixel - pixel).norm() > end_reach * pixel_scale) return {};
  return ends[0];
}

LineEndDrag::LineEndDrag(const Skin& skin, const SkinView& view, const LineEnd& end) : skin_(skin) {
  const SkinView::Line& line = view.lines[end.line];
  from_ = end.at_b ? line.b : line.a;
  other_ = end.at_b ? line.a : line.b;
  anchor_ = end.at_b ? line.points.front() : line.points.back();
  int section = -1;
  for (const SkinView::Handle& handle : view.handles)
    if (handle.section >= 0 && handle.id == from_ && handle.kind != SkinView::Handle::Kind::place)
      section = handle.section;
  for (const SkinView::Handle& handle : view.handles)
    if (section >= 0 && handle.section == section && handle.kind != SkinView::Handle::Kind::place)
      points_.push_back(handle);
}

Result<CorrespondenceEdit> LineEndDrag::to(const DragPlace& place) {
  std::uint32_t best = from_;
  double least = std::numeric_limits<double>::infinity();
  for (const SkinView::Handle& point : points_) {
    const auto at = pixel_of(place.object, place.projector, point.position);
    if (!at || (*at - place.pixel).norm() >= least) continue;
    least = (*at - place.pixel).norm();
    best = point.id;
  }
  return move_line_end(skin_, from_, other_, best);
}

}  // namespace hariko
