#include "core/skinning/edit/edit_correspondence.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "core/base/index_list.hpp"
#include "core/skinning/columns/skin_plan.hpp"
#include "core/skinning/edit/skin_edit.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko {

using detail::section_with;

namespace {

std::uint32_t section_id(const Skin& skin, int k) {
  return skin.sections[std::size_t(k)].id;
}

/// Strip between two neighbouring sections, by its first section; -1 when they are not neighbours.
int strip_of(const Skin& skin, int a, int b) {
  const int n = skin.section_count();
  if (a < 0 || b < 0 || a == b) return -1;
  if (b == (a + 1) % n && a < skin.strip_count()) return a;
  if (a == (b + 1) % n && b < skin.strip_count()) return b;
  return -1;
}

Message not_neighbours() {
  return make_error(e_not_neighbours, "The points are not on neighbouring sections.",
                    "Draw from one section to its neighbour.");
}

Message gone() {
  return make_error(e_skin_index, "The correspondence refers to a point that no longer exists.",
                    "Draw it anew.");
}

Message none() {
  return make_error(e_no_correspondence, "There is no such correspondence.", "Select one of the lines.");
}

bool is_conflict(const Message& message) {
  return message.code == e_link_cross || message.code == e_merge_overlap;
}

/// Adds new links and merges: they and the locked ones stay; the others are added again, latest first, as
/// long as they cross none.
Result<CorrespondenceEdit> commit(const Skin& skin, std::vector<SkinLink> links,
                                  std::vector<SkinMerge> merges) {
  CorrespondenceEdit out{skin, {}, {}};
  Skin trial = skin;
  std::erase_if(trial.links, [](const SkinLink& link) { return !link.locked; });
  std::erase_if(trial.merges, [](const SkinMerge& merge) { return !merge.locked; });
  const bool had_locked = !trial.links.empty() || !trial.merges.empty();
  std::uint32_t next = skin.free_link_id();
  for (SkinLink& link : links) {
    link.id = next++;
    out.added.push_back(link.id);
    trial.links.push_back(link);
  }
  for (SkinMerge& merge : merges) {
    merge.id = next++;
    out.added.push_back(merge.id);
    trial.merges.push_back(merge);
  }
  if (const auto plan = plan_skin(trial); !plan) {
    if (!is_conflict(plan.error()) || !had_locked) return plan.error();
    Message message = plan.error();
    message.code = e_correspondence_locked;
    message.text = "The new correspondence would cross a locked one.";
    message.remedy = "Unlock it, or delete it.";
    return message;
  }
  struct Old {
    std::uint32_t id;
    const SkinLink* link;
    const SkinMerge* merge;
  };
  std::vector<Old> old;
  for (const SkinLink& link : skin.links)
    if (!link.locked) old.push_back({link.id, &link, nullptr});
  for (const SkinMerge& merge : skin.merges)
    if (!merge.locked) old.push_back({merge.id, nullptr, &merge});
  std::sort(old.begin(), old.end(), [](const Old& a, const Old& b) { return a.id > b.id; });
  for (const Old& o : old) {
    if (o.link) trial.links.push_back(*o.link);
    if (o.merge) trial.merges.push_back(*o.merge);
    if (const auto plan = plan_skin(trial); plan || !is_conflict(plan.error())) continue;
    if (o.link) trial.links.pop_back();
    if (o.merge) trial.merges.pop_back();
    out.removed.push_back(o.id);
  }
  // In the order in which they were drawn.
  std::sort(trial.links.begin(), trial.links.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  std::sort(trial.merges.begin(), trial.merges.end(),
            [](const auto& a, const auto& b) { return a.id < b.id; });
  std::sort(out.removed.begin(), out.removed.end());
  out.skin = std::move(trial);
  return out;
}

/// Link between points of two neighbouring sections, regardless of their order on the path.
Result<SkinLink> link_between(const Skin& skin, int ka, std::vector<std::uint32_t> a, int kb,
                              std::vector<std::uint32_t> b) {
  const int strip = strip_of(skin, ka, kb);
  if (strip < 0) return not_neighbours();
  if (strip != ka) std::swap(a, b);
  SkinLink link;
  link.first = section_id(skin, strip);
  link.second = section_id(skin, (strip + 1) % skin.section_count());
  link.a = std::move(a), link.b = std::move(b);
  return link;
}

bool same_points(const SkinLink& x, const SkinLink& y) {
  return x.first == y.first && x.second == y.second && x.a == y.a && x.b == y.b;
}

void drop_known(const Skin& skin, std::vector<SkinLink>& links) {
  std::erase_if(links, [&](const SkinLink& link) {
    return std::any_of(skin.links.begin(), skin.links.end(),
                       [&](const SkinLink& old) { return same_points(old, link); });
  });
}

/// Ids of points of one section in the order of the section, beginning where a run across the seam begins;
/// nothing when they are not neighbours.
std::optional<std::vector<std::uint32_t>> row_of(const SkinSection& section,
                                                 const std::vector<std::uint32_t>& ids) {
  const int n = section.size();
  std::vector<char> in(std::size_t(n), 0);
  for (const std::uint32_t id : ids) in[std::size_t(find_point(section, id))] = 1;
  const int count = int(std::count(in.begin(), in.end(), 1));
  int begins = 0, start = 0;
  for (int i = 0; i < n; ++i) {
    const bool before = i > 0 ? in[std::size_t(i - 1)] : (section.closed && in[std::size_t(n - 1)]);
    if (in[std::size_t(i)] && !before) ++begins, start = i;
  }
  if (count < n && begins != 1) return {};
  std::vector<std::uint32_t> out;
  for (int i = 0; i < count; ++i) out.push_back(section.points[std::size_t((start + i) % n)].id);
  return out;
}

template <class List>
auto find_id(List& list, std::uint32_t id) {
  return std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.id == id; });
}

}  // namespace

