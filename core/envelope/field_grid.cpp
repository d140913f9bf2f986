#include "core/envelope/field_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hariko {

namespace {

constexpr double largest_share = 0.93;  ///< of a component that counts alone
constexpr double reference_nodes = 120'000;
constexpr double largest_offset = 0.4;  ///< of the cell
constexpr double kept_cover = 0.9;      ///< of what was covered when the grid was chosen

/// Components of the nodes with a flag, over faces (6 neighbours) or also edges and corners (26), from runs
/// of such nodes along x. Numbered by their first nodes. O(nodes).
class Components {
 public:
  Components(const FlagGrid& grid, char flag, bool wide) : grid_(grid) {
    find_runs(flag);
    const auto [nx, ny, nz] = grid.size();
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j) {
        if (j > 0) join_rows(j - 1, k, j, k, wide);
        if (k == 0) continue;
        join_rows(j, k - 1, j, k, wide);
        if (wide && j > 0) join_rows(j - 1, k - 1, j, k, wide);
        if (wide && j + 1 < ny) join_rows(j + 1, k - 1, j, k, wide);
      }
    number();
  }
  int count() const { return int(sizes_.size()); }
  const std::vector<std::size_t>& sizes() const { return sizes_; }
  int largest() const { return int(std::max_element(sizes_.begin(), sizes_.end()) - sizes_.begin()); }
  bool touches_border(int label) const { return border_[std::size_t(label)]; }

  /// Sets the flags of the nodes of those components for which `chosen(label)` is true.
  template <class Chosen>
  void mark(std::vector<char>& inside, const Chosen& chosen) const {
    for (const Run& run : runs_)
      if (chosen(run.label))
        std::fill_n(inside.begin() + std::ptrdiff_t(run.first), run.high - run.low + 1, 1);
  }

 private:
  struct Run {
    std::size_t first;  ///< node
    int low, high;      ///< in its row
    int parent, label;
  };

  void find_runs(char flag) {
    const auto [nx, ny, nz] = grid_.size();
    rows_.push_back(0);
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j) {
        const std::size_t row = grid_.index(0, j, k);
        for (int i = 0; i < nx; ++i) {
          if (grid_.inside[row + std::size_t(i)] != flag) continue;
          const int low = i;
          while (i + 1 < nx && grid_.inside[row + std::size_t(i) + 1] == flag) ++i;
          runs_.push_back({row + std::size_t(low), low, i, int(runs_.size()), 0});
        }
        rows_.push_back(int(runs_.size()));
      }
  }

  int root(int run) {
    while (runs_[std::size_t(run)].parent != run) {
      int& parent = runs_[std::size_t(run)].parent;
      run = parent = runs_[std::size_t(parent)].parent;
    }
    return run;
  }

  void join_rows(int ja, int ka, int jb, int kb, bool wide) {
    const int ny = grid_.size()[1], slack = wide ? 1 : 0;
    const std::size_t row_a = std::size_t(ka * ny + ja), row_b = std::size_t(kb * ny + jb);
    int a = rows_[row_a], b = rows_[row_b];
    while (a < rows_[row_a + 1] && b < rows_[row_b + 1]) {
      const Run &one = runs_[std::size_t(a)], &other = runs_[std::size_t(b)];
      if (one.low <= other.high + slack && other.low <= one.high + slack) {
        const int ra = root(a), rb = root(b);
        runs_[std::size_t(std::max(ra, rb))].parent = std::min(ra, rb);
      }
      one.high < other.high ? ++a : ++b;
    }
  }

  /// The root of a component is its first run.
  void number() {
    const auto [nx, ny, nz] = grid_.size();
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      Run& run = runs_[r];
      const auto top = std::size_t(root(int(r)));
      if (top == r) {
        run.label = count();
        sizes_.push_back(0);
        border_.push_back(false);
      } else {
        run.label = runs_[top].label;
      }
      sizes_[std::size_t(run.label)] += std::size_t(run.high - run.low) + 1;
      const int row = int(run.first) / nx, j = row % ny, k = row / ny;
      if (run.low == 0 || run.high == nx - 1 || j == 0 || j == ny - 1 || k == 0 || k == nz - 1)
        border_[std::size_t(run.label)] = true;
    }
  }

  const FlagGrid& grid_;
  std::vector<Run> runs_;
  std::vector<int> rows_;  ///< first run of each row, and one more
  std::vector<std::size_t> sizes_;
  std::vector<bool> border_;
};

