// Parameters round extraordinary vertices of Catmull-Clark surfaces.

#include "core/cad/corner_warp.hpp"

#include <cmath>
#include <numbers>
#include <tuple>

#include "core/base/files/file_io.hpp"
#include "core/cad/cad_measure.hpp"
#include "core/cad/cad_model.hpp"
#include "core/document/format/format.hpp"
#include "core/document/format/read_skin.hpp"
#include "core/skinning/evaluate_skin.hpp"
#include "tests/skinning/skin_inputs.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

TEST(CornerWarp, KeepsSidesAndIsOrdinaryAtValenceFour) {
  EXPECT_NEAR(warp_exponent(4), 1, 1e-15);
  // Subdominant eigenvalues of Catmull-Clark subdivision (Stam 1998).
  EXPECT_NEAR(std::exp(-std::log(2) / warp_exponent(3)), 0.410097, 1e-6);
  EXPECT_NEAR(std::exp(-std::log(2) / warp_exponent(5)), 0.549988, 1e-6);
  for_random(5200, 40, [](std::mt19937_64& rng) {
    const int corner = uniform_int(rng, 0, 3);
    const double exponent = warp_exponent(uniform_int(rng, 3, 20));
    const CornerWarp warp(corner, exponent);
    const double x = uniform(rng);
    const Vector2 origin = corner_parameter(Domain::square, corner),
                  next = corner_parameter(Domain::square, (corner + 1) % 4),
                  opposite = corner_parameter(Domain::square, (corner + 2) % 4);
    EXPECT_EQ(warp.map(origin), origin);
    EXPECT_LT((warp.map(next + x * (opposite - next)) - (next + x * (opposite - next))).norm(), 1e-15);
    EXPECT_LT(
        (warp.map(origin + x * (next - origin)) - (origin + std::pow(x, exponent) * (next - origin))).norm(),
        1e-15);
  });
}

TEST(CornerWarp, DerivativesMatchCentralDifferences) {
  for_random(5201, 40, [](std::mt19937_64& rng) {
    const CornerWarp warp(uniform_int(rng, 0, 3), warp_exponent(uniform_int(rng, 3, 20)));
    const Vector2 at(uniform(rng, 0.1, 0.9), uniform(rng, 0.1, 0.9));
    // The point of the parameters themselves, with a twist.
    const auto point = [&](const Vector2& p) {
      const Vector2 q = warp.map(p);
      PatchPoint out;
      out.position = {q.x(), q.y(), q.x() * q.y()};
      out.ds = {1, 0, q.y()};
      out.dt = {0, 1, q.x()};
      out.dst = {0, 0, 1};
      return warp.pull_back(out, p, Order::second);
    };
    const PatchPoint here = point(at);
    constexpr double step = 1e-5;
    const auto difference = [&](const Vector2& way, auto member) -> Vector3 {
      return (point(at + step * way).*member - point(at - step * way).*member) / (2 * step);
    };
    const Vector2 s(1, 0), t(0, 1);
    EXPECT_LT((here.ds - difference(s, &PatchPoint::position)).norm(), 1e-7);
    EXPECT_LT((here.dt - difference(t, &PatchPoint::position)).norm(), 1e-7);
    EXPECT_LT((here.dss - difference(s, &PatchPoint::ds)).norm(), 1e-6);
    EXPECT_LT((here.dst - difference(t, &PatchPoint::ds)).norm(), 1e-6);
    EXPECT_LT((here.dtt - difference(t, &PatchPoint::dt)).norm(), 1e-6);
  });
}

// Twelve patches meet at the poles of these domes. In their own parameters the fit missed the tolerance by
// nine times, and had 32,523 control points.
TEST(CornerWarp, DomesOverUnequalSectionsKeepTheTolerance) {
  const auto skin = must(read_skin_layout(data_text("dome_unequal_sections.json")));
  const auto made = must(SkinSurfacer().surface(*skin, Vector3::Zero()));
  CadModelOptions options{.tolerance = 0.01};
  options.share = 0;
  const auto model = must(make_cad_model(made->surface, options));
  std::size_t points = 0;
  for (const CadFace& face : model->faces) {
    EXPECT_TRUE(face.reached);
    points += face.surface.points.size();
  }
  EXPECT_LT(points, 20000U);
  EXPECT_LE(measure_cad(made->surface, *model).largest, 0.01);
}

// Four patches meet in a vertex of its border. Without a warp there, faces missed 0.05 mm by seven times.
TEST(CornerWarp, MergedRidgesKeepTheToleranceAtTheirBorder) {
  const auto text =
      must(read_file(source_folder() + "/assets/samples/skin_merge_end.hariko", std::size_t(1) << 24));
  const auto document = must(read_document(*text));
  const auto made = must(SkinSurfacer().surface(*document->objects[0]->skin()->skin, Vector3::Zero()));
  for (const auto& [distance, angle, most] : {std::tuple(0.05, 0.2, 1500), std::tuple(0.01, 0.1, 3000)}) {
    SCOPED_TRACE(distance);
    CadModelOptions options;
    options.tolerance = distance;
    options.share = 0;
    options.angle = angle * std::numbers::pi / 180;
    const auto model = must(make_cad_model(made->surface, options));
    const CadMeasure measured = measure_cad(made->surface, *model);
    EXPECT_LE(measured.largest, distance);
    EXPECT_LE(measured.normal_jump, options.angle);
    EXPECT_LT(measured.control_points, std::size_t(most));
  }
}

}  // namespace
}  // namespace hariko::test