namespace {

/// Gives the added link or merge the id of the one that was moved.
Result<CorrespondenceEdit> with_id(Result<CorrespondenceEdit> edit, std::uint32_t id) {
  if (!edit) return edit;
  CorrespondenceEdit out = *std::move(edit);
  const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
  for (SkinLink& link : out.skin.links)
    if (link.id == out.added[0]) link.id = id;
  for (SkinMerge& merge : out.skin.merges)
    if (merge.id == out.added[0]) merge.id = id;
  std::sort(out.skin.links.begin(), out.skin.links.end(), by_id);
  std::sort(out.skin.merges.begin(), out.skin.merges.end(), by_id);
  out.added = {id};
  return out;
}

}  // namespace

Result<CorrespondenceEdit> join_points(const Skin& skin, std::span<const std::uint32_t> points) {
  if (points.size() < 2) return not_neighbours();
  std::vector<SkinLink> links;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const int a = section_with(skin, points[i]), b = section_with(skin, points[i + 1]);
    if (a < 0 || b < 0) return gone();
    auto link = link_between(skin, a, {points[i]}, b, {points[i + 1]});
    if (!link) return link.error();
    links.push_back(*link);
  }
  drop_known(skin, links);
  if (links.empty()) return CorrespondenceEdit{skin, {}, {}};
  return commit(skin, std::move(links), {});
}

Result<CorrespondenceEdit> group_points(const Skin& skin, std::span<const std::uint32_t> points) {
  std::map<int, std::vector<std::uint32_t>> groups;
  for (const std::uint32_t id : points) {
    const int k = section_with(skin, id);
    if (k < 0) return gone();
    groups[k].push_back(id);
  }
  for (auto& [k, ids] : groups) {
    const auto row = row_of(skin.sections[std::size_t(k)], ids);
    if (!row)
      return make_error(e_merge_gap, "The points inside the curve are not neighbours on their section.",
                        "Draw the curve around all points between them.");
    ids = *row;
  }
  std::vector<SkinLink> links;
  for (const auto& [k, ids] : groups) {
    const int next = (k + 1) % skin.section_count();
    const auto other = groups.find(next);
    if (k >= skin.strip_count() || other == groups.end()) continue;
    auto link = link_between(skin, k, ids, next, other->second);
    if (!link) return link.error();
    link.value().lasso = true;
    links.push_back(*link);
  }
  if (links.empty()) return not_neighbours();
  drop_known(skin, links);
  if (links.empty()) return CorrespondenceEdit{skin, {}, {}};
  return commit(skin, std::move(links), {});
}

