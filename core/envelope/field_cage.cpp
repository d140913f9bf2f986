#include "core/envelope/field_cage.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/small_solver.hpp"
#include "core/envelope/contour.hpp"

namespace hariko {

namespace {

constexpr double kept_eigenvalue = 0.03;  ///< of the largest
constexpr double fairing_rate = 0.22;     ///< larger ones turn small cages inside out
constexpr double roof = 0.35;             ///< of the cell: fairing may lift vertices so far
constexpr int bisections = 14;
constexpr std::size_t many_solids = 12;

/// Axes that suit most of the solids; a later solid must be clearly better than the world.
Matrix3 frame_of(const FieldScene& scene, const FieldCluster& cluster) {
  const auto score = [&](const Matrix3& axes) {
    double sum = 0;
    for (const Index s : cluster.solids) {
      const SolidDistance& d = scene.distances[s];
      const Matrix3 turn = (axes.transpose() * d.rotation()).cwiseAbs();
      double aligned = 0;
      for (int c = 0; c < 3; ++c) aligned += std::pow(turn.col(c).maxCoeff(), 8) / 3;
      sum += std::pow(d.half().prod(), 2.0 / 3) * aligned;
    }
    return sum;
  };
  // A plane of symmetry has to be one of the grid.
  const auto suits = [&](const Matrix3& axes) {
    return !scene.symmetry || axes.row(*scene.symmetry).cwiseAbs().maxCoeff() > 1 - 1e-12;
  };
  Matrix3 best = Matrix3::Identity();
  double most = score(best);
  for (const Index s : cluster.solids)
    if (const Matrix3& axes = scene.distances[s].rotation(); suits(axes))
      if (const double x = score(axes); x > 1.02 * most) most = x, best = axes;
  return best;
}

/// Holds as long as the field.
GridField grid_field(const UnionField& field) {
  return {[&field](const Vector3& p) { return field(p); },
          [&field](const Vector3& p, double radius, double above) { return field.side(p, radius, above); }};
}

class CageBuilder {
 public:
  CageBuilder(const FieldScene& scene, const FieldCluster& cluster, const FieldCageSettings& settings)
      : scene_(scene), cluster_(cluster), settings_(settings), axes_(frame_of(scene, cluster)) {
    place_frame();
  }

  /// Appends to the cage; false where there is none.
  bool build(const GridReference& reference, const GridChoice* known, FieldCage& out,
             const CancelToken& cancel) {
    std::optional<ChosenGrid> chosen;
    with_request([&](const GridRequest& request) {
      if (known) chosen = same_grid(request, reference, *known);
      if (!chosen) chosen = choose_grid(request, reference, cancel);
    });
    if (!chosen) return false;
    out.grids.push_back(chosen->choice);
    cell_ = chosen->choice.cell;
    UnionField field(local_, settings_.fillet * cell_, fillets());
    field_ = &field;
    const std::function<bool(const Vector3&)> inside = [&](const Vector3& p) {
      return field(p) < chosen->choice.offset;
    };
    contour_ = contour(chosen->grid, inside);
    if (contour_.quads.empty()) return false;
    find_neighbours();
    place(chosen->grid);
    relax();
    fair(6);
    fair(local_.size() > many_solids ? 10 : 28);
    append(out);
    const GridTopology topology = topology_of(contour_);
    out.components += topology.components;
    out.tunnels += topology.tunnels;
    out.wanted_tunnels += reference.topology.tunnels;
    return true;
  }

  GridReference reference() const {
    GridReference out;
    with_request([&](const GridRequest& request) { out = grid_reference(request); });
    return out;
  }

 private:
  void place_frame() {
    // Origin in the middle of the exact box, so that planes of symmetry are planes of the grid.
    Vector3 low, high;
    for (int i = 0; i < 3; ++i) {
      low[i] = 1e300, high[i] = -1e300;
      for (const Index s : cluster_.solids) {
        high[i] = std::max(high[i], scene_.distances[s].support(axes_.col(i)));
        low[i] = std::min(low[i], -scene_.distances[s].support(-axes_.col(i)));
      }
    }
    origin_ = axes_ * (0.5 * (low + high));
    half_ = 0.5 * (high - low);
    for (const Index s : cluster_.solids) local_.push_back(scene_.distances[s].in_frame(axes_, origin_));
    for (const FieldBar& bar : cluster_.bars) local_.push_back(bar.distance.in_frame(axes_, origin_));
  }

