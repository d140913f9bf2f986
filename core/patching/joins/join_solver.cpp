// JoinPlan::solve: one lambda for each joined side, and the conditions and points that follow from it
// (kuriyama.md section 8).

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/base/solvers/small_solver.hpp"
#include "core/patching/joins/join_frame.hpp"
#include "core/patching/joins/join_plan.hpp"

namespace hariko {

namespace {

/// Least lambda, relative to the natural one; smaller values are raised to it.
constexpr double smallest_share = 0.125;

}  // namespace

/// End of a G1 join. The split tangent of its corner is rest + gain * other, where `other` is the basis
/// vector beside the side's own, or the split tangent itself at a half-turn corner.
struct JoinPlan::End {
  JoinFrame frame;
  Index vertex = no_index;
  Index corner = no_index;  ///< half-edge at the corner
  Index other = no_index;   ///< basis vector; no_index at a half-turn corner
  double gain = 1;
  Vector3 rest = Vector3::Zero();
  bool known = false;  ///< `other` is the tangent of another joined side
  std::size_t group = 0;

  /// Component along `across` of a vector of the tangent plane, in the basis (across, along).
  double across_part(const Vector3& y) const {
    return y.cross(frame.along).dot(frame.normal) / frame.across.cross(frame.along).dot(frame.normal);
  }
};

class JoinPlan::Solver {
 public:
  Solver(const JoinPlan& plan, const VertexFrames& frames, const PatchConstants& constants,
         std::span<const Vector3> basis)
      : plan_(plan), mesh_(plan.polyhedron_->topology()), frames_(frames), constants_(constants) {
    collect_ends(basis);
  }

  Result<Solution> solve() {
    find_lambdas();
    if (failure_) return *failure_;
    for (Group& group : groups_) adjust(group);
    finish();
    return std::move(out_);
  }

 private:
  /// Vector that one or two ends depend on.
  struct Group {
    std::vector<std::size_t> ends;
    Vector3 value = Vector3::Zero();
    bool known = false;
    bool linked = false;  ///< both ends depend on the same component of it
  };

  void collect_ends(std::span<const Vector3> basis);
  End make_end(std::size_t join, bool at_origin, std::span<const Vector3> basis);
  void find_lambdas();
  /// Finds the lambdas of the chain of sides linked with this one, up to a common factor, and then that
  /// factor.
  void follow_chain(std::size_t join);
  double estimate(std::size_t end) const;
  double natural(const End& end) const;
  void adjust(Group& group);
  void finish();
  Vector3 split_tangent(const End& end) const { return end.rest + end.gain * groups_[end.group].value; }
  double lambda_of(std::size_t end) const { return -ends_[end].across_part(split_tangent(ends_[end])); }
  void refuse(Index v, const std::string& why) {
    if (failure_) return;
    failure_ = make_error(e_join_twist, why,
                          "Let the patch adapt to the surface, or join one of the edges by position only.",
                          element_of(plan_.polyhedron_->vertex_id(v)));
  }
  bool smooth(std::size_t join) const { return plan_.joins_[join].continuity != Continuity::g0; }

