#include "core/envelope/cage_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/envelope/sample_tree.hpp"

namespace hariko {

namespace {

constexpr int sample_density = 6;  ///< 28 samples a patch
constexpr double overshoot = 1.15;
constexpr double largest_step = 0.25, largest_push = 1.0;  ///< of the cell
constexpr int strict_rounds = 10;
constexpr double largest_strict_push = 2.5;  ///< of the cell: tips of solids that the grid has missed
constexpr double least_move = 0.1;           ///< of the tolerance: with less of it, pushing has ended
constexpr double strict_share = 0.9;         ///< of the tolerance: the last solve moves the surface a little
/// Spacing: of the diagonal.
constexpr EnclosureEffort quick{8, 200, 0.02, false}, thorough{16, 500, 0.001, false},
    last{16, 500, 0.001, true};
constexpr double chord_slack = 2e-5;  ///< of the diagonal

}  // namespace

Shaping length_tensions(const Polyhedron& cage) {
  const HalfEdgeMesh& mesh = cage.topology();
  std::vector<double> length;
  double mean = 0;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    length.push_back((cage.position(mesh.origin(h)) - cage.position(mesh.target(h))).norm());
    mean += length.back() / double(mesh.edge_count());
  }
  Shaping out;
  std::vector<std::pair<EdgeId, double>> betas;
  for (Index e = 0; e < mesh.edge_count(); ++e)
    betas.emplace_back(cage.edge_id(e),
                       std::clamp(std::pow(mean / std::max(length[e], 1e-9 * mean), 0.7), 0.2, 5.0));
  std::sort(betas.begin(), betas.end());
  for (const auto& [edge, beta] : betas) out.beta.set(edge, beta);
  return out;
}

namespace {

/// A tension divided by the square of a factor lets the middle of its curve go about that many times as far
/// from its chord.
Shaping tensions_of(const CageSurfaceRequest& request, const Polyhedron& cage) {
  Shaping out = length_tensions(cage);
  const HalfEdgeMesh& mesh = cage.topology();
  for (const CageFullness& one : request.fullness) {
    const Index h = mesh.find_half_edge(one.from, one.to);
    if (h == no_index) continue;
    const EdgeId edge = cage.edge_id(mesh.edge(h));
    out.beta.set(edge, out.beta.get_or(edge, 1.0) / (one.factor * one.factor));
  }
  return out;
}

class Pusher {
 public:
  Pusher(const CageSurfaceRequest& request, Polyhedron cage)
      : request_(request),
        input_{cage, tensions_of(request, cage), Mode::fair, request.origin},
        pattern_{Domain::triangle, sample_density},
        parameters_(pattern_.parameters()) {
    const HalfEdgeMesh& mesh = cage.topology();
    neighbours_.resize(mesh.vertex_count());
    for (Index h = 0; h < mesh.half_edge_count(); ++h) neighbours_[mesh.origin(h)].push_back(mesh.target(h));
    moved_.assign(mesh.vertex_count(), 0);
  }

  Result<CageSurface> run(const CancelToken& cancel) {
    CageSurface out{{}, input_.polyhedron, input_.shaping, 0, {}, 0, 0};
    // Surfaces between pushes start from the one before and are solved to the push's accuracy only.
    if (const auto made = make(Quality::drag, cancel, out); !made) return made.error();
    if (const auto pushed = push_as_tested(cancel, out); !pushed) return pushed.error();
    if (request_.strict) {
      if (const auto pushed = push_strictly(cancel, out); !pushed) return pushed.error();
      if (const auto made = make(Quality::final, cancel, out); !made) return made.error();
      out.check = check(out.made.surface, last, cancel);
      if (cancel.cancelled()) return cancelled();
    }
    out.folds = folds();
    out.cage = input_.polyhedron;
    return out;
  }

 private:
  struct Push {
    Vector3 direction = Vector3::Zero();  ///< weighted by depth
    double length = 0;
  };

  const HalfEdgeMesh& mesh() const { return input_.polyhedron.topology(); }

  static Message cancelled() { return make_error(e_cancelled, "The surface was cancelled."); }

  /// The surface over the cage as it is now, tested; pushes for what the test finds.
  Result<Done> make(Quality quality, const CancelToken& cancel, CageSurface& out) {
    auto made = surfacer_.rebuild(input_, quality, cancel);
    if (!made) return made.error();
    out.made = std::move(made).value();
    pushes_.assign(moved_.size(), {});
    take_samples(out.made.surface);
    out.worst = test();
    return Done{};
  }

  EnclosureReport check(const Surface& surface, EnclosureEffort effort, const CancelToken& cancel) const {
    effort.spacing *= request_.diagonal;
    return check_enclosure(surface, request_.placed, effort, chord_slack * request_.diagonal, cancel);
  }

  double tolerance() const { return request_.tolerance * request_.diagonal; }