  /// Numbered as in the cluster. Bars come after the solids and have none.
  UnionField::Factors fillets() const {
    UnionField::Factors out;
    for (Index i = 0; i < cluster_.solids.size(); ++i)
      for (Index j = i + 1; j < cluster_.solids.size(); ++j) {
        const auto found = scene_.fillets.find(std::minmax(cluster_.solids[i], cluster_.solids[j]));
        if (found == scene_.fillets.end() || found->second == 1) continue;
        const double more = slack_fillet / std::max(settings_.fillet, 1e-3);
        out[{i, j}] = found->second < 1 ? found->second : 1 + (found->second - 1) * more;
      }
    return out;
  }

  /// The request's functions hold only during the call.
  template <class Use>
  void with_request(const Use& use) const {
    GridRequest request;
    double thickness = 1e300;
    for (const Index s : cluster_.solids) thickness = std::min(thickness, scene_.distances[s].thickness());
    const UnionField sharp(local_, 0.25 * thickness);
    // The fillet goes with the cell, which is about the thickness until the grid is chosen.
    const UnionField rounded(local_, settings_.fillet * 0.8 * thickness);
    request.sharp = grid_field(sharp);
    request.field = grid_field(rounded);
    request.low = -half_;
    request.high = half_;
    request.thickness = thickness;
    request.detail = settings_.detail;
    request.budget = settings_.budget;
    request.few = cluster_.solids.size() < 4;
    for (const Index s : cluster_.solids) {
      Vector3 mean = Vector3::Zero();
      for (const Vector3& p : scene_.points[s]) mean += p / double(scene_.points[s].size());
      for (const Vector3& p : scene_.points[s])
        request.covered.push_back(axes_.transpose() * (mean + 0.8 * (p - mean) - origin_));
    }
    use(request);
  }

  void find_neighbours() {
    neighbours_.assign(contour_.vertices.size(), {});
    for (const auto& quad : contour_.quads)
      for (std::size_t i = 0; i < 4; ++i) neighbours_[quad[i]].push_back(quad[(i + 1) % 4]);
  }

  /// Where the surface crosses a grid edge. Nodes that only the offset puts inside have no sign change.
  Vector3 crossing(const FlagGrid& grid, const std::array<int, 4>& edge) const {
    std::array<int, 3> n{edge[0], edge[1], edge[2]}, m = n;
    ++m[std::size_t(edge[3])];
    Vector3 a = grid.point(n[0], n[1], n[2]), b = grid.point(m[0], m[1], m[2]);
    const bool low_inside = (*field_)(a) < 0;
    if (low_inside == ((*field_)(b) < 0)) return field_->projected(0.5 * (a + b), 5, 0.5 * cell_);
    for (int round = 0; round < bisections; ++round) {
      const Vector3 middle = 0.5 * (a + b);
      ((*field_)(middle) < 0) == low_inside ? a = middle : b = middle;
    }
    return 0.5 * (a + b);
  }

  struct Crossing {
    Vector3 point, normal;
  };

  /// Four vertices share it.
  const Crossing& crossing_on(const FlagGrid& grid, const std::array<int, 4>& edge) {
    const std::size_t key = 3 * grid.index(edge[0], edge[1], edge[2]) + std::size_t(edge[3]);
    const auto [at, is_new] = crossings_.try_emplace(key);
    if (is_new) {
      at->second.point = crossing(grid, edge);
      at->second.normal = field_->gradient(at->second.point).stableNormalized();
    }
    return at->second;
  }

  void place(const FlagGrid& grid) {
    const std::size_t count = contour_.vertices.size();
    position_.resize(count);
    rank_.assign(count, 0);
    along_.assign(count, Matrix3::Identity());
    for (std::size_t v = 0; v < count; ++v) {
      const ContourVertex& vertex = contour_.vertices[v];
      std::vector<Vector3> points, normals;
      Vector3 mean = Vector3::Zero();
      for (const auto& edge : vertex.crossings) {
        const Crossing& at = crossing_on(grid, edge);
        points.push_back(at.point);
        normals.push_back(at.normal);
        mean += points.back() / double(vertex.crossings.size());
      }
      const Vector3 low = grid.point(vertex.cell[0], vertex.cell[1], vertex.cell[2]);
      const Vector3 high = grid.point(vertex.cell[0] + 1, vertex.cell[1] + 1, vertex.cell[2] + 1);
      place_vertex(v, points, normals, mean, low, high);
    }
  }