  const JoinPlan& plan_;
  const HalfEdgeMesh& mesh_;
  const VertexFrames& frames_;
  const PatchConstants& constants_;
  /// End 2 j: at the origin of join j; end 2 j + 1: at its target. Those of G0 joins are unused.
  std::vector<End> ends_;
  std::vector<Group> groups_;
  std::map<Index, Vector3> own_;         ///< basis vectors that are tangents of sides
  std::vector<double> weight_, lambda_;  ///< per join
  std::set<std::size_t> guessed_;        ///< joins whose lambda was raised
  std::optional<Message> failure_;
  Solution out_;
};

std::vector<BasisCondition> JoinPlan::first_conditions(const VertexFrames& frames) const {
  const HalfEdgeMesh& mesh = polyhedron_->topology();
  std::map<Index, BasisCondition> out;
  const auto ends = [&](std::size_t j, bool at_origin) {
    const Index h = joins_[j].half_edge;
    return at_origin ? std::pair{2 * h, 2 * mesh.previous(h) + 1} : std::pair{2 * h + 1, 2 * mesh.next(h)};
  };
  for (std::size_t j = 0; j < joins_.size(); ++j)
    for (const bool at_origin : {true, false}) {
      const TangentCoefficients& own = frames.ends[ends(j, at_origin).first];
      const Index v = at_origin ? mesh.origin(joins_[j].half_edge) : mesh.target(joins_[j].half_edge);
      out[own.basis[0]] = {v, own.basis[0], BasisCondition::Kind::fixed,
                           join_frame(joins_[j], at_origin).tangent / own.c[0]};
    }
  for (std::size_t j = 0; j < joins_.size(); ++j)
    for (const bool at_origin : {true, false}) {
      if (joins_[j].continuity == Continuity::g0) continue;
      const Index v = at_origin ? mesh.origin(joins_[j].half_edge) : mesh.target(joins_[j].half_edge);
      for (const Index basis : frames.ends[ends(j, at_origin).second].basis)
        if (basis != no_index)
          out.try_emplace(basis, BasisCondition{v, basis, BasisCondition::Kind::plane,
                                                join_frame(joins_[j], at_origin).normal});
    }
  std::vector<BasisCondition> list;
  for (const auto& [basis, condition] : out) list.push_back(condition);
  return list;
}

Result<JoinPlan::Solution> JoinPlan::solve(const VertexFrames& frames, const PatchConstants& constants,
                                           std::span<const Vector3> basis) const {
  return Solver(*this, frames, constants, basis).solve();
}

JoinPlan::End JoinPlan::Solver::make_end(std::size_t join, bool at_origin, std::span<const Vector3> basis) {
  const Index h = plan_.joins_[join].half_edge;
  End end;
  end.frame = join_frame(plan_.joins_[join], at_origin);
  end.vertex = at_origin ? mesh_.origin(h) : mesh_.target(h);
  end.corner = at_origin ? h : mesh_.next(h);
  const TangentCoefficients& own = frames_.ends[2 * h + (at_origin ? 0 : 1)];
  const TangentCoefficients& beside = frames_.ends[at_origin ? 2 * mesh_.previous(h) + 1 : 2 * mesh_.next(h)];
  Group group;
  if (constants_.free_split[end.corner]) {
    Vector3 mean = Vector3::Zero();
    for (const Index v : mesh_.face_vertices(mesh_.face(h))) mean += plan_.polyhedron_->position(v);
    mean /= double(mesh_.side_count(mesh_.face(h)));
    group.value = (mean - plan_.polyhedron_->position(end.vertex)) / 3;
    group.value -= end.frame.normal * end.frame.normal.dot(group.value);
  } else {
    // The side's own edge opens the corner at its origin and closes the corner at its target.
    const auto [first, second] = frames_.split_factors(mesh_, end.corner);
    const double by_own = at_origin ? first : second, by_beside = at_origin ? second : first;
    end.rest = by_own * end.frame.tangent;
    for (int i = 0; i < 2; ++i) {
      if (beside.basis[i] == no_index) continue;
      if (beside.basis[i] == own.basis[0]) {
        end.rest += by_beside * beside.c[i] * own_.at(own.basis[0]);
      } else {
        end.other = beside.basis[i];
        end.gain = by_beside * beside.c[i];
      }
    }
    const auto known = own_.find(end.other);
    end.known = group.known = known != own_.end();
    group.value = end.known ? known->second : basis[end.other];
  }
  // Another end may depend on the same vector.
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const End& first = ends_[groups_[g].ends.front()];
    const bool same = end.other == no_index ? first.other == no_index && first.corner == end.corner
                                            : first.other == end.other;
    if (same) {
      end.group = g;
      return end;
    }
  }
  end.group = groups_.size();
  groups_.push_back(std::move(group));
  return end;
}