long euler_number(const FlagGrid& grid) {
  const auto [nx, ny, nz] = grid.size();
  long chi = 0;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        bool full[2][2][2];
        for (int c = 0; c < 2; ++c)
          for (int b = 0; b < 2; ++b)
            for (int a = 0; a < 2; ++a)
              full[a][b][c] =
                  i + a < nx && j + b < ny && k + c < nz && grid.inside[grid.index(i + a, j + b, k + c)];
        if (!full[0][0][0]) continue;
        const bool x = full[1][0][0], y = full[0][1][0], z = full[0][0][1];
        const bool xy = x && y && full[1][1][0], yz = y && z && full[0][1][1], zx = z && x && full[1][0][1];
        const bool cube = xy && yz && zx && full[1][1][1];
        chi += 1 - (x + y + z) + (xy + yz + zx) - cube;
      }
  return chi;
}

/// Without flags.
FlagGrid planes_over(const Vector3& low, const Vector3& high, double step) {
  FlagGrid grid;
  const Vector3 middle = 0.5 * (low + high);
  for (int axis = 0; axis < 3; ++axis) {
    const int reach = int(std::ceil((high[axis] - middle[axis]) / step)) + 2;
    for (int i = -reach; i <= reach; ++i) grid.planes[std::size_t(axis)].push_back(middle[axis] + i * step);
  }
  return grid;
}

/// Values of a field at the nodes. In boxes of nodes where they are surely negative, or not below `above`,
/// they are only that, which leaves those near the surface.
class SampledField {
 public:
  SampledField(const FlagGrid& grid, const GridField& field, double above)
      : grid_(grid), field_(field), above_(above) {
    const Node size = grid.size();
    values_.resize(std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]));
    fill({0, 0, 0}, size);
  }
  std::vector<double> take() && { return std::move(values_); }

 private:
  using Node = std::array<int, 3>;
  static constexpr int few_nodes = 8;  ///< a look at all of them costs no more than the search for boxes

  void fill(const Node& from, const Node& to) {
    const Node count = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    if (count[0] * count[1] * count[2] <= few_nodes) {
      for_rows(from, to, [&](int j, int k) {
        for (int i = from[0]; i < to[0]; ++i)
          values_[grid_.index(i, j, k)] = field_.value(grid_.point(i, j, k));
      });
      return;
    }
    const Vector3 low = grid_.point(from[0], from[1], from[2]);
    const Vector3 high = grid_.point(to[0] - 1, to[1] - 1, to[2] - 1);
    if (const int side = field_.side(0.5 * (low + high), 0.5 * (high - low).norm(), above_); side != 0) {
      for_rows(from, to, [&](int j, int k) {
        std::fill_n(values_.begin() + std::ptrdiff_t(grid_.index(from[0], j, k)), count[0], side * 1e300);
      });
      return;
    }
    const auto longest = std::size_t(std::max_element(count.begin(), count.end()) - count.begin());
    Node end = to, begin = from;
    end[longest] = begin[longest] = (from[longest] + to[longest]) / 2;
    fill(from, end);
    fill(begin, to);
  }

  template <class Row>
  static void for_rows(const Node& from, const Node& to, const Row& row) {
    for (int k = from[2]; k < to[2]; ++k)
      for (int j = from[1]; j < to[1]; ++j) row(j, k);
  }

  const FlagGrid& grid_;
  const GridField& field_;
  double above_;
  std::vector<double> values_;
};

std::vector<double> sampled(const FlagGrid& grid, const GridField& field, double above) {
  return SampledField(grid, field, above).take();
}

