#include "core/skinning/edit/add_section.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/skinning/columns/smooth.hpp"
#include "core/skinning/edit/edit_path.hpp"
#include "core/skinning/evaluate_skin.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko {

using namespace detail;

namespace {

constexpr double same_place = 1e-9;

/// Lines of the strip that coincide at the new section's place and give it one control point.
struct Strand {
  std::vector<int> lines;
  Vector3 target = Vector3::Zero();
  bool sharp = false;
};

/// Place of a new section: the strip, and the fraction along it (0 at its first section .. 1).
struct NewPlace {
  int strip = 0;
  double v = 0, fraction = 0;
};

Result<NewPlace> place_of(const Skin& skin, const SkinPlan& plan, double v) {
  if (!std::isfinite(v) || (!skin.path.closed && !(v > 0 && v < 1)))
    return make_error(e_section_range, "The new section must lie on the path.",
                      "Choose a place between two sections.");
  v -= skin.path.closed ? std::floor(v) : 0;
  for (const SkinSection& section : skin.sections)
    if (std::abs(section.v - v) < same_place)
      return make_error(e_section_order, "There is a section at this place of the path.",
                        "Choose a place between two sections.");
  for (std::size_t s = 0; s < plan.strips.size(); ++s)
    for (const double turn : {0.0, 1.0}) {
      const PlannedStrip& strip = plan.strips[s];
      if (v + turn > strip.v0 && v + turn < strip.v1)
        return NewPlace{int(s), v, (v + turn - strip.v0) / (strip.v1 - strip.v0)};
    }
  return make_error(e_section_range, "The new section must lie on the path.",
                    "Choose a place between two sections.");
}

/// Evaluation of the surface on edges of its control mesh.
class EdgePoints {
 public:
  explicit EdgePoints(const Surface& surface)
      : patches_(*subdivision_patches(surface)), topology_(patches_.topology()) {
    const PolygonMesh& mesh = topology_.mesh().mesh;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      if (face.size() == 4)
        for (std::size_t c = 0; c < 4; ++c) diagonals_[{face[c], face[(c + 2) % 4]}] = {Index(f), int(c)};
    }
    for (Index p = 0; p < topology_.patch_count(); ++p)
      patches_of_[{topology_.face_of(p), topology_.corner_of(p)}] = p;
  }

  /// Point at fraction t between control vertices a and b that are joined by an edge, or by a diagonal of a
  /// quad where joining fan triangles removed the edge.
  std::optional<Vector3> at(Index a, Index b, double t) const {
    if (a == b) return patches_.limit_position(a);
    auto sides = topology_.edge_sides(a, b);
    if (sides.empty()) {
      sides = topology_.edge_sides(b, a);
      t = 1 - t;
    }
    if (!sides.empty()) {
      const double x = t * double(sides.size());
      const std::size_t part = std::min(sides.size() - 1, std::size_t(std::max(0.0, x)));
      const PatchSide side = sides[part];
      return point(side.patch, side_parameter(Domain::square, side.side, x - double(part)));
    }
    t = 1 - t;
    const auto diagonal = diagonals_.find({a, b});
    if (diagonal == diagonals_.end()) return {};
    const auto [face, corner] = diagonal->second;
    if (!topology_.cut()) {
      const Vector2 from = corner_parameter(Domain::square, corner),
                    to = corner_parameter(Domain::square, (corner + 2) % 4);
      return point(patches_of_.at({face, 0}), (1 - t) * from + t * to);
    }
    const bool near = t <= 0.5;
    const double x = near ? 2 * t : 2 * (1 - t);
    return point(patches_of_.at({face, near ? corner : (corner + 2) % 4}), Vector2(x, x));
  }

 private:
  Vector3 point(Index patch, const Vector2& parameter) const {
    return patches_.evaluate(patch, parameter, Order::first).position;
  }
  const SubdivisionPatchSet& patches_;
  const SubdivisionTopology& topology_;
  std::map<std::pair<Index, Index>, std::pair<Index, int>> diagonals_;
  std::map<std::pair<Index, int>, Index> patches_of_;
};

