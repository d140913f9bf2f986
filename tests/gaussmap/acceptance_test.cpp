// The tables of gaussmap.md 6 and 8: control points against surfaces that are known exactly.

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "core/gaussmap/control_points.hpp"
#include "core/geometry/rotation.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// A number of the tables is met at up to 1.25 times its value; those below 1e-9 at 1e-9.
double allowed(double number) {
  return std::max(1.25 * number, 1e-9);
}

/// Numbers of a run, on the standard output when HARIKO_SHOW_NUMBERS is set: docs/gaussmap.md has them.
void show(const std::string& line) {
  if (std::getenv("HARIKO_SHOW_NUMBERS")) std::cout << line << std::endl;
}

ControlPoints made(const GroundTruth& truth, const GaussOptions& options) {
  auto result = control_points(truth.outline, options);
  EXPECT_TRUE(result.ok()) << truth.name << ": " << (result.ok() ? "" : result.error().text);
  return result.ok() ? *std::move(result) : ControlPoints{};
}

std::string text(const char* mode, const GroundTruth& truth, const ControlPoints& points,
                 const PointErrors& errors) {
  std::ostringstream out;
  out << std::scientific << std::setprecision(1) << mode << " | " << truth.name << " | "
      << points.boundary_count << " / " << points.points.size() - points.boundary_count << " | d "
      << errors.distance << " | ang " << errors.degrees << " | dh " << errors.support << " | dK "
      << errors.curvature << " | gap " << points.gap << " | " << points.iterations << " iterations";
  return out.str();
}

std::size_t inner_count(const ControlPoints& points) {
  return points.points.size() - points.boundary_count;
}

TEST(GaussMapAcceptance, EqualEmptyCirclesComeInAnyOrder) {  // 6.2
  // The sites of a circle are all alike, so that rounding alone decides between equal empty circles: with 16
  // points the table has 44 sites inside, we have 36, and either comes out when normals move by 1e-12.
  const GroundTruth truth = sphere_cap(16);
  GaussOptions options = in_mode(GaussMode::umbilic);
  options.relaxation = 0;
  std::mt19937_64 rng(random_seed(9403));
  std::size_t least = SIZE_MAX, most = 0;
  for (int run = 0; run < 60; ++run) {
    Outline moved = truth.outline;
    for (std::size_t i = 0; i < 16; ++i) {
      Vector3& normal = moved.loops[0].normals[i];
      normal = (normal + random_vector(rng, 1e-12)).normalized();
      moved.loops[0].points[i] = 2 * normal;
    }
    const auto points = must(control_points(moved, options));
    least = std::min(least, inner_count(*points));
    most = std::max(most, inner_count(*points));
  }
  show("sites inside a circle of 16 | " + std::to_string(least) + " to " + std::to_string(most));
  EXPECT_GE(least, 33u);
  EXPECT_LE(least, 36u);
  EXPECT_GE(most, 39u);
  EXPECT_LE(most, 46u);
}

TEST(GaussMapAcceptance, BoundaryDataOnly) {  // 6.3
  struct Row {
    GroundTruth truth;
    double umbilic, curvature;
  };
  const std::vector<Row> rows = {{ellipsoid_cap(32), .20, .067},
                                 {paraboloid_cap(32), .10, .042},
                                 {three_holes({1.3, 1.1, .9}, 14, "ellipsoid three holes"), .16, .036},
                                 {sphere_cap(32), 2.9e-6, 3e-6}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.truth.name);
    for (const auto& [name, mode, number] : {std::tuple{"umbilic", GaussMode::umbilic, row.umbilic},
                                             {"curvature", GaussMode::curvature, row.curvature}}) {
      GaussOptions options = in_mode(mode);
      const ControlPoints points = made(row.truth, options);
      const PointErrors errors = point_errors(points, row.truth.truth);
      show(text(name, row.truth, points, errors));
      EXPECT_LE(errors.distance, allowed(number)) << name;
    }
  }
}

