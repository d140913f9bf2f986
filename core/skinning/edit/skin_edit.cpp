#include "core/skinning/edit/skin_edit.hpp"

#include <algorithm>
#include <cmath>

#include "core/skinning/columns/skin_plan.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko::detail {

namespace {

bool is_crossing(const Message& message) {
  return message.code == e_link_cross || message.code == e_merge_overlap || message.code == e_merge_gap ||
         message.code == e_merge_all;
}

/// Removes links and merges that cross: adds them again one by one, locked ones first, then the latest first.
void drop_crossing(Skin& skin, std::vector<std::uint32_t>& lost) {
  struct Entry {
    bool locked;
    std::uint32_t id;
    const SkinLink* link;
    const SkinMerge* merge;
  };
  const Skin all = skin;
  std::vector<Entry> entries;
  for (const SkinLink& link : all.links) entries.push_back({link.locked, link.id, &link, nullptr});
  for (const SkinMerge& merge : all.merges) entries.push_back({merge.locked, merge.id, nullptr, &merge});
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.locked != b.locked ? a.locked : a.id > b.id; });
  skin.links.clear();
  skin.merges.clear();
  for (const Entry& entry : entries) {
    if (entry.link) skin.links.push_back(*entry.link);
    if (entry.merge) skin.merges.push_back(*entry.merge);
    if (const auto plan = plan_skin(skin); plan || !is_crossing(plan.error())) continue;
    if (entry.link) skin.links.pop_back();
    if (entry.merge) skin.merges.pop_back();
    lost.push_back(entry.id);
  }
  const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
  std::sort(skin.links.begin(), skin.links.end(), by_id);
  std::sort(skin.merges.begin(), skin.merges.end(), by_id);
}

}  // namespace

void forget_points(Skin& skin, const std::vector<std::uint32_t>& points, std::vector<std::uint32_t>& lost) {
  const auto gone = [&](std::uint32_t id) {
    return std::find(points.begin(), points.end(), id) != points.end();
  };
  std::erase_if(skin.links, [&](SkinLink& link) {
    std::erase_if(link.a, gone);
    std::erase_if(link.b, gone);
    if (!link.a.empty() && !link.b.empty()) return false;
    lost.push_back(link.id);
    return true;
  });
  std::erase_if(skin.merges, [&](SkinMerge& merge) {
    std::erase_if(merge.members, gone);
    if (merge.members.size() >= 2 && !gone(merge.target)) return false;
    lost.push_back(merge.id);
    return true;
  });
}

void forget_section(Skin& skin, std::uint32_t section, std::vector<std::uint32_t>& lost) {
  const auto of = [&](const auto& entry) {
    if (entry.first != section && entry.second != section) return false;
    lost.push_back(entry.id);
    return true;
  };
  std::erase_if(skin.links, of);
  std::erase_if(skin.merges, of);
}

void map_anchors(Skin& skin, int section, const std::function<double(double)>& map) {
  for (auto& row : skin.smooth.anchors)
    if (row.size() == skin.sections.size()) row[std::size_t(section)] = map(row[std::size_t(section)]);
}

double inserted_parameter(double u, int spans, int span, bool closed) {
  const double turn = closed ? std::floor(u) : 0;
  double x = (u - turn) * spans;
  if (x > span) x = x < span + 1 ? span + 2 * (x - span) : x + 1;
  return turn + x / (spans + 1);
}

double deleted_parameter(double u, int spans, int point, bool closed) {
  const double turn = closed ? std::floor(u) : 0;
  double x = (u - turn) * spans;
  if (!closed && point == 0) {
    x = std::max(x - 1, 0.0);
  } else if (!closed && point == spans) {
    x = std::min(x, double(spans - 1));
  } else if (point == 0) {
    if (x < 1) x += spans;
    x = x <= spans - 1 ? x - 1 : spans - 2 + (x - (spans - 1)) / 2;
  } else if (x > point - 1) {
    x = x < point + 1 ? point - 1 + (x - (point - 1)) / 2 : x - 1;
  }
  return turn + x / (spans - 1);
}

Result<SkinEdit> accepted(const Skin& before, SkinEdit edit) {
  auto plan = plan_skin(edit.skin);
  if (!plan && is_crossing(plan.error())) {
    drop_crossing(edit.skin, edit.lost);
    plan = plan_skin(edit.skin);
  }
  if (!plan && plan_skin(before)) return plan.error();
  std::sort(edit.lost.begin(), edit.lost.end());
  if (!edit.lost.empty())
    edit.notes.push_back(
        make_warning(w_correspondence_lost,
                     edit.lost.size() == 1
                         ? std::string("A correspondence lost its points or would cross, and was deleted.")
                         : std::to_string(edit.lost.size()) +
                               " correspondences lost their points or would cross, and were deleted.",
                     "Undo brings them back."));
  return edit;
}

int section_with(const Skin& skin, std::uint32_t point) {
  for (int k = 0; k < skin.section_count(); ++k)
    if (find_point(skin.sections[std::size_t(k)], point) >= 0) return k;
  return -1;
}

Message no_such_section() {
  return make_error(e_skin_index, "There is no such section.", "Select one of the sections.");
}

Message no_such_point() {
  return make_error(e_skin_index, "There is no such point.", "Select points of sections.");
}

}  // namespace hariko::detail