class Divider {
 public:
  Divider(const Skin& skin, const SkinPlan& plan, const NewPlace& place)
      : skin_(skin),
        plan_(plan),
        place_(place),
        strip_(plan.strips[std::size_t(place.strip)]),
        a_(skin.sections[std::size_t(strip_.a)]),
        b_(skin.sections[std::size_t(strip_.b)]),
        from_a_(a_.size() >= b_.size()) {}

  /// Divides the strip by its lines, on the surface.
  Result<SkinEdit> divide(const SkinMesh& mesh, const Surface& surface) {
    find_edges(mesh);
    gather();
    if (strands_.size() < (plan_.closed_sections ? 3U : 2U))
      return make_error(e_few_points, "So many points have merged there that a section would have too few.",
                        "Choose a place where fewer have merged.");
    const EdgePoints points(surface);
    for (Strand& strand : strands_) {
      const auto& edge = edges_[std::size_t(strand.lines[strand.lines.size() / 2])];
      const auto target = points.at(edge.first, edge.second, along_edge_);
      if (!target)
        return make_error(e_section_order, "No section can be taken from the surface here.",
                          "Choose a place a little away.");
      strand.target = *target;
      const PointPair line = strip_.lines[std::size_t(strand.lines.front())];
      strand.sharp = a_.points[std::size_t(line.a)].sharp && b_.points[std::size_t(line.b)].sharp;
    }
    SkinEdit edit = insert();
    divide_links(edit.skin);
    divide_merges(edit.skin);
    tie_groups(edit.skin);
    return accepted(skin_, std::move(edit));
  }

  /// Divides the strip by the virtual surface: one point per point of the larger neighbour.
  Result<SkinEdit> divide(const VirtualSurface& surface) {
    const SkinSection& own = from_a_ ? a_ : b_;
    const int index = from_a_ ? strip_.a : strip_.b;
    const SubdivisionCurve curve = own.curve();
    for (int i = 0; i < own.size(); ++i)
      strands_.push_back(
          {{i},
           surface.point(place_along(surface, index, curve.parameter(i), curve.closed), place_.v),
           curve.is_sharp(i)});
    SkinEdit edit = insert();
    map_anchor_rows(edit.skin);
    // Chains of links are continued through the new points.
    std::vector<SkinLink> links;
    std::uint32_t next = edit.skin.free_link_id();
    for (const SkinLink& link : edit.skin.links) {
      if (!in_strip(link)) {
        links.push_back(link);
        continue;
      }
      SkinLink first = link, second = link;
      const auto& ids = from_a_ ? link.a : link.b;
      std::vector<std::uint32_t> middle;
      for (const std::uint32_t id : ids)
        if (const int i = find_point(own, id); i >= 0) middle.push_back(ids_[std::size_t(i)]);
      first.second = second.first = section_id_;
      first.b = second.a = middle;
      second.id = next++;
      links.push_back(first);
      links.push_back(second);
    }
    edit.skin.links = std::move(links);
    // Merges have no effect in these methods, so that no lines determine where they belong.
    std::erase_if(edit.skin.merges, [&](const SkinMerge& merge) {
      if (!in_strip(merge)) return false;
      edit.lost.push_back(merge.id);
      return true;
    });
    return accepted(skin_, std::move(edit));
  }

 private:
  template <class Entry>
  bool in_strip(const Entry& entry) const {
    return entry.first == a_.id && entry.second == b_.id;
  }

  /// Finds the mesh edge on which each line crosses the place.
  void find_edges(const SkinMesh& mesh) {
    const auto& rows = mesh.rows[std::size_t(place_.strip)];
    const double v = strip_.v0 + place_.fraction * (strip_.v1 - strip_.v0);
    std::size_t q = 0;
    while (q + 2 < rows.size() && rows[q + 1] <= v) ++q;
    along_edge_ = std::clamp((v - rows[q]) / (rows[q + 1] - rows[q]), 0.0, 1.0);
    std::size_t next = q + 1;
    // At a row lines may share the row's vertices.
    if (along_edge_ < same_place) next = q, along_edge_ = 0;
    const auto& grid = mesh.representative[std::size_t(place_.strip)];
    for (std::size_t p = 0; p < strip_.lines.size(); ++p) edges_.emplace_back(grid[q][p], grid[next][p]);
  }

  bool merged_at_place(const PlannedMerge& merge) const {
    return merge.side == StripSide::a ? place_.fraction >= merge.v : place_.fraction <= merge.v;
  }