/// Every second plane of a grid, with flags of what lies below a limit; padded so that the border is outside.
FlagGrid sublattice(const FlagGrid& fine, const std::vector<double>& values, const std::array<int, 3>& parity,
                    double limit) {
  FlagGrid out;
  const auto size = fine.size();
  std::array<std::vector<int>, 3> use;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int half = (size[axis] - 1) / 2;
    for (int i = (half + parity[axis]) % 2; i < size[axis]; i += 2) {
      use[axis].push_back(i);
      out.planes[axis].push_back(fine.planes[axis][std::size_t(i)]);
    }
  }
  out.inside.resize(use[0].size() * use[1].size() * use[2].size());
  std::size_t at = 0;
  for (std::size_t k = 0; k < use[2].size(); ++k)
    for (std::size_t j = 0; j < use[1].size(); ++j)
      for (std::size_t i = 0; i < use[0].size(); ++i, ++at) {
        const bool border = i == 0 || j == 0 || k == 0 || i + 1 == use[0].size() || j + 1 == use[1].size() ||
                            k + 1 == use[2].size();
        out.inside[at] = !border && values[fine.index(use[0][i], use[1][j], use[2][k])] < limit;
      }
  return out;
}

double covered_share(const FlagGrid& grid, const std::vector<Vector3>& points) {
  if (points.empty()) return 1;
  std::size_t inside = 0;
  for (const Vector3& p : points) {
    std::array<int, 3> node;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& planes = grid.planes[axis];
      const double x = p[Eigen::Index(axis)];
      const auto above = std::lower_bound(planes.begin(), planes.end(), x);
      std::size_t i = std::size_t(std::min(above - planes.begin(), std::ptrdiff_t(planes.size()) - 1));
      if (i > 0 && x - planes[i - 1] < planes[i] - x) --i;
      node[axis] = int(i);
    }
    inside += std::size_t(grid.inside[grid.index(node[0], node[1], node[2])]);
  }
  return double(inside) / double(points.size());
}

/// Leaves out planes whose slice equals a neighbour's while the topology stays: large quads come from that.
class PlaneRemoval {
 public:
  PlaneRemoval(FlagGrid& grid, double limit, const GridTopology& topology)
      : grid_(grid), limit_(limit), topology_(topology) {}

  void run() {
    while (step()) {
    }
  }

 private:
  struct Choice {
    double width;
    int axis, low;  ///< plane; its mirror image goes, too
  };

  bool same_slice(int axis, int a, int b) const {
    const auto size = grid_.size();
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int i = 0; i < size[std::size_t(u)]; ++i)
      for (int j = 0; j < size[std::size_t(v)]; ++j) {
        std::array<int, 3> p{}, q{};
        p[std::size_t(axis)] = a, q[std::size_t(axis)] = b;
        p[std::size_t(u)] = q[std::size_t(u)] = i;
        p[std::size_t(v)] = q[std::size_t(v)] = j;
        if (grid_.inside[grid_.index(p[0], p[1], p[2])] != grid_.inside[grid_.index(q[0], q[1], q[2])])
          return false;
      }
    return true;
  }
  bool removable(int axis, int at) const {
    const int count = grid_.size()[std::size_t(axis)];
    return at > 0 && at < count - 1 && (same_slice(axis, at, at - 1) || same_slice(axis, at, at + 1));
  }
  double width(int axis, int at) const {
    const auto& planes = grid_.planes[std::size_t(axis)];
    return planes[std::size_t(at + 1)] - planes[std::size_t(at - 1)];
  }

  bool step() {
    std::vector<Choice> choices;
    for (int axis = 0; axis < 3; ++axis) {
      const int count = grid_.size()[std::size_t(axis)];
      for (int low = 1; low <= (count - 1) / 2; ++low) {
        const int high = count - 1 - low;
        if (high < low || high == low + 1 || !removable(axis, low) || !removable(axis, high)) continue;
        const double w = std::max(width(axis, low), width(axis, high));
        if (w <= limit_ * (1 + 1e-9)) choices.push_back({std::round(w / limit_ * 1e9), axis, low});
      }
    }
    std::sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) {
      return std::array<double, 3>{a.width, double(a.axis), double(a.low)} <
             std::array<double, 3>{b.width, double(b.axis), double(b.low)};
    });
    for (const Choice& choice : choices) {
      const int high = grid_.size()[std::size_t(choice.axis)] - 1 - choice.low;
      FlagGrid other = without(choice.axis, choice.low, high);
      FlagGrid counted = other;
      if (!(tidy(counted) == topology_) || counted.inside != other.inside) continue;
      grid_ = std::move(other);
      return true;
    }
    return false;
  }

  FlagGrid without(int axis, int a, int b) const {
    FlagGrid out;
    std::array<std::vector<int>, 3> use;
    const auto size = grid_.size();
    for (int x = 0; x < 3; ++x)
      for (int i = 0; i < size[std::size_t(x)]; ++i)
        if (x != axis || (i != a && i != b)) {
          use[std::size_t(x)].push_back(i);
          out.planes[std::size_t(x)].push_back(grid_.planes[std::size_t(x)][std::size_t(i)]);
        }
    for (const int k : use[2])
      for (const int j : use[1])
        for (const int i : use[0]) out.inside.push_back(grid_.inside[grid_.index(i, j, k)]);
    return out;
  }

  FlagGrid& grid_;
  double limit_;
  GridTopology topology_;
};

