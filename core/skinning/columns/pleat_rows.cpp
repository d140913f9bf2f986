#include "core/skinning/columns/pleat_rows.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/assert.hpp"
#include "core/skinning/columns/knot_shift.hpp"

namespace hariko {

namespace {

constexpr int max_intervals = 10'000;
/// Number of row intervals of strips whose lines twist: enough for an area accurate to 2e-5 at twists of half
/// a step between points.
constexpr int twist_intervals = 4;

/// Distributes intervals: one more for the segment with the longest intervals, until the total is reached.
std::vector<int> shares(const std::vector<double>& breaks, std::vector<int> least, int total) {
  int given = 0;
  for (const int n : least) given += n;
  for (; given < total; ++given) {
    std::size_t longest = 0;
    for (std::size_t k = 1; k < least.size(); ++k)
      if ((breaks[k + 1] - breaks[k]) / least[k] >
          (breaks[longest + 1] - breaks[longest]) / least[longest] + 1e-12)
        longest = k;
    ++least[longest];
  }
  return least;
}

/// Lines that start at one point of a section, in runs of two or more.
std::vector<std::vector<int>> fans(const PlannedStrip& strip, StripSide apex, bool closed) {
  const auto at = [&](std::size_t p) { return apex == StripSide::a ? strip.lines[p].a : strip.lines[p].b; };
  std::vector<std::vector<int>> out;
  for (std::size_t p = 0; p < strip.lines.size(); ++p) {
    if (p > 0 && at(p) == at(p - 1))
      out.back().push_back(int(p));
    else
      out.push_back({int(p)});
  }
  if (closed && out.size() > 1 && at(0) == at(strip.lines.size() - 1)) {
    out.back().insert(out.back().end(), out.front().begin(), out.front().end());
    out.erase(out.begin());
  }
  std::erase_if(out, [](const auto& run) { return run.size() < 2; });
  return out;
}

class RowBuilder {
 public:
  RowBuilder(const Skin& skin, const SkinPlan& plan, int strip)
      : skin_(skin), plan_(plan), strip_(plan.strips[std::size_t(strip)]) {
    out_.start_group.assign(strip_.lines.size(), -1);
    out_.end_group.assign(strip_.lines.size(), -1);
  }

  StripRows build() {
    std::vector<double> breaks{strip_.v0};
    for (const PlannedMerge& merge : strip_.merges) breaks.push_back(merge_level(merge));
    breaks.push_back(strip_.v1);
    std::sort(breaks.begin(), breaks.end());
    const double close = 1e-9 * (strip_.v1 - strip_.v0);
    breaks.erase(std::unique(breaks.begin(), breaks.end(), [&](double a, double b) { return b - a < close; }),
                 breaks.end());
    breaks.back() = strip_.v1;
    if (skin_.pleat.rows == RowPlacement::path)
      path_rows(breaks);
    else
      even_rows(breaks);
    for (const PlannedMerge& merge : strip_.merges) add_merge(merge);
    if (collars()) {
      add_collar(StripSide::a);
      add_collar(StripSide::b);
    }
    return std::move(out_);
  }

 private:
  bool collars() const { return skin_.pleat.collars; }
  double merge_level(const PlannedMerge& merge) const {
    return strip_.v0 + merge.v * (strip_.v1 - strip_.v0);
  }

  void even_rows(const std::vector<double>& breaks) {
    const double wanted = (strip_.v1 - strip_.v0) * skin_.path.spans() * skin_.pleat.density;
    int total = std::max(strip_.twist == 0 ? 1 : twist_intervals,
                         int(std::lround(std::min(wanted, double(max_intervals)))));
    std::vector<int> least(breaks.size() - 1, 1);
    if (collars()) {
      const bool a = inside_surface(skin_, plan_, strip_.a), b = inside_surface(skin_, plan_, strip_.b);
      total = std::max(total, 1 + int(a) + int(b));
      // A collar and a merge need separate rows.
      if (a && least.size() > 1) least.front() = 2;
      if (b && least.size() > 1) least.back() = 2;
    }
    int needed = 0;
    for (const int n : least) needed += n;
    least = shares(breaks, least, std::max(total, needed));
    for (std::size_t k = 0; k < least.size(); ++k)
      for (int i = 0; i < least[k]; ++i)
        out_.v.push_back(breaks[k] + (breaks[k + 1] - breaks[k]) * i / least[k]);
    out_.v.push_back(breaks.back());
  }

