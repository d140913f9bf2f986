// Solutions of mode FAIR's system by sweeps over its faces: exact to rounding among all faces or some, on any
// number of threads, in few steps.

#include "core/base/parallel.hpp"
#include "core/patching/fair/fair_system.hpp"
#include "core/patching/fair/influence_region.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/random_shaping.hpp"

namespace hariko::test {
namespace {

/// Solutions for known right-hand sides: patches at zero, and forces on z of all edges.
class Forced {
 public:
  Forced(const Polyhedron& polyhedron, const Shaping& shaping, Frames frames, std::mt19937_64& rng)
      : polyhedron_(polyhedron),
        network_(NetworkSystem::assemble(polyhedron, shaping, {frames}).value()),
        constants_(patch_constants(polyhedron.topology(), network_.frames())),
        system_(polyhedron.shared_topology(), network_, constants_),
        numbering_(polyhedron.shared_topology(), constants_, {}),
        base_(polyhedron.topology().half_edge_count()) {
    for (QuarticPatch& patch : base_) patch.control.fill(Vector3::Zero());
    const HalfEdgeMesh& mesh = polyhedron.topology();
    for (Index h = 0; h < mesh.half_edge_count(); ++h)
      if (!constants_.smooth[h] || mesh.half_edge_of_edge(mesh.edge(h)) == h)
        forces_.push_back({h, random_vector(rng), random_vector(rng)});
  }

  FairSystem::Solution solve(const std::vector<Index>* faces = nullptr) const {
    FairSystem::SolveOptions options;
    options.active_faces = faces;
    options.rims = forces_;
    return system_.solve(base_, options);
  }

  /// Forces less the matrix times the solution, where z is free between active faces and inside of them.
  double residual(const FairSystem::Field& solution, const std::vector<bool>& active) const {
    FairSystem::Field left = system_.multiply(solution);
    for (const BoundaryCurvatureLoad& force : forces_) {
      left[numbering_.side_origin[force.half_edge]] -= force.at_origin;
      left[numbering_.side_target[force.half_edge]] -= force.at_target;
    }
    const HalfEdgeMesh& mesh = polyhedron_.topology();
    double largest = 0;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      if (!active[f]) continue;
      for (std::size_t i = 0; i < 3 + 2 * std::size_t(mesh.side_count(f)); ++i)
        largest = std::max(largest, left[numbering_.face_begin[f] + i].norm());
      for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
        if (constants_.smooth[h] && !active[mesh.face(mesh.twin(h))]) continue;
        largest = std::max(largest, left[numbering_.side_origin[h]].norm());
        largest = std::max(largest, left[numbering_.side_target[h]].norm());
      }
    }
    return largest;
  }

 private:
  const Polyhedron& polyhedron_;
  NetworkSystem network_;
  PatchConstants constants_;
  FairSystem system_;
  FairNumbering numbering_;
  std::vector<QuarticPatch> base_;
  std::vector<BoundaryCurvatureLoad> forces_;
};

TEST(FairSweeps, SolveToTheLastDigits) {
  for_random(43, 20, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_polyhedron(rng)).value();
    const Shaping shaping = random_shaping(polyhedron, rng, 100, 0.01, 100);
    for (const Frames frames : {Frames::equal, Frames::metric}) {
      const Forced forced(polyhedron, shaping, frames, rng);
      const auto solution = forced.solve();
      EXPECT_TRUE(solution.converged);
      EXPECT_LT(forced.residual(solution.unknowns, std::vector<bool>(polyhedron.face_count(), true)), 1e-9);
    }
  });
}

TEST(FairSweeps, SolveAmongSomeFaces) {
  for_random(44, 10, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(torus(14, 11)).value();
    const Forced forced(polyhedron, {}, Frames::metric, rng);
    const auto near = neighbourhood(polyhedron.topology(), {Index(uniform_int(rng, 0, 100))}, 3);
    ASSERT_LT(near.faces.size(), polyhedron.face_count());
    const auto solution = forced.solve(&near.faces);
    EXPECT_TRUE(solution.converged);
    std::vector<bool> active(polyhedron.face_count(), false);
    for (const Index f : near.faces) active[f] = true;
    EXPECT_LT(forced.residual(solution.unknowns, active), 1e-10);
    for (std::size_t i = 0; i < solution.unknowns.size(); ++i) EXPECT_TRUE(solution.unknowns[i].allFinite());
  });
}

TEST(FairSweeps, FacesMayShareSeveralSides) {
  PolygonMesh mesh = cube();
  // A vertex of two edges between the lower and the front face.
  mesh.positions.emplace_back(0.1, -1.05, -1.1);
  PolygonMesh split;
  split.positions = mesh.positions;
  split.add_face({0, 3, 2, 1, 8});
  split.add_face({4, 5, 6, 7});
  split.add_face({0, 8, 1, 5, 4});
  split.add_face({1, 2, 6, 5});
  split.add_face({2, 3, 7, 6});
  split.add_face({3, 0, 4, 7});
  const Polyhedron polyhedron = Polyhedron::build(split).value();
  std::mt19937_64 rng(45);
  for (const Frames frames : {Frames::equal, Frames::metric}) {
    const Forced forced(polyhedron, {}, frames, rng);
    const auto solution = forced.solve();
    EXPECT_TRUE(solution.converged);
    EXPECT_LE(solution.iterations, 25);
    EXPECT_LT(forced.residual(solution.unknowns, std::vector<bool>(6, true)), 1e-10);
  }
}

TEST(FairSweeps, TakeFewStepsWithTheSameBitsOnAnyNumberOfThreads) {
  std::mt19937_64 rng(46);
  const Polyhedron polyhedron = Polyhedron::build(torus(24, 12)).value();
  const Forced forced(polyhedron, {}, Frames::metric, rng);
  const auto solution = forced.solve();
  EXPECT_LE(solution.iterations, 20);
  const ParallelLimit serial(1);
  const auto alone = forced.solve();
  ASSERT_EQ(alone.unknowns.size(), solution.unknowns.size());
  for (std::size_t i = 0; i < alone.unknowns.size(); ++i) ASSERT_EQ(alone.unknowns[i], solution.unknowns[i]);
}

}  // namespace
}  // namespace hariko::test