void JoinPlan::Solver::collect_ends(std::span<const Vector3> basis) {
  const std::size_t count = plan_.joins_.size();
  for (std::size_t j = 0; j < count; ++j)
    for (const bool at_origin : {true, false}) {
      const TangentCoefficients& own = frames_.ends[2 * plan_.joins_[j].half_edge + (at_origin ? 0 : 1)];
      own_[own.basis[0]] = join_frame(plan_.joins_[j], at_origin).tangent / own.c[0];
    }
  ends_.resize(2 * count);
  for (std::size_t j = 0; j < count; ++j)
    for (const bool at_origin : {true, false}) {
      if (!smooth(j)) continue;
      const std::size_t e = 2 * j + (at_origin ? 0 : 1);
      ends_[e] = make_end(j, at_origin, basis);
      groups_[ends_[e].group].ends.push_back(e);
    }
  for (Group& group : groups_) {
    if (group.ends.size() < 2 || group.known) continue;
    const Vector3 &a = ends_[group.ends[0]].frame.along, &b = ends_[group.ends[1]].frame.along;
    group.linked = a.cross(b).norm() <= 1e-8 * a.norm() * b.norm();
  }
}

double JoinPlan::Solver::natural(const End& end) const {
  const Index f = mesh_.face(end.corner);
  Vector3 mean = Vector3::Zero();
  for (const Index v : mesh_.face_vertices(f)) mean += plan_.polyhedron_->position(v);
  mean /= double(mesh_.side_count(f));
  return (mean - plan_.polyhedron_->position(end.vertex)).norm() / (3 * end.frame.across.norm());
}

double JoinPlan::Solver::estimate(std::size_t end) const {
  return std::max(lambda_of(end), smallest_share * natural(ends_[end]));
}

void JoinPlan::Solver::find_lambdas() {
  const std::size_t count = plan_.joins_.size();
  weight_.assign(count, 0.0);
  lambda_.assign(count, 1.0);
  for (std::size_t j = 0; j < count && !failure_; ++j)
    if (smooth(j) && weight_[j] == 0) follow_chain(j);
}

void JoinPlan::Solver::follow_chain(std::size_t first) {
  std::vector<std::size_t> chain{first};
  weight_[first] = 1;
  for (std::size_t k = 0; k < chain.size(); ++k)
    for (const std::size_t e : {2 * chain[k], 2 * chain[k] + 1}) {
      const Group& group = groups_[ends_[e].group];
      if (!group.linked) continue;
      const std::size_t other = group.ends[0] == e ? group.ends[1] : group.ends[0];
      // Direction into the face, in the plane; both lambdas are proportional to the vector's component along
      // it.
      const Vector3 inward = ends_[e].frame.normal.cross(ends_[e].frame.along);
      const double ratio = (ends_[other].gain * ends_[other].across_part(inward)) /
                           (ends_[e].gain * ends_[e].across_part(inward));
      const double weight = weight_[chain[k]] * ratio;
      const std::size_t join = other / 2;
      if (weight_[join] == 0) {
        weight_[join] = weight;
        chain.push_back(join);
      } else if (std::abs(weight - weight_[join]) > join_tolerance * std::abs(weight)) {
        refuse(ends_[e].vertex,
               "Round the joined edges the patches ask for different speeds across them; vertex " +
                   plan_.name(ends_[e].vertex) + " is where they disagree.");
      }
    }
  // An end between two given sides determines its lambda.
  std::optional<double> given;
  double logarithms = 0;
  std::size_t free_ends = 0;
  for (const std::size_t join : chain)
    for (const std::size_t e : {2 * join, 2 * join + 1}) {
      if (!ends_[e].known) {
        logarithms += std::log(estimate(e) / weight_[join]);
        ++free_ends;
        continue;
      }
      const double lambda = lambda_of(e);
      if (!(lambda > 0)) {
        refuse(ends_[e].vertex, "At vertex " + plan_.name(ends_[e].vertex) +
                                    " the joined patch lies on the side where the surface should be.");
        continue;
      }
      if (given && std::abs(lambda / weight_[join] - *given) > join_tolerance * *given)
        refuse(ends_[e].vertex, "The patch joined at vertex " + plan_.name(ends_[e].vertex) +
                                    " leaves its side at a speed that does not fit the other end.");
      if (!given) given = lambda / weight_[join];
    }
  const double scale = given ? *given : std::exp(logarithms / double(free_ends));
  for (const std::size_t join : chain) {
    lambda_[join] = scale * weight_[join];
    for (const std::size_t e : {2 * join, 2 * join + 1})
      if (!ends_[e].known && estimate(e) > lambda_of(e)) guessed_.insert(join);
  }
}