Result<CorrespondenceEdit> merge_points(const Skin& skin, std::span<const std::uint32_t> members,
                                        std::uint32_t target, double v) {
  const int other = section_with(skin, target), own = members.empty() ? -1 : section_with(skin, members[0]);
  if (other < 0 || own < 0) return gone();
  for (const std::uint32_t id : members)
    if (section_with(skin, id) != own) return not_neighbours();
  const int strip = strip_of(skin, own, other);
  if (strip < 0) return not_neighbours();
  const bool a = strip == own;
  const std::vector<std::uint32_t> ids(members.begin(), members.end());
  if (a ? v >= 1 : v <= 0) {
    auto link = link_between(skin, own, ids, other, {target});
    if (!link) return link.error();
    link.value().lasso = true;
    return commit(skin, {*link}, {});
  }
  SkinMerge merge;
  merge.first = section_id(skin, strip);
  merge.second = section_id(skin, (strip + 1) % skin.section_count());
  merge.side = a ? StripSide::a : StripSide::b;
  merge.members = ids;
  merge.target = target;
  merge.v = v;
  return commit(skin, {}, {merge});
}

Result<CorrespondenceEdit> move_link_end(const Skin& skin, std::uint32_t id, std::uint32_t from,
                                         std::uint32_t to) {
  const auto found = find_id(skin.links, id);
  if (found == skin.links.end()) return none();
  if (section_with(skin, from) != section_with(skin, to)) return not_neighbours();
  SkinLink link = *found;
  bool moved = false;
  for (auto* side : {&link.a, &link.b})
    for (std::uint32_t& point : *side)
      if (point == from) point = to, moved = true;
  if (!moved) return gone();
  for (auto* side : {&link.a, &link.b}) sort_unique(*side);
  Skin without = skin;
  without.links.erase(find_id(without.links, id));
  return with_id(commit(without, {link}, {}), id);
}

Result<CorrespondenceEdit> move_merge(const Skin& skin, std::uint32_t id, double v, std::uint32_t target) {
  const auto found = find_id(skin.merges, id);
  if (found == skin.merges.end()) return none();
  SkinMerge merge = *found;
  if (section_with(skin, target) != section_with(skin, merge.target)) return not_neighbours();
  merge.v = v, merge.target = target;
  Skin without = skin;
  without.merges.erase(find_id(without.merges, id));
  return with_id(commit(without, {}, {merge}), id);
}

namespace {

/// Consecutive points of a section from one to another, the shorter way round a closed one.
std::vector<std::uint32_t> points_from(const SkinSection& section, std::uint32_t first, std::uint32_t last) {
  const int n = section.size();
  int i = find_point(section, first), j = find_point(section, last);
  if (!section.closed && i > j) std::swap(i, j);
  if (section.closed && (j - i + n) % n > n / 2) std::swap(i, j);
  std::vector<std::uint32_t> out;
  for (int k = i; k != j; k = (k + 1) % n) out.push_back(section.points[std::size_t(k)].id);
  out.push_back(section.points[std::size_t(j)].id);
  return out;
}

/// Merge whose outermost member `from` is replaced by `to`.
Result<CorrespondenceEdit> move_member(const Skin& skin, SkinMerge merge, std::uint32_t from,
                                       std::uint32_t to) {
  const SkinSection& section = skin.sections[std::size_t(section_with(skin, from))];
  const auto row = row_of(section, merge.members);
  if (!row) return gone();
  if (from != row->front() && from != row->back())
    return make_error(e_merge_gap, "This line is inside of the group.",
                      "Drag the outermost line of the group instead.");
  merge.members = points_from(section, from == row->front() ? row->back() : row->front(), to);
  Skin without = skin;
  without.merges.erase(find_id(without.merges, merge.id));
  return with_id(commit(without, {}, {merge}), merge.id);
}

}  // namespace