  /// Places rows at the path's control points, except too near to a section or a merge.
  void path_rows(const std::vector<double>& breaks) {
    const int spans = skin_.path.spans();
    out_.v = breaks;
    for (int turn = 0; turn < 2; ++turn)
      for (int i = 0; i < spans + (skin_.path.closed ? 0 : 1); ++i) {
        const double v = double(i) / spans + turn;
        if (!(v > strip_.v0 && v < strip_.v1) || (turn == 1 && !skin_.path.closed)) continue;
        if (std::all_of(breaks.begin(), breaks.end(),
                        [&](double b) { return std::abs(b - v) >= 0.35 / spans - 1e-12; }))
          out_.v.push_back(v);
      }
    std::sort(out_.v.begin(), out_.v.end());
  }

  int row_at(double v) const {
    int best = 0;
    for (int q = 1; q <= out_.last(); ++q)
      if (std::abs(out_.v[std::size_t(q)] - v) < std::abs(out_.v[std::size_t(best)] - v)) best = q;
    return best;
  }
  const Vector3& offset(StripSide side, int point) const {
    return plan_.offsets[std::size_t(side == StripSide::a ? strip_.a : strip_.b)][std::size_t(point)];
  }
  int point_of(int line, StripSide side) const {
    const PointPair& pair = strip_.lines[std::size_t(line)];
    return side == StripSide::a ? pair.a : pair.b;
  }

  /// Adds a group that meets at M = (1 - m) mean of the members + m target, m measured from the members.
  void add_group(std::vector<int> lines, StripSide tip, int row) {
    LineGroup group;
    group.lines = std::move(lines);
    group.tip = tip;
    group.row = row;
    const StripSide members = tip == StripSide::a ? StripSide::b : StripSide::a;
    Vector3 mean = Vector3::Zero();
    for (const int p : group.lines)
      mean += offset(members, point_of(p, members)) / double(group.lines.size());
    // Lines at a side between rails meet on the rail.
    const auto holds = [&](int p) {
      return std::find(group.lines.begin(), group.lines.end(), p) != group.lines.end();
    };
    const int last = int(strip_.lines.size()) - 1;
    if (plan_.frames.mode() == FrameMode::two_rail && holds(0) != holds(last))
      mean = offset(members, point_of(holds(0) ? 0 : last, members));
    const double t = (out_.v[std::size_t(row)] - strip_.v0) / (strip_.v1 - strip_.v0);
    const double m = members == StripSide::a ? t : 1 - t;
    group.offset = (1 - m) * mean + m * offset(tip, point_of(group.lines[0], tip));
    auto& of = tip == StripSide::a ? out_.start_group : out_.end_group;
    for (const int p : group.lines) of[std::size_t(p)] = int(out_.groups.size());
    out_.groups.push_back(std::move(group));
  }

  void add_merge(const PlannedMerge& merge) {
    std::vector<int> lines;
    for (const int member : merge.members)
      for (std::size_t p = 0; p < strip_.lines.size(); ++p) {
        const PointPair pair =
            merge.side == StripSide::a ? PointPair{member, merge.target} : PointPair{merge.target, member};
        if (strip_.lines[p] == pair) lines.push_back(int(p));
      }
    HARIKO_ASSERT(lines.size() == merge.members.size(), "the lines of a merge are forced");
    add_group(std::move(lines), merge.side == StripSide::a ? StripSide::b : StripSide::a,
              row_at(merge_level(merge)));
  }

