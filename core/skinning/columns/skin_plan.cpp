#include "core/skinning/columns/skin_plan.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>
#include <string>

#include "core/base/ids.hpp"
#include "core/base/index_list.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko {

namespace {

using Problem = std::optional<Message>;

constexpr double same_place = 1e-9;
constexpr int max_points = 100'000;  ///< total of all sections

std::string number(int k) {
  return std::to_string(k + 1);
}

/// Element that represents a whole section in messages.
Element first_point(const SkinSection& section) {
  return section.points.empty() ? Element{} : element_of(VertexId{section.points.front().id});
}

Problem check_order(const Skin& skin) {
  const auto& sections = skin.sections;
  for (std::size_t k = 0; k + 1 < sections.size(); ++k)
    if (!(sections[k + 1].v > sections[k].v) && std::isfinite(sections[k].v) &&
        std::isfinite(sections[k + 1].v))
      return make_error(e_section_order,
                        "Sections " + number(int(k)) + " and " + number(int(k) + 1) +
                            " are at the same place on the path (or in the wrong order).",
                        "Slide one of them along the path.", first_point(sections[k + 1]));
  for (const SkinSection& section : sections)
    if (!std::isfinite(section.v))
      return make_error(e_not_finite, "The place of a section on the path is not a finite number.",
                        "Place it anew.");
  const double first = sections.front().v, last = sections.back().v;
  if (skin.path.closed) {
    if (first < 0 || last > 1 || !(last - first < 1))
      return make_error(e_section_range, "The sections of a closed path must lie on one turn of it.",
                        "Slide the first or last section.");
  } else if (std::abs(first) > same_place || std::abs(last - 1) > same_place) {
    return make_error(e_section_range, "The first and last section must lie at the ends of an open path.",
                      "Slide them to the ends, or trim the path.",
                      first_point(std::abs(first) > same_place ? sections.front() : sections.back()));
  }
  return {};
}

Problem check_finite(const Skin& skin) {
  const auto finite = [](const SubdivisionCurve& curve) {
    return std::all_of(curve.points.begin(), curve.points.end(),
                       [](const Vector3& p) { return p.allFinite(); });
  };
  if (!finite(skin.path) || (skin.second_rail && !finite(*skin.second_rail)))
    return make_error(e_not_finite, "A point of the path is not a finite number.", "Move it.");
  for (const SkinSection& section : skin.sections)
    for (const SectionPoint& point : section.points)
      if (!point.position.allFinite())
        return make_error(e_not_finite, "A point of a section is not a finite number.", "Move it.",
                          element_of(VertexId{point.id}));
  if (!std::isfinite(skin.pleat.tension) || !(skin.pleat.tension > 0) || !std::isfinite(skin.pleat.density) ||
      !(skin.pleat.density > 0))
    return make_error(e_not_finite, "Tension and density must be positive numbers.", "Set them anew.");
  return {};
}

Problem check_points(const Skin& skin) {
  std::size_t total = 0;
  for (int k = 0; k < skin.section_count(); ++k) {
    const SkinSection& section = skin.sections[std::size_t(k)];
    total += section.points.size();
    if (section.size() == 0 || (section.closed && section.size() == 2))
      return make_error(e_few_points, "Section " + number(k) + " needs at least 2 (closed: 3) points.",
                        "Add points to it, or delete it.", first_point(section));
  }
  if (total > max_points)
    return make_error(e_skin_size, "The sections have more than 100000 points.", "Use fewer points.");
  for (int k = 0; k < skin.section_count(); ++k) {
    const bool end = !skin.path.closed && (k == 0 || k == skin.section_count() - 1);
    const bool alone = end && skin.section_count() == 2 && skin.sections[std::size_t(1 - k)].size() == 1;
    if (skin.sections[std::size_t(k)].size() == 1 && (!end || alone))
      return make_error(e_point_section, "A one-point section is only possible at an end.",
                        "Give section " + number(k) + " more points.",
                        first_point(skin.sections[std::size_t(k)]));
  }
  int first = -1;
  for (int k = 0; k < skin.section_count(); ++k) {
    const SkinSection& section = skin.sections[std::size_t(k)];
    if (section.size() == 1) continue;
    if (first < 0) first = k;
    if (section.closed != skin.sections[std::size_t(first)].closed)
      return make_error(e_open_closed,
                        "Open and closed sections cannot be mixed: " + number(first) + ", " + number(k) + ".",
                        "Close the open ones or open the closed ones.", first_point(section));
  }
  return {};
}

/// Index of the strip between two sections; -1 when they are not neighbours in this order.
int strip_between(const Skin& skin, std::uint32_t first, std::uint32_t second) {
  const int a = skin.find_section(first), b = skin.find_section(second);
  if (a < 0 || b < 0 || a >= skin.strip_count() || b != (a + 1) % skin.section_count()) return -1;
  return a;
}

bool known(const SkinSection& section, const std::vector<std::uint32_t>& ids) {
  return std::all_of(ids.begin(), ids.end(), [&](std::uint32_t id) { return find_point(section, id) >= 0; });
}

Problem check_references(const Skin& skin) {
  const auto gone = [](const std::string& what) {
    return make_error(e_skin_index, what + " refers to a point that no longer exists.", "Delete it.");
  };
  for (const SkinLink& link : skin.links) {
    const int k = strip_between(skin, link.first, link.second);
    if (k < 0 || link.a.empty() || link.b.empty()) return gone("A correspondence");
    if (!known(skin.sections[std::size_t(k)], link.a) ||
        !known(skin.sections[std::size_t(skin.find_section(link.second))], link.b))
      return gone("A correspondence");
  }
  if (skin.method != SkinMethod::pleat) return {};
  for (const SkinMerge& merge : skin.merges) {
    if (strip_between(skin, merge.first, merge.second) < 0) return gone("A merge");
    const bool a = merge.side == StripSide::a;
    const SkinSection& own = skin.sections[std::size_t(skin.find_section(a ? merge.first : merge.second))];
    const SkinSection& other = skin.sections[std::size_t(skin.find_section(a ? merge.second : merge.first))];
    if (!known(own, merge.members) || find_point(other, merge.target) < 0) return gone("A merge");
  }
  return {};
}

std::vector<int> indices(const SkinSection& section, const std::vector<std::uint32_t>& ids) {
  std::vector<int> out;
  for (const std::uint32_t id : ids)
    if (const int i = find_point(section, id); i >= 0) out.push_back(i);
  sort_unique(out);
  return out;
}

/// Consecutive points in order, across the seam of a closed section; nothing when there is a gap.
std::optional<std::vector<int>> in_a_row(std::vector<int> sorted, int count, bool closed) {
  std::vector<std::size_t> gaps;
  for (std::size_t k = 0; k + 1 < sorted.size(); ++k)
    if (sorted[k + 1] != sorted[k] + 1) gaps.push_back(k + 1);
  if (gaps.empty()) return sorted;
  if (!closed || gaps.size() > 1 || sorted.front() != 0 || sorted.back() != count - 1) return {};
  std::rotate(sorted.begin(), sorted.begin() + std::ptrdiff_t(gaps[0]), sorted.end());
  return sorted;
}

/// First of two pairs that cross; nothing where they cross only across the seam.
std::optional<PointPair> crossed(std::vector<PointPair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  for (std::size_t k = 0; k + 1 < pairs.size(); ++k)
    if (pairs[k + 1].b < pairs[k].b) return pairs[k];
  return {};
}

/// Whether the designer chose the first points of a closed strip's sections.
bool start_chosen(const Skin& skin, const PlannedStrip& strip) {
  return skin.sections[std::size_t(strip.b)].start_chosen ||
         (strip.a == 0 && !skin.path.closed && skin.sections.front().start_chosen);
}

/// Distance of a start from the nearest one at which points meet points; these are multiples of one step.
double off_steps(double start, int n, int m) {
  const double steps = double(std::lcm(std::int64_t(n), std::int64_t(m)));
  return start - std::round(start * steps) / steps;
}
/// Whether a start is at a multiple up to rounding.
bool at_step(double off, int n, int m) {
  return std::abs(off) * std::max(n, m) < 1e-6;
}

PairCost strip_cost(const Skin& skin, const SkinPlan& plan, const PlannedStrip& strip) {
  const int n = skin.sections[std::size_t(strip.a)].size(), m = skin.sections[std::size_t(strip.b)].size();
  if (skin.pleat.cost == MatchCost::parameter || n == 1 || m == 1) {
    // Rounded so that lines of equal cost stay equal wherever the skin is.
    const double start = strip.match.start - strip.twist, off = off_steps(start, n, m);
    return parameter_cost(n, m, plan.closed_sections, at_step(off, n, m) ? start - off : start);
  }
  const auto centred = [](std::vector<Vector3> points) {
    Vector3 centre = Vector3::Zero();
    for (const Vector3& p : points) centre += p / double(points.size());
    double square = 0;
    for (Vector3& p : points) square += (p -= centre).squaredNorm() / double(points.size());
    if (square > 0)
      for (Vector3& p : points) p /= std::sqrt(square);
    return points;
  };
  const auto a = centred(plan.offsets[std::size_t(strip.a)]), b = centred(plan.offsets[std::size_t(strip.b)]);
  // Rounded so that costs that are equal except for the rounding of distant points stay equal.
  constexpr double grain = 1e-8;
  return [a, b](int i, int j) {
    return grain * std::nearbyint((a[std::size_t(i)] - b[std::size_t(j)]).squaredNorm() / grain);
  };
}

class Planner {
 public:
  Planner(const Skin& skin, SkinPlan& plan) : skin_(skin), plan_(plan) {}

