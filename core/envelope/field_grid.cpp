#include "core/envelope/field_grid.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

constexpr double largest_share = 0.93;  ///< of a component that counts alone
constexpr double reference_nodes = 120'000;
constexpr double kept_cover = 0.9;  ///< of what was covered when the grid was chosen

/// Components of the nodes with a flag, over faces (6 neighbours) or also edges and corners (26).
class Components {
 public:
  Components(const FlagGrid& grid, char flag, bool wide) : grid_(grid), label_(grid.inside.size(), -1) {
    const auto [nx, ny, nz] = grid.size();
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
          if (grid.inside[grid.index(i, j, k)] == flag && label_[grid.index(i, j, k)] < 0)
            flood(i, j, k, flag, wide);
  }
  int count() const { return int(sizes_.size()); }
  int label(std::size_t node) const { return label_[node]; }
  const std::vector<std::size_t>& sizes() const { return sizes_; }
  bool touches_border(int label) const { return border_[std::size_t(label)]; }

 private:
  void flood(int i, int j, int k, char flag, bool wide) {
    const auto [nx, ny, nz] = grid_.size();
    const int own = count();
    sizes_.push_back(0);
    border_.push_back(false);
    std::vector<std::array<int, 3>> open{{i, j, k}};
    label_[grid_.index(i, j, k)] = own;
    while (!open.empty()) {
      const auto [x, y, z] = open.back();
      open.pop_back();
      ++sizes_.back();
      if (x == 0 || y == 0 || z == 0 || x == nx - 1 || y == ny - 1 || z == nz - 1) border_.back() = true;
      for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            const int steps = std::abs(dx) + std::abs(dy) + std::abs(dz);
            if (steps == 0 || (!wide && steps > 1)) continue;
            const int a = x + dx, b = y + dy, c = z + dz;
            if (a < 0 || b < 0 || c < 0 || a >= nx || b >= ny || c >= nz) continue;
            const std::size_t node = grid_.index(a, b, c);
            if (grid_.inside[node] != flag || label_[node] >= 0) continue;
            label_[node] = own;
            open.push_back({a, b, c});
          }
    }
  }
  const FlagGrid& grid_;
  std::vector<int> label_;
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

FlagGrid sampled(const std::function<double(const Vector3&)>& field, const Vector3& low, const Vector3& high,
                 double step, std::vector<double>& values) {
  FlagGrid grid;
  const Vector3 middle = 0.5 * (low + high);
  for (int axis = 0; axis < 3; ++axis) {
    const int reach = int(std::ceil((high[axis] - middle[axis]) / step)) + 2;
    for (int i = -reach; i <= reach; ++i) grid.planes[std::size_t(axis)].push_back(middle[axis] + i * step);
  }
  const auto [nx, ny, nz] = grid.size();
  values.resize(std::size_t(nx) * std::size_t(ny) * std::size_t(nz));
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) values[grid.index(i, j, k)] = field(grid.point(i, j, k));
  return grid;
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

double grid_volume(const FlagGrid& grid, double cell) {
  return double(std::count(grid.inside.begin(), grid.inside.end(), 1)) * cell * cell * cell;
}

}  // namespace

GridTopology tidy(FlagGrid& grid) {
  const Components parts(grid, 1, false);
  GridTopology out;
  out.components = parts.count();
  if (out.components > 1) {
    std::size_t total = 0;
    for (const std::size_t s : parts.sizes()) total += s;
    const auto largest = std::max_element(parts.sizes().begin(), parts.sizes().end());
    if (double(*largest) > largest_share * double(total)) {
      const int label = int(largest - parts.sizes().begin());
      for (std::size_t i = 0; i < grid.inside.size(); ++i) grid.inside[i] = parts.label(i) == label;
      out.components = 1;
    }
  }
  const Components outside(grid, 0, true);
  for (std::size_t i = 0; i < grid.inside.size(); ++i)
    if (!grid.inside[i] && !outside.touches_border(outside.label(i))) grid.inside[i] = 1;
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
  std::vector<double> values;
  FlagGrid grid = sampled(request.sharp, request.low, request.high, step, values);
  for (const double f : values) grid.inside.push_back(f < 0);
  const Components parts(grid, 1, false);
  GridReference out;
  if (parts.count() == 0) return out;
  // The solids are connected: what else there is comes of thin tips.
  const int largest =
      int(std::max_element(parts.sizes().begin(), parts.sizes().end()) - parts.sizes().begin());
  for (std::size_t i = 0; i < grid.inside.size(); ++i) grid.inside[i] = parts.label(i) == largest;
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
    std::vector<double> values;
    const FlagGrid fine = sampled(request.field, request.low, request.high, h / 2, values);
    bool stop = false, over = true;
    for (int parity = 0; parity < 8; ++parity) {
      bool fits_plain = false;
      for (const double offset : {0.0, 0.12, 0.25, 0.4}) {
        if (offset > 0 && request.few && fits_plain) break;
        const double limit = (offset + 0.02) * h;
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
        out.grid.inside.push_back(!border && request.field(out.grid.point(i, j, k)) < choice.offset);
      }
  out.topology = tidy(out.grid);
  out.choice.covered = covered_share(out.grid, request.covered);
  if (out.topology.components != 1 || out.topology.tunnels != reference.topology.tunnels ||
      out.choice.covered < kept_cover * choice.covered)
    return {};
  PlaneRemoval(out.grid, request.aspect * choice.cell, out.topology).run();
  return out;
}

}  // namespace hariko