  /// Lets fans at an interior section meet on the row beside it, so that its own vertices stay regular.
  void add_collar(StripSide apex) {
    const bool a = apex == StripSide::a;
    if (!inside_surface(skin_, plan_, a ? strip_.a : strip_.b) || out_.last() < 2) return;
    for (auto& fan : fans(strip_, apex, plan_.closed_sections)) {
      const auto& of = a ? out_.start_group : out_.end_group;
      if (std::any_of(fan.begin(), fan.end(), [&](int p) { return of[std::size_t(p)] >= 0; })) continue;
      add_group(std::move(fan), apex, a ? 1 : out_.last() - 1);
    }
  }

  const Skin& skin_;
  const SkinPlan& plan_;
  const PlannedStrip& strip_;
  StripRows out_;
};

}  // namespace

bool inside_surface(const Skin& skin, const SkinPlan& plan, int section) {
  const bool end = !skin.path.closed && (section == 0 || section == skin.section_count() - 1);
  return !end ||
         (skin.caps == Caps::dome && plan.closed_sections && skin.sections[std::size_t(section)].size() > 2);
}

int StripRows::shared(int p, int q) const {
  if (const int g = start_group[std::size_t(p)]; g >= 0 && q <= groups[std::size_t(g)].row) return g;
  if (const int g = end_group[std::size_t(p)]; g >= 0 && q >= groups[std::size_t(g)].row) return g;
  return -1;
}

StripRows strip_rows(const Skin& skin, const SkinPlan& plan, int strip) {
  return RowBuilder(skin, plan, strip).build();
}

Vector3 line_offset(const SkinPlan& plan, const PlannedStrip& strip, const StripRows& rows, int p, int q) {
  const PointPair& line = strip.lines[std::size_t(p)];
  // Stations between which the line is straight.
  double from = strip.v0, to = strip.v1;
  Vector3 begin = plan.offsets[std::size_t(strip.a)][std::size_t(line.a)];
  Vector3 end = plan.offsets[std::size_t(strip.b)][std::size_t(line.b)];
  const auto station = [&](int g) {
    if (g < 0) return;
    const LineGroup& group = rows.groups[std::size_t(g)];
    const double v = rows.v[std::size_t(group.row)];
    if (q <= group.row && v < to) to = v, end = group.offset;
    if (q > group.row && v > from) from = v, begin = group.offset;
  };
  station(rows.start_group[std::size_t(p)]);
  station(rows.end_group[std::size_t(p)]);
  const double t = (rows.v[std::size_t(q)] - from) / (to - from);
  return (1 - t) * begin + t * end;
}

std::vector<LineBow> line_bows(const SkinPlan& plan, const PlannedStrip& strip, const StripRows& rows) {
  if (strip.twist == 0) return {};
  const auto &a = plan.offsets[std::size_t(strip.a)], &b = plan.offsets[std::size_t(strip.b)];
  const KnotShift shift_a(a), shift_b(b);
  const double back_a = strip.twist * double(a.size()), back_b = strip.twist * double(b.size());
  const auto along = [&](int q) { return (rows.v[std::size_t(q)] - strip.v0) / (strip.v1 - strip.v0); };
  std::vector<char> ends(rows.v.size(), 0);
  ends.front() = ends.back() = 1;
  const LimitSystem limits(ends, false);
  std::vector<LineBow> out;
  for (const PointPair& line : strip.lines) {
    const Vector3 &begin = a[std::size_t(line.a)], &end = b[std::size_t(line.b)];
    LineBow& bow = out.emplace_back();
    bow.rows.assign(rows.v.size(), Vector3::Zero());
    for (int q = 1; q < rows.last(); ++q) {
      const double t = along(q);
      // The smoothstep makes lines leave and meet the sections without sideways motion.
      const double gone = t * t * (3 - 2 * t);
      const Vector3 from = shift_a.at(line.a - gone * back_a), to = shift_b.at(line.b + (1 - gone) * back_b);
      bow.rows[std::size_t(q)] = (1 - t) * (from - begin) + t * (to - end);
    }
    limits.solve(bow.rows.data());
    const int last = rows.last() - 1;
    bow.first = bow.rows[1] + along(1) * (end - shift_b.at(line.b + back_b));
    bow.last = bow.rows[std::size_t(last)] + (1 - along(last)) * (begin - shift_a.at(line.a - back_a));
  }
  return out;
}

}  // namespace hariko
