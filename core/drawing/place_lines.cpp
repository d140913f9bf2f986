#include "core/drawing/place_lines.hpp"

#include <algorithm>
#include <utility>

namespace hariko {

namespace {

constexpr int root_rounds = 40;
constexpr double root_width = 1e-9;     ///< relative to a grid edge
constexpr double join_distance = 1e-3;  ///< relative to a grid edge
constexpr std::size_t no_partner = std::size_t(-1);

/// End of a curve.
struct LineEnd {
  std::size_t line;
  bool back;
  std::size_t number() const { return 2 * line + (back ? 1 : 0); }
};

/// For each end of a curve, by its number, the end that it is joined to.
std::vector<std::size_t> partners_of_ends(const std::vector<PlaceLine>& lines) {
  const auto place = [&](const LineEnd& end) -> const SurfacePlace& {
    return end.back ? lines[end.line].back() : lines[end.line].front();
  };
  std::vector<LineEnd> ends;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (!is_closed(lines[i])) ends.insert(ends.end(), {LineEnd{i, false}, LineEnd{i, true}});
  std::stable_sort(ends.begin(), ends.end(), [&](const LineEnd& a, const LineEnd& b) {
    return place(a).position.x() < place(b).position.x();
  });
  std::vector<std::size_t> out(2 * lines.size(), no_partner);
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      const SurfacePlace &a = place(ends[i]), &b = place(ends[j]);
      const double near = join_distance * std::max(a.edge, b.edge);
      if (b.position.x() - a.position.x() > near) break;
      if (a.patch == b.patch || (a.position - b.position).norm() > near) continue;
      std::size_t &first = out[ends[i].number()], &second = out[ends[j].number()];
      if (first == no_partner && second == no_partner) first = ends[j].number(), second = ends[i].number();
    }
  return out;
}

}  // namespace

bool is_closed(const PlaceLine& line) {
  return line.size() > 2 && line.front().parameter == line.back().parameter &&
         line.front().patch == line.back().patch;
}

void join_lines(std::vector<PlaceLine>& lines) {
  const std::vector<std::size_t> partner = partners_of_ends(lines);
  std::vector<bool> used(lines.size(), false);
  std::vector<PlaceLine> joined;
  const auto chain = [&](std::size_t line, bool reversed) {
    PlaceLine out;
    while (!used[line]) {
      used[line] = true;
      if (reversed)
        out.insert(out.end(), lines[line].rbegin(), lines[line].rend());
      else
        out.insert(out.end(), lines[line].begin(), lines[line].end());
      const std::size_t other = partner[2 * line + (reversed ? 0 : 1)];
      if (other == no_partner) break;
      line = other / 2;
      reversed = other % 2 == 1;
      if (used[line]) out.push_back(out.front());
    }
    joined.push_back(std::move(out));
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (used[i]) continue;
    if (partner[2 * i] == no_partner)
      chain(i, false);
    else if (partner[2 * i + 1] == no_partner)
      chain(i, true);
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (!used[i]) chain(i, false);
  lines = std::move(joined);
}

double crossing_fraction(const std::function<double(double)>& value, double at_begin, double at_end,
                         double noise) {
  const auto positive = [noise](double x) { return x >= -noise; };
  double from = 0, to = 1;
  // False position, with bisection in every third round.
  for (int round = 0; round < root_rounds && to - from > root_width; ++round) {
    double x = 0.5 * (from + to);
    if (round % 3 != 2 && at_end != at_begin)
      x = std::clamp(from + (to - from) * at_begin / (at_begin - at_end), from + 0.01 * (to - from),
                     to - 0.01 * (to - from));
    const double here = value(x);
    if (positive(here) == positive(at_begin))
      from = x, at_begin = here;
    else
      to = x, at_end = here;
  }
  return 0.5 * (from + to);
}

}  // namespace hariko
