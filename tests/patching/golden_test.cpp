// Every reference file, to the digits printed in it.

#include "tests/support/golden.hpp"

#include "core/patching/quartic/quartic_patch.hpp"

namespace hariko::test {
namespace {

/// The files print 12 significant digits of numbers of order one.
constexpr double printed = 2e-11;

Vector3 vector_of(const nlohmann::json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

class Golden : public testing::TestWithParam<GoldenCase> {};

TEST_P(Golden, EveryNumber) {
  const GoldenCase& c = GetParam();
  const nlohmann::json json = golden_json(c.stem + ".json");
  PolyhedronSurfacer surfacer;
  const auto input = golden_input(c.obj, golden_mode(json["mode"]), c.tension);
  const auto result = surfacer.rebuild(input);
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  const HalfEdgeMesh& mesh = input.polyhedron.topology();
  const auto& set = dynamic_cast<const QuarticPatchSet&>(result->surface.patches());

  EXPECT_NEAR(result->network->energy, json["energy"].get<double>(), 1e-12);
  for (const auto& [key, value] : json["tangents"].items()) {
    const std::size_t dash = key.find('-');
    const Index a = static_cast<Index>(std::stoul(key.substr(0, dash)));
    const Index b = static_cast<Index>(std::stoul(key.substr(dash + 1)));
    const Index h = mesh.find_half_edge(a, b);
    const Vector3 tangent =
        h != no_index ? result->network->start[h] : result->network->end[mesh.find_half_edge(b, a)];
    EXPECT_LT((tangent - vector_of(value)).norm(), printed) << "tangent " << key;
  }
  for (std::size_t f = 0; f < json["faces"].size(); ++f) {
    const auto& face = json["faces"][f];
    const Index first = mesh.face_begin(static_cast<Index>(f));
    for (Index j = 0; j < mesh.side_count(static_cast<Index>(f)); ++j) {
      const auto& d = set.patch(first + j).control;
      EXPECT_LT((d[quartic::d400] - vector_of(face["O"])).norm(), printed);
      EXPECT_LT((4 * (d[quartic::d310] - d[quartic::d400]) / 3 - vector_of(face["Y"][j])).norm(),
                2 * printed);
      EXPECT_LT((4 * (d[quartic::d130] - d[quartic::d040]) / 3 - vector_of(face["split_tangents"][j])).norm(),
                2 * printed);
    }
  }
  ASSERT_EQ(json["patches"].size(), set.patch_count());
  for (const auto& patch : json["patches"]) {
    const Index h = mesh.face_begin(patch["face"].get<Index>()) + patch["side"].get<Index>();
    for (std::size_t i = 0; i < quartic_control_count; ++i)
      EXPECT_LT((set.patch(h).control[i] - vector_of(patch["D"][i])).norm(), printed)
          << "patch " << h << " point " << quartic::control_names[i];
    for (std::size_t i = 0; i < json["sample_uvw"].size(); ++i) {
      const Vector3 uvw = vector_of(json["sample_uvw"][i]);
      const Vector2 parameter(uvw.y(), uvw.z());
      const PatchPoint point = set.evaluate(h, parameter, Order::first);
      EXPECT_LT((point.position - vector_of(patch["points"][i])).norm(), printed);
      EXPECT_LT((result->surface.normal(h, parameter) - vector_of(patch["normals"][i])).norm(), 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Golden, testing::ValuesIn(golden_cases()),
                         [](const auto& test) { return test.param.stem; });

}  // namespace
}  // namespace hariko::test