TEST(GaussMapAcceptance, SpheresAreExactInTheLinearModes) {
  const std::vector<std::pair<GroundTruth, double>> rows = {
      {sphere_cap(16), 1.5e-4},  {sphere_cap(32), 2.9e-6},
      {sphere_cap(64), 5.7e-8},  {sphere_band(16), 5.2e-5},
      {sphere_band(32), 1.9e-6}, {three_holes(Vector3::Ones(), 16, "three holes"), 3.4e-6}};
  for (const auto& [truth, number] : rows) {
    SCOPED_TRACE(truth.name + " " + std::to_string(truth.outline.point_count()));
    GaussOptions options = in_mode(GaussMode::umbilic);
    const ControlPoints points = made(truth, options);
    const PointErrors errors = point_errors(points, truth.truth);
    show(text("umbilic", truth, points, errors));
    EXPECT_LE(errors.distance, allowed(number));
    EXPECT_LE(errors.support, 1e-12);
    EXPECT_TRUE(points.messages.empty());
  }
}

TEST(GaussMapAcceptance, LinearModesAreStableUnderRefinement) {  // 6.3
  for (const auto& [count, number] : {std::pair{16u, .043}, {32u, .067}, {48u, .066}}) {
    const GroundTruth truth = ellipsoid_cap(count);
    GaussOptions options;
    const ControlPoints points = made(truth, options);
    const PointErrors errors = point_errors(points, truth.truth);
    show(text("curvature", truth, points, errors));
    EXPECT_LE(errors.distance, allowed(.067));
    // Few sites need not lie where the error is largest, so the number holds where they were inserted.
    options.relaxation = 0;
    EXPECT_LE(point_errors(made(truth, options), truth.truth).distance, allowed(number));
  }
  for (const unsigned count : {16u, 32u, 64u}) {
    const GroundTruth truth = ellipsoid_cap(count);
    GaussOptions options = in_mode(GaussMode::umbilic);
    const PointErrors errors = point_errors(made(truth, options), truth.truth);
    EXPECT_NEAR(errors.distance, .20, .05);
  }
}

GroundTruth golden_catenoid() {
  return {"catenoid", golden_outline("catenoid"), catenoid()};
}

TEST(GaussMapAcceptance, NegativeCurvature) {  // 8
  struct Row {
    GroundTruth truth;
    double inner, umbilic, curvature;
  };
  for (const Row& row : {Row{catenoid_strip(13, 15), 117, 1.3e-2, 1.6e-2},
                         {golden_catenoid(), 500, 2.8e-3, 7.6e-3},
                         {saddle_disc(16), 32, 7.1e-3, 1.3e-2},
                         {saddle_disc(32), 143, 2.0e-3, 4.0e-3},
                         {saddle_disc(48), 337, 1.4e-3, HUGE_VAL}}) {
    SCOPED_TRACE(row.truth.name);
    for (const auto& [name, mode, number] : {std::tuple{"umbilic", GaussMode::umbilic, row.umbilic},
                                             {"curvature", GaussMode::curvature, row.curvature}}) {
      GaussOptions options = in_mode(mode);
      const ControlPoints points = made(row.truth, options);
      const PointErrors errors = point_errors(points, row.truth.truth);
      show(text(name, row.truth, points, errors));
      EXPECT_NEAR(double(inner_count(points)), row.inner, std::max(2.0, 0.05 * row.inner));
      EXPECT_LE(errors.distance, allowed(number)) << name;
    }
  }
}

TEST(GaussMapAcceptance, ThePaperDoesNotConverge) {  // 6.1
  struct Row {
    GroundTruth truth;
    std::array<double, 4> distance, degrees;  ///< at 10, 30, 60, 120 inserted points
  };
  const std::vector<Row> rows = {{sphere_cap(32), {.21, .21, .21, .21}, {5.9, 7.0, 7.0, 7.3}},
                                 {ellipsoid_cap(32), {.73, .73, .73, .73}, {25, 30, 32, 33}},
                                 {paraboloid_cap(32), {.35, .35, .35, .35}, {22, 30, 30, 32}},
                                 {sphere_band(20), {.047, .047, .047, .047}, {3.7, 3.9, 4.7, 4.8}}};
  const std::array<Index, 4> counts{10, 30, 60, 120};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.truth.name);
    GaussOptions options = in_mode(GaussMode::paper);
    options.radius = 0.05;
    // Planes are never revisited, so the first points are those of a shorter run.
    options.most_points = counts.back();
    const ControlPoints points = made(row.truth, options);
    for (std::size_t k = 0; k < counts.size(); ++k) {
      const PointErrors errors = point_errors(points, row.truth.truth, counts[k]);
      show(text("paper", row.truth, points, errors) + " | of " + std::to_string(counts[k]) + " | clamped " +
           std::to_string(points.clamped_count));
      EXPECT_NEAR(errors.distance, row.distance[k], 0.3 * row.distance[k]) << counts[k];
      EXPECT_NEAR(errors.degrees, row.degrees[k], 0.3 * row.degrees[k]) << counts[k];
    }
  }
}