  void place_vertex(std::size_t v, const std::vector<Vector3>& points, const std::vector<Vector3>& normals,
                    const Vector3& mean, const Vector3& low, const Vector3& high) {
    Matrix3 products = Matrix3::Zero();
    Vector3 right = Vector3::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      products += normals[i] * normals[i].transpose();
      right += normals[i] * normals[i].dot(points[i] - mean);
    }
    const SymmetricAxes principal = symmetric_axes(products);
    Vector3 x = mean;
    int rank = 0;
    Matrix3 along = Matrix3::Identity();
    for (int i = 0; i < 3; ++i) {
      if (!(principal.values[i] >= kept_eigenvalue * principal.values[2])) continue;
      const Vector3 axis = principal.vectors.col(i);
      x += axis * (axis.dot(right) / principal.values[i]);
      along -= axis * axis.transpose();
      ++rank;
    }
    const Vector3 margin = 0.05 * (high - low);
    const Vector3 clipped = x.cwiseMax(low - margin).cwiseMin(high + margin);
    const bool feature = clipped == x && rank >= 2 && std::abs((*field_)(x)) < 0.05 * (high - low).minCoeff();
    position_[v] = field_->projected(mean, 5, 0.5 * cell_);
    if (!feature) return;
    position_[v] += settings_.crispness * (x - position_[v]);
    rank_[v] = rank;
    along_[v] = along;
  }

  Vector3 mean_step(std::size_t v, const std::vector<Vector3>& of) const {
    Vector3 mean = Vector3::Zero();
    for (const Index w : neighbours_[v]) mean += of[w] / double(neighbours_[v].size());
    return mean - of[v];
  }

  void relax() {
    for (int step = 0; step < 4; ++step) {
      const std::vector<Vector3> before = position_;
      for (std::size_t v = 0; v < before.size(); ++v) {
        Vector3 move = 0.4 * mean_step(v, before);
        if (rank_[v] >= 2) {
          position_[v] += along_[v] * move;
          continue;
        }
        const Vector3 n = field_->gradient(before[v]).stableNormalized();
        move -= move.dot(n) * n;
        position_[v] = field_->projected(before[v] + move, 2, 0.3 * cell_);
      }
    }
  }

  /// Bending goes out of the cage while no vertex comes into a solid: the field is never above the distance.
  void fair(int steps) {
    for (int step = 0; step < steps; ++step) {
      std::vector<Vector3> first(position_.size());
      for (std::size_t v = 0; v < first.size(); ++v) first[v] = mean_step(v, position_);
      for (std::size_t v = 0; v < first.size(); ++v) {
        const double firm = rank_[v] == 3   ? settings_.crispness
                            : rank_[v] == 2 ? 0.7 * settings_.crispness
                                            : 0;
        const Vector3 second = mean_step(v, first);
        Vector3 move = -fairing_rate * second;
        if (step % 2 == 0) move += 0.3 * fairing_rate * first[v];
        position_[v] += 0.8 * (1 - firm) * move;
      }
      for (Vector3& p : position_) clamp(p);
    }
  }
  void clamp(Vector3& p) const {
    const double f = (*field_)(p), target = std::clamp(f, 0.0, roof * cell_);
    if (f == target) return;
    const Vector3 g = field_->gradient(p);
    const double square = g.squaredNorm();
    if (square > 1e-6) p += (target - f) / square * g;
  }

  void append(FieldCage& out) const {
    const auto base = Index(out.positions.size());
    for (const Vector3& p : position_) {
      out.positions.push_back(origin_ + axes_ * p);
      out.cell.push_back(cell_);
    }
    for (const auto& quad : contour_.quads)
      out.quads.push_back({base + quad[0], base + quad[1], base + quad[2], base + quad[3]});
  }

  const FieldScene& scene_;
  const FieldCluster& cluster_;
  FieldCageSettings settings_;
  Matrix3 axes_;
  Vector3 origin_ = Vector3::Zero(), half_ = Vector3::Zero();
  std::vector<SolidDistance> local_;
  const UnionField* field_ = nullptr;
  double cell_ = 1;
  Contour contour_;
  std::unordered_map<std::size_t, Crossing> crossings_;
  std::vector<std::vector<Index>> neighbours_;
  std::vector<Vector3> position_;
  std::vector<int> rank_;
  std::vector<Matrix3> along_;  ///< projection to the directions in which a feature vertex may move
};

}  // namespace

std::vector<GridReference> grid_references(const FieldScene& scene) {
  std::vector<GridReference> out;
  for (const FieldCluster& cluster : scene.clusters)
    out.push_back(CageBuilder(scene, cluster, {}).reference());
  return out;
}

int tunnels_of(const FieldScene& scene) {
  int out = 0;
  for (const GridReference& reference : grid_references(scene)) out += reference.topology.tunnels;
  return out;
}

FieldCage field_cage(const FieldScene& scene, std::span<const GridReference> references,
                     const FieldCageSettings& settings, const CancelToken& cancel,
                     std::span<const GridChoice> known) {
  FieldCage out;
  const bool same = known.size() == scene.clusters.size();
  for (std::size_t c = 0; c < scene.clusters.size(); ++c)
    if (!CageBuilder(scene, scene.clusters[c], settings)
             .build(references[c], same ? &known[c] : nullptr, out, cancel))
      return {};
  return out;
}

}  // namespace hariko