/// What is inside has a field below it. `offset`: of the cell.
double limit_of(double offset, double cell) {
  return (offset + 0.02) * cell;
}

double grid_volume(const FlagGrid& grid, double cell) {
  return double(std::count(grid.inside.begin(), grid.inside.end(), 1)) * cell * cell * cell;
}

void keep(FlagGrid& grid, const Components& parts, int label) {
  std::fill(grid.inside.begin(), grid.inside.end(), 0);
  parts.mark(grid.inside, [&](int one) { return one == label; });
}

}  // namespace

GridTopology tidy(FlagGrid& grid) {
  const Components parts(grid, 1, false);
  GridTopology out;
  out.components = parts.count();
  if (out.components > 1) {
    const std::size_t total = std::accumulate(parts.sizes().begin(), parts.sizes().end(), std::size_t{0});
    const int largest = parts.largest();
    if (double(parts.sizes()[std::size_t(largest)]) > largest_share * double(total)) {
      keep(grid, parts, largest);
      out.components = 1;
    }
  }
  const Components outside(grid, 0, true);
  outside.mark(grid.inside, [&](int label) { return !outside.touches_border(label); });
  out.tunnels = out.components - int(euler_number(grid));
  return out;
}

std::size_t sign_changes(const FlagGrid& grid) {
  const auto [nx, ny, nz] = grid.size();
  std::size_t out = 0;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const char here = grid.inside[grid.index(i, j, k)];
        out += i + 1 < nx && grid.inside[grid.index(i + 1, j, k)] != here;
        out += j + 1 < ny && grid.inside[grid.index(i, j + 1, k)] != here;
        out += k + 1 < nz && grid.inside[grid.index(i, j, k + 1)] != here;
      }
  return out;
}

GridReference grid_reference(const GridRequest& request) {
  const Vector3 size = request.high - request.low;
  const double step = std::max(request.thickness / 3.3, std::cbrt(size.prod() / reference_nodes));
  FlagGrid grid = planes_over(request.low, request.high, step);
  for (const double f : sampled(grid, request.sharp, 0)) grid.inside.push_back(f < 0);
  const Components parts(grid, 1, false);
  GridReference out;
  if (parts.count() == 0) return out;
  // The solids are connected: what else there is comes of thin tips.
  keep(grid, parts, parts.largest());
  out.topology = tidy(grid);
  out.volume = double(std::count(grid.inside.begin(), grid.inside.end(), 1)) * step * step * step;
  out.area = double(sign_changes(grid)) * step * step;
  return out;
}

