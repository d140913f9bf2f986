#include "core/skinning/edit/symmetric_edit.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace hariko {

using namespace detail;

namespace {

/// Mean squared distance between points and the images of their partners, and of the path from the plane.
double asymmetry(const Skin& skin, const MirrorPlane& plane) {
  double out = 0;
  for (const SkinSection& section : skin.sections) {
    const std::vector<int> partner = mirror_partners(section, plane.point(), plane.normal());
    for (int i = 0; i < section.size(); ++i)
      out += (section.points[std::size_t(i)].position -
              plane.image(section.points[std::size_t(partner[std::size_t(i)])].position))
                 .squaredNorm() /
             section.size();
  }
  for (const Vector3& p : skin.path.points) out += (p - plane.foot(p)).squaredNorm() / skin.path.size();
  return out;
}

/// Id of a point's partner; nothing when the point does not exist.
std::optional<std::uint32_t> partner_of(const Skin& skin, std::uint32_t point, const MirrorPlane& plane) {
  const int k = section_with(skin, point);
  if (k < 0) return {};
  const SkinSection& section = skin.sections[std::size_t(k)];
  const std::vector<int> partner = mirror_partners(section, plane.point(), plane.normal());
  return section.points[std::size_t(partner[std::size_t(find_point(section, point))])].id;
}

}  // namespace

MirrorPlane mirror_plane(const Skin& skin, int axis) {
  MirrorPlane plane{axis, 0};
  for (const Vector3& p : skin.path.points) plane.position += p[axis] / double(skin.path.size());
  return plane;
}

MirrorPlane mirror_plane(const Skin& skin) {
  if (skin.mirror) return *skin.mirror;
  MirrorPlane best;
  double least = std::numeric_limits<double>::infinity();
  // No section is its own image across the path; of equals the first wins.
  for (const int axis : {1, 0, 2}) {
    const MirrorPlane plane = mirror_plane(skin, axis);
    const double value = asymmetry(skin, plane);
    if (value < least) least = value, best = plane;
  }
  return best;
}

Result<SkinEdit> move_section_points(const Skin& skin, std::span<const MovedPoint> points,
                                     const MirrorPlane& plane) {
  std::map<std::uint32_t, Vector3> places;
  for (const MovedPoint& moved : points) {
    const auto partner = partner_of(skin, moved.id, plane);
    if (!partner) return no_such_point();
    if (places.contains(moved.id)) continue;
    places[moved.id] = *partner == moved.id ? plane.foot(moved.position) : moved.position;
    if (*partner != moved.id) places[*partner] = plane.image(moved.position);
  }
  std::vector<MovedPoint> all;
  for (const auto& [id, position] : places) all.push_back({id, position});
  return move_section_points(skin, all);
}

Result<SkinEdit> move_limit_point(const Skin& skin, std::uint32_t point, const Vector3& position,
                                  const MirrorPlane& plane) {
  const auto partner = partner_of(skin, point, plane);
  if (!partner) return no_such_point();
  if (*partner == point) return move_limit_point(skin, point, plane.foot(position));
  const auto first = move_limit_point(skin, point, position);
  if (!first) return first;
  const auto both = move_limit_point(first->skin, *partner, plane.image(position));
  if (!both) return both;
  return accepted(skin, {both->skin, 0, {}, {}, {}});
}

Result<SkinEdit> insert_section_point(const Skin& skin, std::uint32_t id, int span,
                                      const MirrorPlane& plane) {
  const int k = skin.find_section(id);
  if (k < 0) return no_such_section();
  const SkinSection& section = skin.sections[std::size_t(k)];
  const SubdivisionCurve curve = section.curve();
  if (span < 0 || span >= curve.spans()) return no_such_point();
  const auto partner = mirror_partners(section, plane.point(), plane.normal());
  const int image = partner[std::size_t((span + 1) % section.size())];
  if (image == span || image >= curve.spans()) return insert_section_point(skin, id, span);
  // The later span first, so that the index of the other one stays valid.
  const int first = std::max(span, image), second = std::min(span, image);
  const auto one = insert_section_point(skin, id, first);
  if (!one) return one;
  const auto both = insert_section_point(one->skin, id, second);
  if (!both) return both;
  const Vector3 middle = evaluate(curve, (second + 0.5) / curve.spans()).position;
  auto placed = move_limit_point(both->skin, both->points.front(), middle);
  if (!placed) return placed;
  SkinEdit edit{std::move(placed->skin), one->deviation + both->deviation, {}, one->lost, {}};
  edit.points = {one->points.front(), both->points.front()};
  edit.lost.insert(edit.lost.end(), both->lost.begin(), both->lost.end());
  edit.lost.insert(edit.lost.end(), placed->lost.begin(), placed->lost.end());
  return accepted(skin, std::move(edit));
}

std::vector<std::uint32_t> with_partners(const Skin& skin, std::span<const std::uint32_t> points,
                                         const MirrorPlane& plane) {
  std::set<std::uint32_t> all(points.begin(), points.end());
  for (const std::uint32_t id : points)
    if (const auto partner = partner_of(skin, id, plane)) all.insert(*partner);
  std::vector<std::uint32_t> out;
  for (const SkinSection& section : skin.sections)
    for (const SectionPoint& p : section.points)
      if (all.erase(p.id) > 0) out.push_back(p.id);
  out.insert(out.end(), all.begin(), all.end());
  return out;
}

Result<SkinEdit> make_symmetric(const Skin& skin, std::span<const std::uint32_t> sections,
                                const MirrorPlane& plane) {
  SkinEdit edit{skin, 0, {}, {}, {}};
  for (const SkinSection& section : skin.sections) {
    if (!sections.empty() && std::find(sections.begin(), sections.end(), section.id) == sections.end())
      continue;
    auto one = make_symmetric(edit.skin, section.id, plane.point(), plane.normal());
    if (!one) return one;
    edit.skin = std::move(one->skin);
  }
  return accepted(skin, std::move(edit));
}

}  // namespace hariko