  /// False where no vertex may move any further.
  Result<bool> apply_and_make(const CancelToken& cancel, CageSurface& out) {
    if (!apply()) return false;
    ++out.rounds;
    if (const auto made = make(Quality::drag, cancel, out); !made) return made.error();
    return true;
  }

  Result<Done> push_as_tested(const CancelToken& cancel, CageSurface& out) {
    while (out.worst > tolerance() && out.rounds < request_.rounds) {
      const auto moved = apply_and_make(cancel, out);
      if (!moved) return moved.error();
      if (!*moved) break;
    }
    return Done{};
  }

  /// Pushes what the independent check finds. A surface that folds by now is none: the next setting's turn.
  /// Nor is one that has lost a solid.
  Result<Done> push_strictly(const CancelToken& cancel, CageSurface& out) {
    reach_ = largest_strict_push;
    const double cell = *std::max_element(request_.cell.begin(), request_.cell.end());
    for (int round = 0; round < strict_rounds && folds() == 0; ++round) {
      EnclosureReport report = check(out.made.surface, quick, cancel);
      if (!cancel.cancelled() && report.worst <= strict_share * tolerance())
        report = check(out.made.surface, thorough, cancel);
      if (cancel.cancelled()) return cancelled();
      if (report.worst <= strict_share * tolerance() || report.worst > reach_ * cell) break;
      pushes_.assign(moved_.size(), {});
      push_outside(report);
      const auto moved = apply_and_make(cancel, out);
      if (!moved) return moved.error();
      if (!*moved) break;
      // What the push opened elsewhere goes first.
      if (const auto pushed = push_as_tested(cancel, out); !pushed) return pushed.error();
    }
    return Done{};
  }

  void take_samples(const Surface& surface) {
    std::vector<Index> all(surface.patch_count());
    std::iota(all.begin(), all.end(), Index{0});
    per_patch_ = std::size_t(pattern_.point_count());
    positions_.resize(all.size() * per_patch_);
    normals_.resize(positions_.size());
    surface.patches().evaluate_grid(all, pattern_, positions_, normals_);
    tree_.emplace(positions_, per_patch_);
  }

  /// Lets the corners of a sample's face go along a direction, by shares that lift the sample by `depth`.
  void push(std::size_t sample, double depth, const Vector3& direction) {
    const auto patch = Index(sample / per_patch_);
    const Vector2& parameter = parameters_[sample % per_patch_];
    const Index face = mesh().face(patch), from = mesh().face_begin(face), to = mesh().face_end(face);
    const double central = (1 - parameter.x() - parameter.y()) / double(to - from);
    double squares = 0;
    const auto weight = [&](Index h) {
      return central + (mesh().origin(h) == mesh().origin(patch) ? parameter.x() : 0.0) +
             (mesh().origin(h) == mesh().target(patch) ? parameter.y() : 0.0);
    };
    for (Index h = from; h < to; ++h) squares += weight(h) * weight(h);
    for (Index h = from; h < to; ++h) {
      const double length = std::min(weight(h) / squares, 1.0) * depth;
      Push& at = pushes_[mesh().origin(h)];
      at.direction += length * direction;
      at.length = std::max(at.length, length);
    }
  }

  double test() {
    double worst = 0;
    for (const SolidDistance& solid : request_.distances) {
      // Distances change by no more than the way.
      const auto far = [&](const Vector3& centre, double radius) { return solid(centre) > radius; };
      tree_->visit(far, [&](Index p) {
        for (std::size_t i = p * per_patch_; i < (p + 1) * per_patch_; ++i) {
          const double depth = -solid(positions_[i]);
          worst = std::max(worst, depth);
          if (!(depth > tolerance())) continue;
          const Vector3 g = solid.gradient(positions_[i]);
          push(i, depth, g.dot(normals_[i]) < 0.3 ? normals_[i] : g);
        }
      });
    }
    for (const PlacedSolid& solid : request_.placed)
      for (const Vector3& z : solid.test_points) {
        const std::size_t near = tree_->nearest(z);
        const double height = (z - positions_[near]).dot(normals_[near]);
        worst = std::max(worst, height);
        if (height > tolerance()) push(near, height, normals_[near]);
      }
    return worst;
  }

  void push_outside(const EnclosureReport& check) {
    for (const OutsidePoint& miss : check.points) {
      std::size_t best = miss.patch * per_patch_;
      double square = 1e300;
      for (std::size_t i = miss.patch * per_patch_; i < (miss.patch + 1) * per_patch_; ++i)
        if (const double s = (positions_[i] - miss.point).squaredNorm(); s < square) square = s, best = i;
      push(best, miss.distance + 0.3 * tolerance(), normals_[best]);
    }
  }

