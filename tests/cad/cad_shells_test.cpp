// Shells of CAD models: volumes, and voids by nesting.

#include "core/cad/cad_shells.hpp"

#include "core/analysis/measures.hpp"
#include "tests/cad/round_boxes.hpp"
#include "tests/support/must.hpp"

namespace hariko::test {
namespace {

std::vector<CadShell> shells_of(const std::vector<RoundBox>& boxes) {
  return cad_shells(*must(make_cad_model(surface_of(boxes), {.exact = true})));
}

/// Sizes of the boxes that shells hollow, by the size of the box, both from their volumes; 0 for none.
std::vector<double> hollowed_sizes(const std::vector<RoundBox>& boxes, double unit_volume) {
  const auto shells = shells_of(boxes);
  const auto size = [&](Index k) { return std::cbrt(std::abs(shells[k].volume) / unit_volume); };
  std::vector<double> out(boxes.size(), -1);
  for (Index k = 0; k < shells.size(); ++k) {
    EXPECT_TRUE(shells[k].closed);
    for (std::size_t b = 0; b < boxes.size(); ++b)
      if (std::abs(size(k) - boxes[b].size) < 1e-9 && (shells[k].volume < 0) == boxes[b].inward)
        out[b] = shells[k].hollows == no_index ? 0 : size(shells[k].hollows);
  }
  return out;
}

double unit_volume() {
  return shells_of({{1}}).at(0).volume;
}

void expect_hollowed(const std::vector<RoundBox>& boxes, const std::vector<double>& wanted) {
  const auto found = hollowed_sizes(boxes, unit_volume());
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t b = 0; b < wanted.size(); ++b) EXPECT_NEAR(found[b], wanted[b], 1e-9) << "box " << b;
}

TEST(CadShells, VolumesAreThoseOfTheSurfaceAndHaveTheSignOfItsSide) {
  const Measures measures = measure(surface_of({{1}}));
  ASSERT_TRUE(measures.volume);
  EXPECT_NEAR(unit_volume(), *measures.volume, 1e-6 * *measures.volume);
  const Vector3 far(1e6, -1e6, 1e6);
  EXPECT_NEAR(shells_of({{2, far}}).at(0).volume, 8 * unit_volume(), 1e-6 * unit_volume());
  EXPECT_NEAR(shells_of({{2, Vector3::Zero(), true}}).at(0).volume, -8 * unit_volume(),
              1e-12 * unit_volume());
}

TEST(CadShells, AShellThatLooksInwardInsideAnotherIsAVoid) {
  for (const double inner : {0.1, 0.5, 0.9, 0.99, 0.9999, 0.999999}) {
    SCOPED_TRACE(inner);
    expect_hollowed({{1}, {inner, Vector3::Zero(), true}}, {0, 1});
    expect_hollowed({{inner, Vector3::Zero(), true}, {1}}, {1, 0});
  }
}

TEST(CadShells, ASurfaceTurnedInsideOutHasTheSameVoids) {
  expect_hollowed({{1, Vector3::Zero(), true}, {0.6}}, {0, 1});
}

TEST(CadShells, NestingAlternates) {
  const Vector3 zero = Vector3::Zero();
  expect_hollowed({{1}, {0.8, zero, true}, {0.6}, {0.4, zero, true}}, {0, 1, 0, 0.6});
  // Two voids side by side, and a solid in one of them.
  expect_hollowed({{4}, {1.1, {2, 0, 0}, true}, {1, {-2, 0, 0}, true}, {0.5, {2, 0, 0}}}, {0, 4, 4, 0});
}

TEST(CadShells, AllOthersStaySolidsOfTheirOwn) {
  const Vector3 zero = Vector3::Zero();
  expect_hollowed({{1}, {0.5}}, {0, 0});                                    // both look outward
  expect_hollowed({{1}, {0.5, {3, 0, 0}, true}}, {0, 0});                   // apart
  expect_hollowed({{1}, {0.5, {0.9, 0, 0}, true}}, {0, 0});                 // intersecting
  expect_hollowed({{1}, {0.8, zero, true}, {0.6, zero, true}}, {0, 1, 0});  // a void has no material
}

TEST(CadShells, OpenSurfacesAreNoVoids) {
  auto patches = patches_of({1});
  auto inner = patches_of({0.5, Vector3::Zero(), true});
  inner.pop_back();
  patches.insert(patches.end(), inner.begin(), inner.end());
  const auto model = must(make_cad_model(weld_patches(Vector3::Zero(), patches).value(), {.exact = true}));
  const auto shells = cad_shells(*model);
  ASSERT_EQ(shells.size(), 2U);
  EXPECT_EQ(int(shells[0].closed) + int(shells[1].closed), 1);
  for (const CadShell& shell : shells) EXPECT_EQ(shell.hollows, no_index);
}

}  // namespace
}  // namespace hariko::test
