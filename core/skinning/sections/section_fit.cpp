#include "core/skinning/sections/section_fit.hpp"

#include "core/base/assert.hpp"
#include "core/base/solvers/sparse_solver.hpp"

namespace hariko {

namespace {

/// Vertex as an affine function of the unknowns.
struct Affine {
  std::vector<std::pair<int, double>> terms;
  Vector3 constant = Vector3::Zero();

  void add(const Affine& other, double factor) {
    for (const auto& [k, weight] : other.terms) {
      bool found = false;
      for (auto& [own, sum] : terms)
        if (own == k) sum += factor * weight, found = true;
      if (!found) terms.emplace_back(k, factor * weight);
    }
    constant += factor * other.constant;
  }
};

class FairSystem {
 public:
  FairSystem(const std::vector<Vector3>& positions, const std::vector<SectionEquation>& equations,
             const std::vector<char>& held)
      : vertices_(positions.size()) {
    std::vector<char> solved(positions.size(), 0);
    for (const SectionEquation& e : equations) solved[e.vertex] = 1;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      if (solved[v]) continue;
      if (held[v])
        vertices_[v].constant = positions[v];
      else
        vertices_[v].terms.emplace_back(unknowns_++, 1.0);
    }
    for (const SectionEquation& e : equations) {
      HARIKO_ASSERT(!solved[e.before] && !solved[e.after], "sections have rows of their own between them");
      Affine& v = vertices_[e.vertex];
      v.constant = 1.5 * e.target;
      v.add(vertices_[e.before], -0.25);
      v.add(vertices_[e.after], -0.25);
    }
    right_ = Eigen::MatrixXd::Zero(unknowns_, 3);
  }

  const Affine& vertex(std::size_t v) const { return vertices_[v]; }

  /// Adds weight |f|^2 to the objective.
  void add(const Affine& f, double weight) {
    for (const auto& [i, a] : f.terms) {
      right_.row(i) -= weight * a * f.constant.transpose();
      for (const auto& [j, b] : f.terms)
        if (j <= i) triplets_.emplace_back(i, j, weight * a * b);
    }
  }

  void solve(std::vector<Vector3>& positions) const {
    Eigen::MatrixXd x(unknowns_, 3);
    // Between rails, for sections with no points but their ends, nothing is unknown.
    if (unknowns_ > 0) {
      const SparseCholesky factor(sparse_matrix(unknowns_, unknowns_, triplets_));
      HARIKO_ASSERT(factor.succeeded(), "tension makes the system definite");
      x = factor.solve(right_);
    }
    for (std::size_t v = 0; v < positions.size(); ++v) {
      Vector3 p = vertices_[v].constant;
      for (const auto& [k, weight] : vertices_[v].terms) p += weight * x.row(k).transpose();
      positions[v] = p;
    }
  }

 private:
  int unknowns_ = 0;
  std::vector<Affine> vertices_;
  SparseEntries triplets_;
  Eigen::MatrixXd right_;
};

}  // namespace

Vector3 second_difference(const LineBend& bend, const std::vector<Vector3>& positions) {
  const double h1 = bend.before_distance, h2 = bend.after_distance, h = (h1 + h2) / 2;
  Vector3 out = -(1 / h1 + 1 / h2) / h * positions[bend.vertex];
  for (const Index v : bend.after) out += positions[v] / (h2 * h * double(bend.after.size()));
  for (const Index v : bend.before) out += positions[v] / (h1 * h * double(bend.before.size()));
  return out;
}

void fit_sections_locally(std::vector<Vector3>& positions, const std::vector<SectionEquation>& equations) {
  for (const SectionEquation& e : equations)
    positions[e.vertex] = (6 * e.target - positions[e.before] - positions[e.after]) / 4;
}

void fit_sections_fairly(std::vector<Vector3>& positions, const std::vector<SectionEquation>& equations,
                         const std::vector<LineBend>& bends, const std::vector<char>& held, double tension) {
  FairSystem system(positions, equations, held);
  for (const LineBend& bend : bends) {
    const double h1 = bend.before_distance, h2 = bend.after_distance, h = (h1 + h2) / 2;
    Affine moved = system.vertex(bend.vertex);
    moved.constant -= positions[bend.vertex];
    system.add(moved, h * tension);
    // Second difference V'' = 2 ((V+ - V) / h2 - (V - V-) / h1) / (h1 + h2).
    Affine second;
    for (const Index v : bend.after) second.add(system.vertex(v), 1 / (h2 * h * double(bend.after.size())));
    for (const Index v : bend.before) second.add(system.vertex(v), 1 / (h1 * h * double(bend.before.size())));
    second.add(system.vertex(bend.vertex), -(1 / h1 + 1 / h2) / h);
    second.constant -= bend.own;
    system.add(second, h);
  }
  system.solve(positions);
}

}  // namespace hariko