  /// False, and nothing moves, where no vertex may move any further.
  bool apply() {
    std::vector<Vector3> move(moved_.size(), Vector3::Zero());
    for (std::size_t v = 0; v < move.size(); ++v) {
      if (!(pushes_[v].length > 0)) continue;
      const double length = std::min({overshoot * pushes_[v].length, largest_step * request_.cell[v],
                                      std::max(0.0, reach_ * request_.cell[v] - moved_[v])});
      move[v] = length * pushes_[v].direction.stableNormalized();
    }
    // Who stays behind its neighbours would make a dimple.
    const std::vector<Vector3> before = move;
    for (std::size_t v = 0; v < move.size(); ++v) {
      Vector3 mean = Vector3::Zero();
      for (const Index w : neighbours_[v]) mean += before[w] / double(neighbours_[v].size());
      if (before[v].norm() < 0.5 * mean.norm()) move[v] = 0.5 * mean;
    }
    if (request_.mirror) even_moves(*request_.mirror, move);
    if (std::none_of(move.begin(), move.end(),
                     [&](const Vector3& m) { return m.norm() > least_move * tolerance(); }))
      return false;
    std::vector<Index> vertices;
    std::vector<Vector3> positions;
    for (Index v = 0; v < move.size(); ++v) {
      moved_[v] += move[v].norm();
      vertices.push_back(v);
      positions.push_back(input_.polyhedron.position(v) + move[v]);
    }
    auto next = input_.polyhedron.with_positions(vertices, positions);
    if (!next) return false;  // a place that is not finite: the cage stays where it is
    input_.polyhedron = std::move(next).value();
    return true;
  }

  /// Of a vertex and its image the longer way is gone by both.
  static void even_moves(const CageMirror& mirror, std::vector<Vector3>& move) {
    for (Index v = 0; v < move.size(); ++v) {
      const Index w = mirror.image[v];
      if (w == v) move[v] = mirror.evened(move[v], move[v]);
      if (w <= v) continue;
      if (move[v].squaredNorm() < move[w].squaredNorm()) move[v] = mirror.reflected(move[w]);
      move[w] = mirror.reflected(move[v]);
    }
  }

  /// Patches in which the surface turns over: at the cage's vertex it looks away from the faces round that,
  /// in the middle of a face from the face, or somewhere from the blend of its patch's corners. (On faces
  /// that are strongly bent it rightly looks away from the face here and there.)
  std::size_t folds() const {
    const Polyhedron& cage = input_.polyhedron;
    std::vector<Vector3> of_face(mesh().face_count(), Vector3::Zero());
    std::vector<Vector3> of_vertex(mesh().vertex_count(), Vector3::Zero());
    for (Index f = 0; f < mesh().face_count(); ++f) {
      const Vector3& o = cage.position(mesh().origin(mesh().face_begin(f)));
      for (Index h = mesh().face_begin(f); h < mesh().face_end(f); ++h)
        of_face[f] += (cage.position(mesh().origin(h)) - o).cross(cage.position(mesh().target(h)) - o);
      of_face[f] = of_face[f].stableNormalized();
      for (Index h = mesh().face_begin(f); h < mesh().face_end(f); ++h)
        of_vertex[mesh().origin(h)] += of_face[f];
    }
    std::size_t out = 0;
    for (Index f = 0; f < mesh().face_count(); ++f)
      for (Index h = mesh().face_begin(f); h < mesh().face_end(f); ++h)
        out += turns_over(h, of_face[f], of_vertex[mesh().origin(h)], of_vertex[mesh().target(h)]);
    return out;
  }

  /// Of the patch over a half-edge and the middle of its face; what its corners should look at.
  bool turns_over(Index patch, const Vector3& middle, const Vector3& origin, const Vector3& target) const {
    const auto at = [&](int i, int j) -> const Vector3& {
      return normals_[patch * per_patch_ + std::size_t(pattern_.index(i, j))];
    };
    const Vector3 &a = at(0, 0), &b = at(sample_density, 0), &c = at(0, sample_density);
    if (!(a.dot(middle) > 0 && b.dot(origin) > 0 && c.dot(target) > 0)) return true;
    for (int j = 0; j <= sample_density; ++j)
      for (int i = 0; i + j <= sample_density; ++i)
        if (!(at(i, j).dot((sample_density - i - j) * a + i * b + j * c) > 0)) return true;
    return false;
  }

  const CageSurfaceRequest& request_;
  PolyhedronSurfaceInput input_;
  PolyhedronSurfacer surfacer_;
  GridPattern pattern_;
  std::vector<Vector2> parameters_;
  std::vector<std::vector<Index>> neighbours_;
  std::vector<double> moved_;
  double reach_ = largest_push;  ///< of the cell: no vertex moves further
  std::vector<Push> pushes_;
  std::size_t per_patch_ = 0;
  std::vector<Vector3> positions_, normals_;
  std::optional<SampleTree> tree_;  ///< of the positions
};

}  // namespace

Result<CageSurface> cage_surface(const CageSurfaceRequest& request, const CancelToken& cancel) {
  auto cage = Polyhedron::build(request.cage);
  if (!cage) return cage.error();
  return Pusher(request, std::move(cage).value()).run(cancel);
}

}  // namespace hariko
