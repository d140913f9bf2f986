// Where surfaces and solids cut each other, beside comparing every sample with every point.

#include "core/envelope/violations.hpp"

#include <algorithm>
#include <iostream>
#include <map>

#include "core/envelope/enclosure.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

namespace {

using Place = std::pair<Index, Index>;  ///< face, solid

struct Plain {
  std::map<Place, double> in_solid, outside;
  double worst = 0;
};

void keep_largest(std::map<Place, double>& in, const Place& place, double value) {
  const auto [at, fresh] = in.emplace(place, value);
  if (!fresh) at->second = std::max(at->second, value);
}

Plain compare_everything(const CurveNetwork& network, std::span<const PlacedSolid> solids, double tolerance,
                         const EnvelopeGrid& grid) {
  struct Sample {
    Vector3 position, normal;
    Index face;
  };
  std::vector<Sample> samples;
  std::vector<Vector3> positions(grid.point_count()), normals(grid.point_count());
  for (std::size_t p = 0; p < network.patches.size(); ++p) {
    grid.evaluate(network.patches[p], positions, normals);
    for (std::size_t k = 0; k < positions.size(); ++k)
      samples.push_back({positions[k], normals[k], network.patch_places[p].face});
  }
  Plain out;
  for (Index s = 0; s < solids.size(); ++s) {
    for (const Sample& sample : samples) {
      const double depth = solids[s].depth(sample.position);
      out.worst = std::max(out.worst, depth);
      if (depth > tolerance) keep_largest(out.in_solid, {sample.face, s}, depth);
    }
    for (const Vector3& z : solids[s].test_points) {
      std::vector<std::size_t> order(samples.size());
      for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
      std::partial_sort(order.begin(), order.begin() + 4, order.end(), [&](std::size_t a, std::size_t b) {
        return (samples[a].position - z).squaredNorm() < (samples[b].position - z).squaredNorm();
      });
      double least = 1e300;
      for (std::size_t k = 0; k < 4; ++k)
        least = std::min(least, (z - samples[order[k]].position).dot(samples[order[k]].normal));
      if (!(least > 0)) continue;
      out.worst = std::max(out.worst, least);
      if (least > tolerance) keep_largest(out.outside, {samples[order[0]].face, s}, least);
    }
  }
  return out;
}

}  // namespace

TEST(EnvelopeViolations, AreThoseOfComparingEverything) {
  std::size_t inside = 0, outside = 0;
  for_random(1, 4, [&](std::mt19937_64& rng) {
    EnvelopeInput input = random_scene(rng);
    if (input.solids.size() > 5) input.solids.resize(5);
    EnclosureSettings settings;
    settings.strict = false;
    settings.largest_builds = 1;
    const CurveNetwork network = search_enclosure(place_solids(input), settings).network;
    // Larger than those that the surface was made for.
    input.settings.clearance = uniform(rng, 0, 0.1);
    const std::vector<PlacedSolid> solids = place_solids(input);
    const EnvelopeGrid grid(7);
    const double tolerance = 1e-3;
    const Violations found = find_violations(network, solids, tolerance, grid);
    const Plain plain = compare_everything(network, solids, tolerance, grid);
    EXPECT_GE(found.worst, plain.worst - 1e-12);
    std::map<Place, double> in_solid;
    for (const Violations::InSolid& v : found.in_solid) in_solid[{v.face, v.solid}] = v.depth;
    for (const auto& [place, depth] : plain.in_solid) {
      ASSERT_TRUE(in_solid.contains(place));
      EXPECT_GE(in_solid[place], depth - 1e-12);
    }
    // Of round solids depths between the samples count too.
    for (const auto& [place, depth] : in_solid) {
      if (solids[place.second].is_round()) continue;
      ASSERT_TRUE(plain.in_solid.contains(place));
      EXPECT_NEAR(depth, plain.in_solid.at(place), 1e-12);
    }
    // Of samples that several patches share the face of any may be named; their normals are the same.
    double height = 0;
    for (const Violations::Outside& v : found.outside) height = std::max(height, v.height);
    double plain_height = 0;
    for (const auto& [place, value] : plain.outside) plain_height = std::max(plain_height, value);
    EXPECT_NEAR(height, plain_height, 1e-9);
    inside += found.in_solid.size();
    outside += found.outside.size();
  });
  EXPECT_GT(inside + outside, 0U);
}

TEST(EnvelopeViolations, SummitsOfRoundSolidsBetweenSamplesAreSeen) {
  double errors = 0, errors_of_samples = 0;
  EnclosureSettings settings;
  settings.strict = false;
  const CurveNetwork network = search_enclosure(place_solids(golden_scene("box")), settings).network;
  for_random(1, 20, [&](std::mt19937_64& rng) {
    EnvelopeInput input;
    Solid ball;
    ball.kind = SolidKind::sphere;
    ball.radius = uniform(rng, 0.15, 0.4);
    // Reaches a little through a sample of a fine grid.
    const std::size_t patch = std::size_t(uniform_int(rng, 0, int(network.patches.size()) - 1));
    const EnvelopeGrid fine(80), coarse(20);
    std::vector<Vector3> positions(fine.point_count()), normals(positions.size());
    fine.evaluate(network.patches[patch], positions, normals);
    const auto node = std::size_t(uniform_int(rng, 0, int(positions.size()) - 1));
    ball.position = positions[node] - (ball.radius - log_uniform(rng, 1e-4, 1e-2)) * normals[node];
    input.solids = {ball};
    const std::vector<PlacedSolid> solids = place_solids(input);
    double true_depth = 0, sampled = 0;
    for (const EnvelopePatch& p : network.patches) {
      fine.evaluate(p, positions);
      for (const Vector3& at : positions) true_depth = std::max(true_depth, solids[0].depth(at));
      std::vector<Vector3> few(coarse.point_count());
      coarse.evaluate(p, few);
      for (const Vector3& at : few) sampled = std::max(sampled, solids[0].depth(at));
    }
    double found = 0;
    for (const auto& v : find_violations(network, solids, 1e-9, coarse).in_solid)
      found = std::max(found, v.depth);
    errors += std::abs(true_depth - found);
    errors_of_samples += true_depth - sampled;
  });
  std::cout << "missed by samples " << errors_of_samples << ", by summits between them " << errors << "\n";
  EXPECT_LT(errors, errors_of_samples / 3);
}

}  // namespace hariko::test