  Problem add_strips() {
    const int count = skin_.strip_count(), sections = skin_.section_count();
    for (int k = 0; k < count; ++k) {
      PlannedStrip strip;
      strip.a = k, strip.b = (k + 1) % sections;
      strip.v0 = skin_.sections[std::size_t(k)].v;
      strip.v1 = skin_.sections[std::size_t(strip.b)].v + (strip.b <= k ? 1 : 0);
      plan_.strips.push_back(strip);
    }
    find_starts();
    for (PlannedStrip& strip : plan_.strips)
      if (auto problem = match(strip)) return problem;
    if (skin_.method == SkinMethod::pleat)
      for (PlannedStrip& strip : plan_.strips)
        if (auto problem = add_merges(strip)) return problem;
    return {};
  }

 private:
  const SkinSection& section(int k) const { return skin_.sections[std::size_t(k)]; }
  bool of(const PlannedStrip& strip, std::uint32_t first, std::uint32_t second) const {
    return section(strip.a).id == first && section(strip.b).id == second;
  }

  void find_starts() {
    std::vector<StartMatch> found;
    std::vector<char> free;
    for (PlannedStrip& strip : plan_.strips) {
      const bool tip = section(strip.a).size() < 3 || section(strip.b).size() < 3;
      if (plan_.closed_sections && !tip && !start_chosen(skin_, strip)) {
        strip.match = nearest_start(plan_.offset_curve(skin_, strip.a), plan_.offset_curve(skin_, strip.b));
        strip.start_found = true;
        strip.twist = twist(strip);
      }
      found.push_back(strip.match);
      free.push_back(strip.start_found);
    }
    plan_.starts = chained_starts(found, free, skin_.path.closed);
  }
  /// Twist of the lines of a strip whose start is found automatically. Lines drawn by the designer are
  /// straight, and so are those of sections with corners, because corners lie only at points.
  double twist(const PlannedStrip& strip) const {
    const auto drawn = [&](const auto& entry) { return of(strip, entry.first, entry.second); };
    const auto sharp = [&](int k) {
      return std::any_of(section(k).points.begin(), section(k).points.end(),
                         [](const SectionPoint& p) { return p.sharp; });
    };
    if (sharp(strip.a) || sharp(strip.b) || std::any_of(skin_.links.begin(), skin_.links.end(), drawn) ||
        std::any_of(skin_.merges.begin(), skin_.merges.end(), drawn))
      return 0;
    const int n = section(strip.a).size(), m = section(strip.b).size();
    const double off = off_steps(strip.match.start, n, m);
    return at_step(off, n, m) ? 0 : off;
  }
  /// Drops the twist where lines matched by shape join other points than the nearest parameters do.
  void keep_twist_of_nearest(PlannedStrip& strip) const {
    const int n = section(strip.a).size(), m = section(strip.b).size();
    for (const PointPair& line : strip.lines) {
      const double gap = double(line.b) / m - double(line.a) / n - strip.match.start;
      if (std::abs(gap - std::round(gap)) * std::max(n, m) > 1) strip.twist = 0;
    }
  }