std::optional<ChosenGrid> choose_grid(const GridRequest& request, const GridReference& reference,
                                      const CancelToken& cancel) {
  if (reference.volume == 0) return std::nullopt;
  std::vector<double> ladder;
  const double crowded = std::sqrt(reference.area / request.budget);
  if (crowded > 1.05 * request.thickness)
    for (const double x : {1.35, 1.2, 1.1, 1.0, 0.9, 0.8}) ladder.push_back(crowded * x * request.detail);
  else
    for (const double x : {1.1, 1.0, 0.9, 0.8, 0.7, 0.62, 0.55, 0.48, 0.42})
      ladder.push_back(request.thickness * x * request.detail);
  const int wanted = 1, tunnels = reference.topology.tunnels;
  std::optional<ChosenGrid> best;
  double best_score = 1e300;
  for (const double h : ladder) {
    if (cancel.cancelled()) return std::nullopt;
    const FlagGrid fine = planes_over(request.low, request.high, h / 2);
    const std::vector<double> values = sampled(fine, request.field, limit_of(largest_offset, h));
    bool stop = false, over = true;
    for (int parity = 0; parity < 8; ++parity) {
      bool fits_plain = false;
      for (const double offset : {0.0, 0.12, 0.25, largest_offset}) {
        if (offset > 0 && request.few && fits_plain) break;
        const double limit = limit_of(offset, h);
        ChosenGrid one;
        one.grid = sublattice(fine, values, {parity & 1, parity >> 1 & 1, parity >> 2 & 1}, limit);
        one.topology = tidy(one.grid);
        one.choice = {h, parity, limit, covered_share(one.grid, request.covered)};
        const double faces = double(sign_changes(one.grid));
        over = over && faces > 2 * request.budget;
        const bool right = one.topology.components == wanted && one.topology.tunnels == tunnels;
        if (offset == 0) fits_plain = right;
        double error = grid_volume(one.grid, h) / reference.volume - 1;
        error = error > 0 ? 0.5 * error : -error;
        const double lost = std::max(0, tunnels - one.topology.tunnels),
                     extra = std::max(0, one.topology.tunnels - tunnels);
        const double score = 3 * std::abs(one.topology.components - wanted) + 2 * extra +
                             (tunnels >= 6 ? 0.2 : 1.0) * lost + 2.5 * (1 - one.choice.covered) + error +
                             0.5 * offset + 0.3 * faces / request.budget +
                             0.5 * std::max(0.0, faces / request.budget - 1);
        if (score < best_score - 1e-12) {
          best_score = score;
          best = std::move(one);
          stop = right && score < 0.2;
        }
      }
    }
    if (stop || over) break;
  }
  if (best) PlaneRemoval(best->grid, request.aspect * best->choice.cell, best->topology).run();
  return best;
}

std::optional<ChosenGrid> same_grid(const GridRequest& request, const GridReference& reference,
                                    const GridChoice& choice) {
  ChosenGrid out;
  out.choice = choice;
  const Vector3 middle = 0.5 * (request.low + request.high);
  for (int axis = 0; axis < 3; ++axis) {
    const double beside = 0.5 * (choice.parity >> axis & 1);
    const int reach = int(std::ceil((request.high[axis] - middle[axis]) / choice.cell)) + 1;
    for (int i = -reach; i + beside <= reach; ++i)
      out.grid.planes[std::size_t(axis)].push_back(middle[axis] + (i + beside) * choice.cell);
  }
  const auto [nx, ny, nz] = out.grid.size();
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const bool border = i == 0 || j == 0 || k == 0 || i + 1 == nx || j + 1 == ny || k + 1 == nz;
        out.grid.inside.push_back(!border && request.field.value(out.grid.point(i, j, k)) < choice.offset);
      }
  out.topology = tidy(out.grid);
  if (out.topology.components != 1 || out.topology.tunnels != reference.topology.tunnels ||
      covered_share(out.grid, request.covered) < kept_cover * choice.covered)
    return {};
  PlaneRemoval(out.grid, request.aspect * choice.cell, out.topology).run();
  return out;
}

}  // namespace hariko