/// Gaussian noise on each component of the normals.
Outline with_noise(Outline outline, double degrees, std::mt19937_64& rng) {
  for (OutlineLoop& loop : outline.loops)
    for (Vector3& normal : loop.normals)
      for (int c = 0; c < 3; ++c) {
        const double radius = std::sqrt(-2 * std::log(1 - uniform(rng))), turn = 2 * pi * uniform(rng);
        normal[c] += degrees * pi / 180 * radius * std::cos(turn);
      }
  return outline;
}

/// A refusal for what noise does to normals, that names a point.
void expect_refused_for_noise(const Message& error, const Outline& outline) {
  const std::array<Code, 4> codes{e_normal_tangent, e_not_convex, e_coarse_normals, e_image_crosses};
  EXPECT_TRUE(std::find(codes.begin(), codes.end(), error.code) != codes.end()) << to_string(error);
  ASSERT_EQ(error.element.kind, Element::Kind::vertex);
  const std::string point = to_string(outline, outline_point(outline, Index(error.element.id)));
  EXPECT_NE(error.text.find(point), std::string::npos) << error.text;
}

TEST(GaussMapAcceptance, NoisyNormals) {  // 7
  const std::array<double, 6> degrees{0, .1, .5, 1, 2, 5};
  struct Row {
    const char* name;
    GaussMode mode;
    std::array<double, 6> distance;
  };
  const Row rows[] = {{"umbilic", GaussMode::umbilic, {3e-6, 3e-4, 3e-3, 4e-3, 2e-2, 7e-2}},
                      {"curvature", GaussMode::curvature, {3e-6, 1.5e-3, 1.4e-2, 7e-2, .22, .48}}};
  const GroundTruth truth = sphere_cap(32);
  for (const Row& row : rows)
    for (std::size_t k = 0; k < degrees.size(); ++k) {
      SCOPED_TRACE(row.name + std::string(" ") + std::to_string(degrees[k]));
      std::mt19937_64 rng(random_seed(9401));
      std::vector<double> found;
      int refused = 0;
      // The table is of one run, and runs differ by a factor of 4: its numbers are met by some of them, and
      // their median is not far off.
      const bool differ = degrees[k] > 0 && degrees[k] < 5;
      const int runs = differ ? 32 : 1;
      for (int run = 0; run < runs; ++run) {
        const Outline noisy = with_noise(truth.outline, degrees[k], rng);
        GaussOptions options = in_mode(row.mode);
        const auto result = control_points(noisy, options);
        if (result.ok()) {
          found.push_back(point_errors(*result, truth.truth).distance);
          continue;
        }
        ++refused;
        expect_refused_for_noise(result.error(), noisy);
      }
      std::sort(found.begin(), found.end());
      std::ostringstream line;
      line << "noise " << degrees[k] << " degrees | " << row.name << " | " << refused << " of " << runs
           << " refused";
      if (!found.empty())
        line << " | d least " << found.front() << ", median " << found[found.size() / 2] << ", largest "
             << found.back();
      show(line.str());
      if (degrees[k] < 2) {
        EXPECT_EQ(refused, 0);
      }
      if (!found.empty()) {
        EXPECT_LE(found.front(), allowed(row.distance[k]));
        EXPECT_LE(found[found.size() / 2], 2.25 * row.distance[k]);
      }
    }
}

TEST(GaussMapAcceptance, StopsAtTheGap) {  // 3.5
  const GroundTruth truth = ellipsoid_cap(32);
  GaussOptions options;
  options.radius = 2.5;
  const ControlPoints coarse = made(truth, options);
  options.gap = 0.03;
  ASSERT_GT(coarse.gap, *options.gap);
  const ControlPoints fine = made(truth, options);
  show(text("gap", truth, fine, point_errors(fine, truth.truth)));
  EXPECT_LE(fine.gap, *options.gap);
  EXPECT_TRUE(fine.messages.empty());
  EXPECT_GT(inner_count(fine), inner_count(coarse));
  // Along the outline the gap is that of its own steps.
  options.gap = 0.001;
  const ControlPoints limited = made(truth, options);
  EXPECT_GT(limited.gap, *options.gap);
  ASSERT_FALSE(limited.messages.empty());
  EXPECT_EQ(limited.messages.back().code, w_gap);
}