  /// Whether both lines belong to a merge of the smaller side that is still open here.
  bool apart(int p, int r) const {
    const StripSide smaller = from_a_ ? StripSide::b : StripSide::a;
    for (const PlannedMerge& merge : strip_.merges) {
      if (merge.side != smaller || merged_at_place(merge)) continue;
      const auto in = [&](int line) {
        const PointPair pair = strip_.lines[std::size_t(line)];
        const int member = from_a_ ? pair.b : pair.a, target = from_a_ ? pair.a : pair.b;
        return target == merge.target &&
               std::find(merge.members.begin(), merge.members.end(), member) != merge.members.end();
      };
      if (in(p) && in(r)) return true;
    }
    return false;
  }

  bool together(int p, int r) const {
    if (edges_[std::size_t(p)] == edges_[std::size_t(r)]) return true;
    const PointPair x = strip_.lines[std::size_t(p)], y = strip_.lines[std::size_t(r)];
    return (from_a_ ? x.a == y.a : x.b == y.b) && !apart(p, r);
  }

  void gather() {
    const int n = int(strip_.lines.size());
    for (int p = 0; p < n; ++p) {
      if (p > 0 && together(p - 1, p))
        strands_.back().lines.push_back(p);
      else
        strands_.push_back({{p}, Vector3::Zero(), false});
    }
    if (!plan_.closed_sections) return;
    if (strands_.size() > 1 && together(n - 1, 0)) {
      auto& first = strands_.front().lines;
      first.insert(first.begin(), strands_.back().lines.begin(), strands_.back().lines.end());
      strands_.pop_back();
    }
    // The seam stays at the larger neighbour's first point.
    const auto seam = std::find_if(strands_.begin(), strands_.end(), [&](const Strand& strand) {
      return std::any_of(strand.lines.begin(), strand.lines.end(), [&](int p) {
        const PointPair line = strip_.lines[std::size_t(p)];
        return (from_a_ ? line.a : line.b) == 0;
      });
    });
    if (seam != strands_.end()) std::rotate(strands_.begin(), seam, strands_.end());
  }

  /// Returns the skin with the new section.
  SkinEdit insert() {
    SkinEdit edit{skin_, 0, {}, {}, {}};
    SkinSection section;
    section.id = section_id_ = skin_.free_section_id();
    section.v = place_.v;
    section.closed = plan_.closed_sections;
    section.direction_chosen = true;
    section.start_chosen = section.closed && !strip_.start_found && (a_.start_chosen || b_.start_chosen);
    std::vector<Vector3> targets;
    std::vector<char> sharp;
    for (const Strand& strand : strands_) targets.push_back(strand.target), sharp.push_back(strand.sharp);
    if (plan_.frames.mode() == FrameMode::two_rail) {
      targets.front() = plan_.frames.position(place_.v);
      targets.back() = plan_.frames.rail(place_.v);
    }
    const SubdivisionCurve curve = curve_through(targets, section.closed, sharp);
    std::uint32_t next = skin_.free_point_id();
    for (std::size_t i = 0; i < targets.size(); ++i) {
      ids_.push_back(next);
      section.points.push_back({next++, curve.points[i], sharp[i] != 0});
    }
    edit.points = ids_;
    auto& sections = edit.skin.sections;
    index_ = strip_.b > strip_.a || place_.v > a_.v ? strip_.a + 1 : 0;
    sections.insert(sections.begin() + index_, section);
    return edit;
  }

  /// Ids of the strands that contain a line with these points.
  std::vector<std::uint32_t> strands_with(const std::vector<std::uint32_t>& a,
                                          const std::vector<std::uint32_t>& b) const {
    const auto has = [](const std::vector<std::uint32_t>& ids, std::uint32_t id) {
      return std::find(ids.begin(), ids.end(), id) != ids.end();
    };
    std::vector<std::uint32_t> out;
    for (std::size_t s = 0; s < strands_.size(); ++s)
      for (const int p : strands_[s].lines) {
        const PointPair line = strip_.lines[std::size_t(p)];
        if (!has(a, a_.points[std::size_t(line.a)].id) || !has(b, b_.points[std::size_t(line.b)].id))
          continue;
        out.push_back(ids_[s]);
        break;
      }
    return out;
  }