  Problem match(PlannedStrip& strip) {
    std::vector<PointPair> forced;
    std::set<PointPair> linked, merged;
    for (const SkinLink& link : skin_.links)
      if (of(strip, link.first, link.second))
        for (const PointPair& pair : forced_pairs(skin_, link)) forced.push_back(pair), linked.insert(pair);
    if (skin_.method == SkinMethod::pleat)
      for (const SkinMerge& merge : skin_.merges)
        if (of(strip, merge.first, merge.second))
          for (const PointPair& pair : forced_pairs(skin_, merge))
            forced.push_back(pair), merged.insert(pair);
    auto lines = correspondence(section(strip.a).size(), section(strip.b).size(), plan_.closed_sections,
                                strip_cost(skin_, plan_, strip), forced);
    if (!lines) {
      Message error = lines.error();
      if (const auto found = crossed(forced))
        error.element = element_of(VertexId{section(strip.a).points[std::size_t(found->a)].id});
      return error;
    }
    strip.lines = *std::move(lines);
    if (skin_.pleat.cost == MatchCost::shape) keep_twist_of_nearest(strip);
    for (const PointPair& line : strip.lines)
      strip.origins.push_back(merged.contains(line)   ? LineOrigin::merge
                              : linked.contains(line) ? LineOrigin::link
                                                      : LineOrigin::matched);
    return {};
  }