TEST(GaussMapAcceptance, IsTheSameAnywhereAndAtAnySize) {
  for_random(9402, 4, [](std::mt19937_64& rng) {
    // A loop without any symmetry, so that no two empty circles are equally large.
    const Truth surface = ellipsoid({2, 1.5, 1});
    GroundTruth truth{"wavy cap", {{OutlineLoop()}}, surface};
    for (int i = 0; i < 28; ++i) {
      const double t = 2 * pi * i / 28,
                   polar = 1 + 0.1 * std::cos(3 * t + 0.3) + 0.07 * std::sin(2 * t + 0.1);
      const Vector3 n(std::sin(polar) * std::cos(t), std::sin(polar) * std::sin(t), std::cos(polar));
      truth.outline.loops[0].normals.push_back(n);
      truth.outline.loops[0].points.push_back(surface.point_of_normal(n));
      truth.outline.loops[0].curvature.push_back(surface.curvature_of_normal(n));
    }
    const double scale = std::exp(uniform(rng, -9, 9));
    const Vector3 shift = random_vector(rng, 10 * scale);
    const Eigen::Quaterniond turn = least_rotation(random_vector(rng), random_vector(rng));
    Outline moved = truth.outline;
    for (OutlineLoop& loop : moved.loops)
      for (std::size_t i = 0; i < loop.points.size(); ++i) {
        loop.points[i] = scale * (turn * loop.points[i]) + shift;
        loop.normals[i] = turn * loop.normals[i];
        loop.curvature[i] /= scale * scale;
      }
    for (const GaussMode mode : {GaussMode::umbilic, GaussMode::curvature}) {
      GaussOptions options = in_mode(mode);
      options.most_points = 12;  // later circles may be as large as each other up to rounding
      const auto here = control_points(truth.outline, options), there = control_points(moved, options);
      ASSERT_TRUE(here.ok() && there.ok());
      ASSERT_EQ(here->points.size(), there->points.size());
      double largest = 0;
      for (std::size_t i = here->boundary_count; i < here->points.size(); ++i) {
        double nearest = HUGE_VAL;
        for (const Vector3& point : there->points)
          nearest = std::min(nearest, (scale * (turn * here->points[i]) + shift - point).norm() / scale);
        largest = std::max(largest, nearest);
      }
      EXPECT_LE(largest, 1e-9);
    }
  });
}

TEST(GaussMapAcceptance, PowersOfTwoChangeNoBit) {
  const GroundTruth truth = ellipsoid_cap(24);
  Outline larger = truth.outline;
  for (Vector3& point : larger.loops[0].points) point *= 1024;
  for (double& curvature : larger.loops[0].curvature) curvature /= 1024.0 * 1024.0;
  const auto here = must(control_points(truth.outline, {})), there = must(control_points(larger, {}));
  ASSERT_EQ(here->points.size(), there->points.size());
  EXPECT_EQ(here->triangles, there->triangles);
  for (std::size_t i = 0; i < here->points.size(); ++i)
    EXPECT_EQ(Vector3(1024 * here->points[i]), there->points[i]);
}

TEST(GaussMapAcceptance, TheSaddleKeepsItsOutlineAndItsSides) {
  // Its loops are reversed on the way in, and put back.
  const GroundTruth truth = saddle_disc(32);
  GaussOptions options = in_mode(GaussMode::umbilic);
  const ControlPoints points = made(truth, options);
  for (Index i = 0; i < points.boundary_count; ++i) {
    EXPECT_EQ(points.points[i].x() > 0, truth.outline.loops[0].points[i].x() > 0);
    EXPECT_LE((points.points[i] - truth.outline.loops[0].points[i]).norm(), 1e-14);
    EXPECT_LE((points.normals[i] - truth.outline.loops[0].normals[i]).norm(), 1e-15);
  }
  for (const auto& [a, b, c] : points.triangles) {
    const Vector3 normal = (points.points[b] - points.points[a]).cross(points.points[c] - points.points[a]);
    EXPECT_GT(normal.dot(points.normals[a] + points.normals[b] + points.normals[c]), 0);
  }
}

}  // namespace
}  // namespace hariko::test