void JoinPlan::Solver::adjust(Group& group) {
  if (group.known) return;
  const auto excess = [&](std::size_t e) { return (lambda_of(e) - lambda_[e / 2]) / ends_[e].gain; };
  const End& first = ends_[group.ends[0]];
  if (group.ends.size() == 1) {
    group.value += excess(group.ends[0]) * first.frame.across;
    return;
  }
  const End& second = ends_[group.ends[1]];
  if (group.linked) {
    group.value +=
        (excess(group.ends[0]) * first.frame.across + excess(group.ends[1]) * second.frame.across) / 2;
    return;
  }
  // Two conditions on a vector of the plane.
  const Vector3 x = first.frame.along.normalized(), y = first.frame.normal.cross(x);
  Eigen::Matrix2d matrix;
  matrix << first.across_part(x), first.across_part(y), second.across_part(x), second.across_part(y);
  const Vector2 change = solve_general(matrix, Vector2(excess(group.ends[0]), excess(group.ends[1])));
  group.value += change.x() * x + change.y() * y;
}

void JoinPlan::Solver::finish() {
  out_.conditions = plan_.first_conditions(frames_);
  for (BasisCondition& condition : out_.conditions) {
    if (condition.kind == BasisCondition::Kind::fixed) continue;
    for (const Group& group : groups_)
      if (ends_[group.ends.front()].other == condition.basis) {
        condition.kind = BasisCondition::Kind::fixed;
        condition.vector = group.value;
      }
  }
  out_.coefficients.resize(plan_.joins_.size());
  for (const Group& group : groups_)
    if (const End& end = ends_[group.ends.front()]; end.other == no_index)
      out_.geometry.splits.push_back({end.corner, group.value});
  for (std::size_t j = 0; j < plan_.joins_.size(); ++j) {
    if (!smooth(j)) continue;
    JoinCoefficients& out = out_.coefficients[j];
    out.lambda = (lambda_of(2 * j) + lambda_of(2 * j + 1)) / 2;
    const auto along = [&](std::size_t e) {
      const JoinFrame& frame = ends_[e].frame;
      return -(split_tangent(ends_[e]) + out.lambda * frame.across).dot(frame.along) /
             frame.along.squaredNorm();
    };
    out.l1 = along(2 * j);
    // The triangle's row i = 3 begins at D013, one step back along the curve.
    out.l2 = along(2 * j + 1) - 1;
    const auto& p = plan_.joins_[j].curve;
    const auto& q = plan_.joins_[j].row;
    const Vector3 d0 = p[1] - p[0], d1 = p[2] - p[1], d2 = p[3] - p[2];
    const Vector3 d031 = (p[0] + 3 * p[1]) / 4, d022 = (p[1] + p[2]) / 2;
    out_.geometry.sides.push_back(
        {plan_.joins_[j].half_edge,
         d031 - (3 * out.lambda * (q[1] - p[1]) + out.l2 * d0 + 2 * out.l1 * d1) / 4,
         d022 - (3 * out.lambda * (q[2] - p[2]) + out.l1 * d2 + 2 * out.l2 * d1) / 4});
  }
  for (const std::size_t j : guessed_) {
    const EdgeId edge = plan_.polyhedron_->edge_id(mesh_.edge(plan_.joins_[j].half_edge));
    out_.warnings.push_back(make_warning(
        w_join_scale,
        "The patch joined to edge " + to_string(edge) +
            " leads away from the face, so how fast the surface leaves the edge is a guess.",
        "Turn the patch towards the face's middle, or move the vertices of the face.", element_of(edge)));
  }
}

}  // namespace hariko
