#include "core/skinning/edit/edit_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/ids.hpp"
#include "core/skinning/edit/skin_edit.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko {

using namespace detail;

namespace {

void set_positions(SkinSection& section, const std::vector<Vector3>& positions) {
  for (std::size_t i = 0; i < positions.size(); ++i) section.points[i].position = positions[i];
}

bool contains(const std::vector<std::uint32_t>& ids, std::uint32_t id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// Adds a point to the links and merges that contain both its neighbours.
void take_in(Skin& skin, std::uint32_t before, std::uint32_t after, std::uint32_t id) {
  const auto extend = [&](std::vector<std::uint32_t>& ids) {
    const auto found = std::find(ids.begin(), ids.end(), before);
    if (found != ids.end() && contains(ids, after)) ids.insert(found + 1, id);
  };
  for (SkinLink& link : skin.links) extend(link.a), extend(link.b);
  for (SkinMerge& merge : skin.merges) extend(merge.members);
}

Vector3 reflected(const Vector3& p, const Vector3& plane_point, const Vector3& unit_normal) {
  return p - 2 * unit_normal.dot(p - plane_point) * unit_normal;
}

}  // namespace

Result<SkinEdit> move_section_points(const Skin& skin, std::span<const MovedPoint> points) {
  SkinEdit edit{skin, 0, {}, {}, {}};
  for (const MovedPoint& moved : points) {
    const int k = section_with(skin, moved.id);
    if (k < 0) return no_such_point();
    SkinSection& section = edit.skin.sections[std::size_t(k)];
    section.points[std::size_t(find_point(section, moved.id))].position = moved.position;
  }
  return accepted(skin, std::move(edit));
}

Result<SkinEdit> move_limit_point(const Skin& skin, std::uint32_t point, const Vector3& position) {
  const int k = section_with(skin, point);
  if (k < 0) return no_such_point();
  SkinEdit edit{skin, 0, {}, {}, {}};
  SkinSection& section = edit.skin.sections[std::size_t(k)];
  const SubdivisionCurve curve = section.curve();
  std::vector<Vector3> targets = limit_points(curve);
  targets[std::size_t(find_point(section, point))] = position;
  set_positions(section, curve_through(targets, curve.closed, curve.sharp).points);
  return accepted(skin, std::move(edit));
}

Result<SkinEdit> insert_section_point(const Skin& skin, std::uint32_t id, int span) {
  const int k = skin.find_section(id);
  if (k < 0) return no_such_section();
  SkinEdit edit{skin, 0, {skin.free_point_id()}, {}, {}};
  SkinSection& section = edit.skin.sections[std::size_t(k)];
  const SubdivisionCurve curve = section.curve();
  if (span < 0 || span >= curve.spans()) return no_such_point();
  const Reshaped reshaped = with_point_inserted(curve, span);
  const std::uint32_t before = section.points[std::size_t(span)].id,
                      after = section.points[std::size_t((span + 1) % section.size())].id;
  section.points.insert(section.points.begin() + span + 1,
                        SectionPoint{edit.points[0], Vector3::Zero(), false});
  set_positions(section, reshaped.curve.points);
  edit.deviation = reshaped.deviation;
  take_in(edit.skin, before, after, edit.points[0]);
  map_anchors(edit.skin, k,
              [&](double u) { return inserted_parameter(u, curve.spans(), span, curve.closed); });
  return accepted(skin, std::move(edit));
}

Result<SkinEdit> refine_section(const Skin& skin, std::uint32_t id) {
  const int k = skin.find_section(id);
  if (k < 0) return no_such_section();
  SkinEdit edit{skin, 0, {}, {}, {}};
  SkinSection& section = edit.skin.sections[std::size_t(k)];
  const SubdivisionCurve curve = section.curve();
  if (curve.spans() < 1) return accepted(skin, std::move(edit));
  const SubdivisionCurve fine = refined(curve);
  std::uint32_t next = skin.free_point_id();
  std::vector<SectionPoint> points;
  for (int i = 0; i < curve.size(); ++i) {
    points.push_back(section.points[std::size_t(i)]);
    if (i >= curve.spans()) break;
    edit.points.push_back(next);
    points.push_back({next, Vector3::Zero(), false});
    take_in(edit.skin, section.points[std::size_t(i)].id,
            section.points[std::size_t((i + 1) % curve.size())].id, next++);
  }
  section.points = std::move(points);
  set_positions(section, fine.points);
  return accepted(skin, std::move(edit));
}

Result<SkinEdit> delete_section_points(const Skin& skin, std::span<const std::uint32_t> points) {
  SkinEdit edit{skin, 0, {}, {}, {}};
  std::vector<SubdivisionCurve> old;
  for (const SkinSection& section : skin.sections) old.push_back(section.curve());
  for (const std::uint32_t id : points) {
    const int k = section_with(edit.skin, id);
    if (k < 0) return no_such_point();
    SkinSection& section = edit.skin.sections[std::size_t(k)];
    const SubdivisionCurve curve = section.curve();
    if (curve.size() <= (curve.closed ? 3 : 2))
      return make_error(e_few_points,
                        "Section " + std::to_string(k + 1) + " needs at least 2 (closed: 3) points.",
                        "Delete the section instead.", element_of(VertexId{id}));
    const int i = find_point(section, id);
    const Reshaped reshaped = with_point_deleted(curve, i);
    section.points.erase(section.points.begin() + i);
    set_positions(section, reshaped.curve.points);
    map_anchors(edit.skin, k, [&](double u) { return deleted_parameter(u, curve.spans(), i, curve.closed); });
    edit.deviation = std::max(edit.deviation, reshaped.deviation);
  }
  forget_points(edit.skin, {points.begin(), points.end()}, edit.lost);
  return accepted(skin, std::move(edit));
}

Result<SkinEdit> set_sharp(const Skin& skin, std::span<const std::uint32_t> points, bool sharp) {
  SkinEdit edit{skin, 0, {}, {}, {}};
  for (const std::uint32_t id : points) {
    const int k = section_with(skin, id);
    if (k < 0) return no_such_point();
    SkinSection& section = edit.skin.sections[std::size_t(k)];
    section.points[std::size_t(find_point(section, id))].sharp = sharp;
  }
  return accepted(skin, std::move(edit));
}

Result<SkinEdit> flip_section(const Skin& skin, std::uint32_t id) {
  const int k = skin.find_section(id);
  if (k < 0) return no_such_section();
  SkinEdit edit{skin, 0, {}, {}, {}};
  SkinSection& section = edit.skin.sections[std::size_t(k)];
  std::reverse(section.points.begin() + (section.closed && section.size() > 1 ? 1 : 0), section.points.end());
  section.direction_chosen = true;
  map_anchors(edit.skin, k, [](double u) { return 1 - u; });
  return accepted(skin, std::move(edit));
}

Result<SkinEdit> move_seam(const Skin& skin, std::uint32_t point) {
  const int k = section_with(skin, point);
  if (k < 0) return no_such_point();
  SkinEdit edit{skin, 0, {}, {}, {}};
  SkinSection& section = edit.skin.sections[std::size_t(k)];
  if (!section.closed)
    return make_error(e_open_closed, "Only closed sections have a seam that can be moved.",
                      "Turn the section round to begin at its other end.", element_of(VertexId{point}));
  const int i = find_point(section, point);
  const double shift = section.curve().parameter(i);
  std::rotate(section.points.begin(), section.points.begin() + i, section.points.end());
  section.start_chosen = true;
  map_anchors(edit.skin, k, [&](double u) { return u - shift; });
  return accepted(skin, std::move(edit));
}

Result<SkinEdit> set_start_chosen(const Skin& skin, std::uint32_t id, bool chosen) {
  const int k = skin.find_section(id);
  if (k < 0) return no_such_section();
  SkinEdit edit{skin, 0, {}, {}, {}};
  edit.skin.sections[std::size_t(k)].start_chosen = chosen;
  return accepted(skin, std::move(edit));
}

bool has_closed_sections(const Skin& skin) {
  return std::any_of(skin.sections.begin(), skin.sections.end(),
                     [](const SkinSection& section) { return section.closed && section.size() > 1; });
}

Result<SkinEdit> set_closed(const Skin& skin, bool closed) {
  SkinEdit edit{skin, 0, {}, {}, {}};
  for (int k = 0; k < skin.section_count(); ++k) {
    SkinSection& section = edit.skin.sections[std::size_t(k)];
    if (closed && section.size() == 2)
      return make_error(e_few_points,
                        "Section " + std::to_string(k + 1) + " needs at least 2 (closed: 3) points.",
                        "Add points to it.");
    section.closed = closed && section.size() > 1;
  }
  return accepted(skin, std::move(edit));
}

std::vector<int> mirror_partners(const SkinSection& section, const Vector3& plane_point,
                                 const Vector3& plane_normal) {
  const int n = section.size();
  const Vector3 normal = plane_normal.normalized();
  std::vector<int> out(std::size_t(n), 0);
  // Point i is the image of point (shift - i) mod n.
  int best = n - 1;
  double least = std::numeric_limits<double>::infinity();
  for (int shift = 0; section.closed && shift < n; ++shift) {
    double sum = 0;
    for (int i = 0; i < n; ++i) {
      const Vector3 image =
          reflected(section.points[std::size_t((shift - i + n) % n)].position, plane_point, normal);
      sum += (section.points[std::size_t(i)].position - image).squaredNorm();
    }
    if (sum < least) least = sum, best = shift;
  }
  for (int i = 0; i < n; ++i) out[std::size_t(i)] = (best - i + n) % n;
  return out;
}

Result<SkinEdit> make_symmetric(const Skin& skin, std::uint32_t id, const Vector3& plane_point,
                                const Vector3& plane_normal) {
  const int k = skin.find_section(id);
  if (k < 0) return no_such_section();
  SkinEdit edit{skin, 0, {}, {}, {}};
  SkinSection& section = edit.skin.sections[std::size_t(k)];
  const Vector3 normal = plane_normal.normalized();
  const std::vector<int> partner = mirror_partners(section, plane_point, normal);
  const auto height = [&](int i) {
    return normal.dot(skin.sections[std::size_t(k)].points[std::size_t(i)].position - plane_point);
  };
  for (int i = 0; i < section.size(); ++i) {
    const int j = partner[std::size_t(i)];
    SectionPoint& p = section.points[std::size_t(i)];
    if (i == j) {
      p.position -= height(i) * normal;
    } else if (i < j) {
      SectionPoint& q = section.points[std::size_t(j)];
      const bool first = height(i) >= height(j);
      (first ? q : p).position = reflected((first ? p : q).position, plane_point, normal);
      (first ? q : p).sharp = (first ? p : q).sharp;
    }
  }
  return accepted(skin, std::move(edit));
}

Skin mirrored(Skin skin, const Vector3& plane_point, const Vector3& plane_normal) {
  const Vector3 normal = plane_normal.normalized();
  change_positions(skin, [&](Vector3& p) { p = reflected(p, plane_point, normal); });
  // A reflection reverses normals; those of tubes are oriented outward automatically.
  if (!has_closed_sections(skin)) skin.flip_normals = !skin.flip_normals;
  return skin;
}

}  // namespace hariko