  /// Moves links to the part towards the smaller neighbour; in the other part points correspond one to one.
  void divide_links(Skin& skin) const {
    for (SkinLink& link : skin.links) {
      if (!in_strip(link)) continue;
      auto middle = strands_with(link.a, link.b);
      (from_a_ ? link.first : link.second) = section_id_;
      (from_a_ ? link.a : link.b) = std::move(middle);
    }
  }

  void divide_merges(Skin& skin) const {
    const double t = place_.fraction;
    std::vector<SkinLink> groups;
    std::erase_if(skin.merges, [&](SkinMerge& merge) {
      if (!in_strip(merge)) return false;
      const bool side_a = merge.side == StripSide::a;
      const std::vector<std::uint32_t> target{merge.target};
      const auto middle = strands_with(side_a ? merge.members : target, side_a ? target : merge.members);
      if (middle.empty()) return false;
      const bool before = side_a ? t >= merge.v : t > merge.v;  // the merge point lies before the new section
      const double v = before ? merge.v / t : (merge.v - t) / (1 - t);
      const bool merged = side_a == before;
      (before ? merge.second : merge.first) = section_id_;
      if (merged)
        merge.target = middle[middle.size() / 2];
      else
        merge.members = middle;
      merge.v = v;
      if (v > 1e-6 && v < 1 - 1e-6) return false;
      // The merge point lies at the new section.
      SkinLink link;
      link.id = merge.id, link.first = merge.first, link.second = merge.second;
      link.a = side_a ? merge.members : std::vector<std::uint32_t>{merge.target};
      link.b = side_a ? std::vector<std::uint32_t>{merge.target} : merge.members;
      link.lasso = true, link.locked = merge.locked;
      groups.push_back(link);
      return true;
    });
    skin.links.insert(skin.links.end(), groups.begin(), groups.end());
  }

  /// Adds links where several points of the larger neighbour correspond to one of the new section and no
  /// merge says so.
  void tie_groups(Skin& skin) const {
    const SkinSection& own = from_a_ ? a_ : b_;
    std::uint32_t next = skin.free_link_id();
    for (std::size_t s = 0; s < strands_.size(); ++s) {
      std::vector<std::uint32_t> points;
      for (const int p : strands_[s].lines) {
        const PointPair line = strip_.lines[std::size_t(p)];
        const std::uint32_t id = own.points[std::size_t(from_a_ ? line.a : line.b)].id;
        if (std::find(points.begin(), points.end(), id) == points.end()) points.push_back(id);
      }
      const std::vector<std::uint32_t> one{ids_[s]};
      const bool known =
          std::any_of(skin.merges.begin(), skin.merges.end(),
                      [&](const SkinMerge& merge) {
                        return merge.target == ids_[s] &&
                               (from_a_ ? merge.first == a_.id : merge.second == b_.id);
                      }) ||
          std::any_of(skin.links.begin(), skin.links.end(), [&](const SkinLink& link) {
            return from_a_ ? link.first == a_.id && link.b == one : link.second == b_.id && link.a == one;
          });
      if (points.size() < 2 || known) continue;
      SkinLink link;
      link.id = next++;
      link.first = from_a_ ? a_.id : section_id_, link.second = from_a_ ? section_id_ : b_.id;
      link.a = from_a_ ? points : std::vector<std::uint32_t>{ids_[s]};
      link.b = from_a_ ? std::vector<std::uint32_t>{ids_[s]} : points;
      link.lasso = true;
      skin.links.push_back(link);
    }
  }

  /// Parameters on all sections of the point of the virtual surface that has parameter u on one.
  std::vector<double> place_along(const VirtualSurface& surface, int section, double u, bool closed) const {
    const double about = u - plan_.starts[std::size_t(section)];
    double low = closed ? about - 1 : 0, high = closed ? about + 1 : 1;
    for (int round = 0; round < 60; ++round) {
      const double middle = (low + high) / 2;
      (surface.parameter(section, middle) < u ? low : high) = middle;
    }
    std::vector<double> out;
    for (int k = 0; k < skin_.section_count(); ++k)
      out.push_back(k == section ? u : surface.parameter(k, (low + high) / 2));
    return out;
  }

