// The system of mode FAIR: symmetric, positive definite, and its solution the minimum of the energy measured
// patch by patch.

#include "core/patching/fair/fair_system.hpp"

#include <numeric>

#include "core/patching/polyhedron_surface.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/random_shaping.hpp"

namespace hariko::test {
namespace {

FairSystem::Field random_field(std::size_t count, std::mt19937_64& rng) {
  FairSystem::Field field(count);
  for (std::size_t i = 0; i < count; ++i) field[i] = random_vector(rng);
  return field;
}

double dot(const FairSystem::Field& a, const FairSystem::Field& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

TEST(FairSystem, IsSymmetricAndPositiveDefinite) {
  for_random(41, 20, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_polyhedron(rng)).value();
    const auto network =
        NetworkSystem::assemble(polyhedron, random_shaping(polyhedron, rng, 100, 0.01, 100)).value();
    const FairSystem fair(polyhedron.shared_topology(), network,
                          patch_constants(polyhedron.topology(), network.frames()));
    const auto a = random_field(fair.unknown_count(), rng), b = random_field(fair.unknown_count(), rng);
    const auto ma = fair.multiply(a), mb = fair.multiply(b);
    EXPECT_NEAR(dot(a, mb), dot(b, ma), 1e-11 * std::sqrt(dot(a, ma) * dot(b, mb)));
    EXPECT_GT(dot(a, ma), 0);
  });
}

/// The energy of section 6 without the jump term, straight from the control points.
double plate_and_pairs(const FairSystem& fair, const std::vector<QuarticPatch>& patches) {
  double sum = 0;
  for (Index h = 0; h < patches.size(); ++h) {
    using Controls = Eigen::Matrix<double, quartic_control_count, 3, Eigen::RowMajor>;
    const Eigen::Map<const Controls> d(patches[h].control[0].data());
    sum += (d.transpose() * patch_energy(fair.mesh().side_count(fair.mesh().face(h))).plate * d).trace();
    for (const Eigen::Index i : {12, 14, 16}) sum += 10 * (d.row(i) - d.row(i + 1)).squaredNorm();
  }
  return sum;
}

TEST(FairSystem, SolutionMinimisesTheEnergy) {
  // Without the jump term (mu = 0), so that the energy is a sum over patches that this test can add up
  // itself.
  for_random(42, 8, [](std::mt19937_64& rng) {
    const Polyhedron polyhedron = Polyhedron::build(random_polyhedron(rng)).value();
    const HalfEdgeMesh& mesh = polyhedron.topology();
    const auto system = NetworkSystem::assemble(polyhedron, {}).value();
    const auto constants = patch_constants(mesh, system.frames());
    const FairSystem fair(polyhedron.shared_topology(), system, constants, {}, FairWeights{0, 10, 2});
    const auto positions = polyhedron.positions();
    const Network network = system.network(system.solve(positions, {}), positions);
    std::vector<Index> faces(mesh.face_count());
    std::iota(faces.begin(), faces.end(), Index(0));
    PatchNetwork split;
    split.split_tangent.resize(mesh.half_edge_count());
    split.centre.assign(mesh.face_count(), Vector3::Zero());
    split.centre_tangent.assign(mesh.half_edge_count(), Vector3::Zero());
    fill_split_tangents(mesh, system.frames(), constants, positions, network, faces, split);
    const PatchBuilder builder(mesh, constants, positions, network, split);
    std::vector<QuarticPatch> base(mesh.half_edge_count());
    for (Index h = 0; h < base.size(); ++h) base[h] = builder.base_patch(h);
    const auto solution = fair.solve(base, {});
    ASSERT_TRUE(solution.converged);
    const auto energy = [&](const FairSystem::Field& unknowns) {
      fair.fill_split_points(unknowns, faces, split);
      std::vector<QuarticPatch> patches(mesh.half_edge_count());
      for (Index h = 0; h < patches.size(); ++h) patches[h] = builder.base_patch(h);
      fair.add_free_parts(unknowns, faces, patches);
      return plate_and_pairs(fair, patches);
    };
    const double least = energy(solution.unknowns);
    const auto direction = random_field(fair.unknown_count(), rng);
    const auto energy_along = [&](double step) {
      FairSystem::Field moved(fair.unknown_count());
      for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = solution.unknowns[i] + step * direction[i];
      return energy(moved);
    };
    // E(x + s d) = E(x) + s^2 d.M.d exactly, since the gradient vanishes at x.
    const double curvature = dot(direction, fair.multiply(direction));
    for (const double step : {-0.1, 0.1, 1.0})
      EXPECT_NEAR(energy_along(step) - least, step * step * curvature, 1e-8 * (least + curvature)) << step;
  });
}

}  // namespace
}  // namespace hariko::test