Result<CorrespondenceEdit> move_line_end(const Skin& skin, std::uint32_t from, std::uint32_t other,
                                         std::uint32_t to) {
  const int ka = section_with(skin, from), kb = section_with(skin, other);
  if (ka < 0 || kb < 0 || section_with(skin, to) < 0) return gone();
  if (section_with(skin, to) != ka || strip_of(skin, ka, kb) < 0) return not_neighbours();
  if (from == to) return CorrespondenceEdit{skin, {}, {}};
  const int strip = strip_of(skin, ka, kb);
  const std::uint32_t first = strip == ka ? from : other, second = strip == ka ? other : from;
  const PointPair pair{find_point(skin.sections[std::size_t(strip)], first),
                       find_point(skin.sections[std::size_t(strip == ka ? kb : ka)], second)};
  const auto has = [&](const auto& entry) {
    const auto pairs = forced_pairs(skin, entry);
    return entry.first == section_id(skin, strip) &&
           std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
  };
  for (const SkinMerge& merge : skin.merges)
    if (has(merge))
      return merge.target == from ? move_merge(skin, merge.id, merge.v, to)
                                  : move_member(skin, merge, from, to);
  for (const SkinLink& link : skin.links)
    if (has(link)) return move_link_end(skin, link.id, from, to);
  return join_points(skin, std::vector{to, other});
}

Result<CorrespondenceEdit> lock_line(const Skin& skin, std::uint32_t a, std::uint32_t b) {
  const int ka = section_with(skin, a), kb = section_with(skin, b);
  const int strip = strip_of(skin, ka, kb);
  if (strip < 0) return not_neighbours();
  if (strip != ka) std::swap(a, b);
  const auto plan = plan_skin(skin);
  if (!plan) return plan.error();
  const PlannedStrip& planned = plan->strips[std::size_t(strip)];
  const PointPair pair{find_point(skin.sections[std::size_t(planned.a)], a),
                       find_point(skin.sections[std::size_t(planned.b)], b)};
  if (std::find(planned.lines.begin(), planned.lines.end(), pair) == planned.lines.end()) return none();
  const std::uint32_t first = section_id(skin, planned.a), second = section_id(skin, planned.b);
  const auto has = [&](const auto& entry) {
    const auto pairs = forced_pairs(skin, entry);
    return entry.first == first && entry.second == second &&
           std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
  };
  for (const SkinMerge& merge : skin.merges)
    if (has(merge)) return set_locked(skin, merge.id, true);
  for (const SkinLink& link : skin.links)
    if (has(link)) return set_locked(skin, link.id, true);
  SkinLink link;
  link.first = first, link.second = second, link.a = {a}, link.b = {b}, link.locked = true;
  return commit(skin, {link}, {});
}

Result<CorrespondenceEdit> set_locked(const Skin& skin, std::uint32_t id, bool locked) {
  CorrespondenceEdit out{skin, {}, {}};
  const auto link = find_id(out.skin.links, id);
  const auto merge = find_id(out.skin.merges, id);
  if (link != out.skin.links.end())
    link->locked = locked;
  else if (merge != out.skin.merges.end())
    merge->locked = locked;
  else
    return none();
  return out;
}

Result<CorrespondenceEdit> delete_correspondence(const Skin& skin, std::uint32_t id) {
  CorrespondenceEdit out{skin, {}, {id}};
  const std::size_t gone_count =
      std::erase_if(out.skin.links, [&](const auto& link) { return link.id == id; }) +
      std::erase_if(out.skin.merges, [&](const auto& merge) { return merge.id == id; });
  if (gone_count == 0) return none();
  return out;
}

CorrespondenceEdit reset_strip(const Skin& skin, std::uint32_t first, std::uint32_t second) {
  CorrespondenceEdit out{skin, {}, {}};
  const auto in = [&](const auto& entry) {
    if (entry.first != first || entry.second != second) return false;
    out.removed.push_back(entry.id);
    return true;
  };
  std::erase_if(out.skin.links, in);
  std::erase_if(out.skin.merges, in);
  std::sort(out.removed.begin(), out.removed.end());
  return out;
}

}  // namespace hariko