  void map_anchor_rows(Skin& skin) const {
    const std::size_t own = std::size_t(from_a_ ? strip_.a : strip_.b);
    for (auto& row : skin.smooth.anchors)
      if (row.size() == skin_.sections.size()) row.insert(row.begin() + index_, double(row[own]));
  }

  const Skin& skin_;
  const SkinPlan& plan_;
  const NewPlace place_;
  const PlannedStrip& strip_;
  const SkinSection &a_, &b_;
  const bool from_a_;  ///< the section before has at least as many points as the one after
  std::vector<std::pair<Index, Index>> edges_;
  double along_edge_ = 0;
  std::vector<Strand> strands_;
  std::vector<std::uint32_t> ids_;
  std::uint32_t section_id_ = 0;
  int index_ = 0;
};

}  // namespace

Result<SkinEdit> add_section(const Skin& skin, double v, const SkinWork& work) {
  auto plan = plan_skin(skin);
  if (!plan) return plan.error();
  const auto place = place_of(skin, *plan, v);
  if (!place) return place.error();
  if (skin.method != SkinMethod::pleat) {
    const auto anchors = skin_anchors(skin, *plan);
    if (!anchors) return anchors.error();
    return Divider(skin, *plan, *place).divide(VirtualSurface(skin, *plan, *anchors));
  }
  work.progress.report(0.1);
  SkinWork skinning;
  skinning.cancel = work.cancel;
  const auto made = SkinSurfacer().surface(skin, Vector3::Zero(), skinning);
  if (!made) return made.error();
  work.progress.report(0.8);
  auto divided = Divider(skin, made->result.plan, *place).divide(made->result.mesh, made->surface);
  if (work.cancel.cancelled()) return make_error(e_cancelled, "Skinning was cancelled.");
  return divided;
}

Result<SkinEdit> draw_section(const Skin& skin, double v, const std::vector<Vector3>& points, bool closed) {
  SkinEdit edit{skin, 0, {}, {}, {}};
  SkinSection section;
  section.id = skin.free_section_id();
  section.v = v;
  section.closed = closed && points.size() > 1;
  std::uint32_t next = skin.free_point_id();
  for (const Vector3& p : points) {
    edit.points.push_back(next);
    section.points.push_back({next++, p, false});
  }
  auto& sections = edit.skin.sections;
  const auto at =
      std::find_if(sections.begin(), sections.end(), [&](const SkinSection& other) { return other.v > v; });
  const std::size_t index = std::size_t(at - sections.begin());
  if (!sections.empty()) {
    const std::uint32_t before = sections[(index + sections.size() - 1) % sections.size()].id,
                        after = sections[index % sections.size()].id;
    const auto divided = [&](const auto& entry) {
      if (entry.first != before || entry.second != after) return false;
      edit.lost.push_back(entry.id);
      return true;
    };
    std::erase_if(edit.skin.links, divided);
    std::erase_if(edit.skin.merges, divided);
  }
  // Anchors are copied from the section before.
  for (auto& row : edit.skin.smooth.anchors)
    if (!row.empty() && row.size() == sections.size())
      row.insert(row.begin() + std::ptrdiff_t(index), double(row[index > 0 ? index - 1 : 0]));
  sections.insert(at, std::move(section));
  return accepted(skin, std::move(edit));
}

Result<SkinEdit> delete_section(const Skin& skin, std::uint32_t id) {
  const int k = skin.find_section(id);
  if (k < 0) return no_such_section();
  if (skin.section_count() <= 2)
    return make_error(e_few_sections, "Skinning needs at least two sections.", "Delete the skin instead.");
  SkinEdit edit{skin, 0, {}, {}, {}};
  for (auto& row : edit.skin.smooth.anchors)
    if (row.size() == skin.sections.size()) row.erase(row.begin() + k);
  edit.skin.sections.erase(edit.skin.sections.begin() + k);
  forget_section(edit.skin, id, edit.lost);
  const bool end = !skin.path.closed && (k == 0 || k == skin.section_count() - 1);
  if (end) {
    const auto trimmed = trim_path(edit.skin);
    if (!trimmed) return trimmed.error();
    edit.skin = trimmed->skin;
    edit.deviation = trimmed->deviation;
  }
  return accepted(skin, std::move(edit));
}

}  // namespace hariko