  Problem add_merges(PlannedStrip& strip) {
    std::set<PointPair> taken;
    for (const SkinMerge& merge : skin_.merges) {
      if (!of(strip, merge.first, merge.second)) continue;
      const bool a = merge.side == StripSide::a;
      const SkinSection &own = section(a ? strip.a : strip.b), &other = section(a ? strip.b : strip.a);
      const std::vector<int> members = indices(own, merge.members);
      const Element where =
          members.empty() ? Element{} : element_of(VertexId{own.points[std::size_t(members.front())].id});
      if (!(merge.v > 0 && merge.v < 1))
        return make_error(e_merge_v, "The tip of the wedge must lie between the two sections.",
                          "Draw its tip between them.", where);
      if (members.size() < 2)
        return make_error(e_merge_small, "A merge needs at least two points.",
                          "Draw the wedge around more points.", where);
      const auto row = in_a_row(members, own.size(), plan_.closed_sections);
      if (!row)
        return make_error(e_merge_gap, "The points of a merge must be neighbours.",
                          "Draw the wedge around all points between them.", where);
      for (const PointPair& line : forced_pairs(skin_, merge))
        if (!taken.insert(line).second)
          return make_error(e_merge_overlap, "A line belongs to two merges.", "Delete one of the merges.",
                            element_of(VertexId{own.points[std::size_t(a ? line.a : line.b)].id}));
      if (plan_.closed_sections && int(members.size()) == own.size())
        return make_error(e_merge_all,
                          "A closed section cannot merge into one line; use a one-point section.",
                          "Leave points out of the merge.", where);
      strip.merges.push_back({merge.side, *row, find_point(other, merge.target), merge.v});
    }
    return {};
  }

  const Skin& skin_;
  SkinPlan& plan_;
};

Problem check_rails(const Skin& skin, const SkinPlan& plan) {
  if (plan.frames.mode() != FrameMode::two_rail) return {};
  double size = 0;
  for (const SkinSection& section : skin.sections)
    for (const SectionPoint& p : section.points)
      size = std::max(size, (p.position - skin.sections[0].points[0].position).norm());
  for (int k = 0; k < skin.section_count(); ++k) {
    const SkinSection& section = skin.sections[std::size_t(k)];
    const double first = (section.points.front().position - plan.frames.position(section.v)).norm();
    const double last = (section.points.back().position - plan.frames.rail(section.v)).norm();
    if (section.closed || section.size() < 2 || !(std::max(first, last) <= 1e-6 * size))
      return make_error(e_rail, "Section " + number(k) + " does not start and end on the rails.",
                        "Move its first and last point onto the rails.", first_point(section));
  }
  return {};
}

}  // namespace

SubdivisionCurve SkinPlan::offset_curve(const Skin& skin, int k) const {
  SubdivisionCurve curve = skin.sections[std::size_t(k)].curve();
  curve.points = offsets[std::size_t(k)];
  return curve;
}

std::vector<PointPair> forced_pairs(const Skin& skin, const SkinLink& link) {
  const int ka = skin.find_section(link.first), kb = skin.find_section(link.second);
  if (ka < 0 || kb < 0) return {};
  const SkinSection &first = skin.sections[std::size_t(ka)], &second = skin.sections[std::size_t(kb)];
  const std::vector<int> a = indices(first, link.a), b = indices(second, link.b);
  if (a.empty() || b.empty()) return {};
  std::vector<PointPair> out;
  if (a.size() == 1 || b.size() == 1) {
    for (const int i : a)
      for (const int j : b) out.push_back({i, j});
    return out;
  }
  // Across the seam the outer points are those where the run begins and ends.
  const auto row_a = in_a_row(a, first.size(), first.closed),
             row_b = in_a_row(b, second.size(), second.closed);
  const auto &ra = row_a ? *row_a : a, &rb = row_b ? *row_b : b;
  return {{ra.front(), rb.front()}, {ra.back(), rb.back()}};
}

std::vector<PointPair> forced_pairs(const Skin& skin, const SkinMerge& merge) {
  SkinLink link;
  link.first = merge.first, link.second = merge.second;
  link.a = merge.members, link.b = {merge.target};
  if (merge.side == StripSide::b) std::swap(link.a, link.b);
  return forced_pairs(skin, link);
}

Result<SkinPlan> plan_skin(const Skin& skin) {
  if (skin.section_count() < 2)
    return make_error(e_few_sections, "Skinning needs at least two sections.", "Draw another section.");
  if (skin.path.size() < (skin.path.closed ? 3 : 2))
    return make_error(e_path_short, "The path needs at least 2 points (3 if closed).",
                      "Add points to the path.");
  for (const auto check : {check_order, check_finite, check_points, check_references})
    if (auto problem = check(skin)) return *problem;
  auto frames = SkinFrames::make(skin);
  // Links are checked before the path, and need its frames only for the cost by shape.
  SkinPlan plan{frames ? *frames
                       : SkinFrames::make([&] {
                           Skin straight = skin;
                           straight.path = {{Vector3(0, 0, 0), Vector3(1, 0, 0)}, false, {}};
                           straight.frame = FrameMode::translate;
                           return straight;
                         }())
                             .value(),
                false,
                {},
                {},
                {}};
  for (const SkinSection& section : skin.sections)
    plan.closed_sections = plan.closed_sections || (section.closed && section.size() > 1);
  for (const SkinSection& section : skin.sections) {
    const Matrix3 inverse = plan.frames.frame(section.v).inverse();
    const Vector3 base = plan.frames.position(section.v);
    auto& offsets = plan.offsets.emplace_back();
    for (const SectionPoint& p : section.points) offsets.push_back(inverse * (p.position - base));
  }
  if (auto problem = Planner(skin, plan).add_strips()) return *problem;
  if (!frames) return frames.error();
  if (auto problem = check_rails(skin, plan)) return *problem;
  return plan;
}

}  // namespace hariko
