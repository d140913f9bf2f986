// Files of Bezier patches by hand: each layout opens as one object a name, is meshed as one surface, taken
// apart into patches that can be edited, put together, saved and opened again.

#include <iomanip>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

/// Points of two bicubic patches that share a row, one a line.
std::vector<std::string> points_of_a_sheet(const char* between) {
  std::vector<std::string> out;
  for (int x = 0; x < 7; ++x)
    for (int y = 0; y < 4; ++y) {
      std::ostringstream line;
      line << std::setprecision(17) << x << between << y << between << 0.3 * (x - 3) * (x - 3) / 9 + 0.2 * y
           << '\n';
      out.push_back(line.str());
    }
  return out;
}

/// The points of each patch behind its degrees.
std::string plain_sheet() {
  const std::vector<std::string> points = points_of_a_sheet(" ");
  std::string out = "2\n";
  for (const int first : {0, 12}) {
    out += "3 3\n";
    out = std::accumulate(points.begin() + first, points.begin() + first + 16, out);
  }
  return out;
}

/// The numbers of the points of each patch, then all points.
std::string indexed_sheet() {
  std::string out = "2\n";
  for (const int first : {1, 13})
    for (int i = 0; i < 16; ++i) out += std::to_string(first + i) + (i < 15 ? "," : "\n");
  out += "28\n";
  const std::vector<std::string> points = points_of_a_sheet(",");
  return std::accumulate(points.begin(), points.end(), out);
}

/// A quarter of a cylinder, exact, and a plane of degree 4 by 1 at its side.
constexpr const char* rational_sheet = R"({"arc": [
  {"ctrl": [[[1,0,0],[1,0,2]],[[1,1,0],[1,1,2]],[[0,1,0],[0,1,2]]],
   "weights": [[1,1],[0.70710678118654752,0.70710678118654752],[1,1]]},
  {"ctrl": [[[1,0,0],[1,0,2]],[[1,-0.5,0],[1,-0.5,2]],[[1,-1,0],[1,-1,2]],[[1,-1.5,0],[1,-1.5,2]],
   [[1,-2,0],[1,-2,2]]]}]})";

class PatchesWork : public ::testing::Test, protected ProgramHands {
 protected:
  void open_text(const char* name, const std::string& text) {
    spill(folder() / name, text);
    open_again(name);
  }
  void open_again(const char* name) {
    session().open(folder() / name);
    wait();
  }
  std::size_t objects() { return editor().document().objects.size(); }
  bool shows(const std::string& mark) { return marks().contains(mark); }
  /// Triangles that the panel for meshes counts, opened and closed again; 0 where it has none.
  std::size_t facets() {
    press({"Ctrl+Alt+T"});
    wait();
    const auto result = editor().meshing.result;
    click("meshing.close");
    wait();
    return result && !result->error ? result->mesh.facets : 0;
  }
};

TEST_F(PatchesWork, BothTextsAreOneSurfaceThatIsTakenApartPutTogetherAndSaved) {
  open_text("sheet.bpt", plain_sheet());
  ASSERT_EQ(objects(), 1U) << notice();
  EXPECT_TRUE(shows("patches.count"));
  const std::size_t plain = facets();
  EXPECT_GT(plain, 0U);
  open_text("indexed.bpt", indexed_sheet());
  ASSERT_EQ(objects(), 1U) << notice();
  EXPECT_EQ(facets(), plain);

  press({"4"});
  frames(2);
  click("button.separate_patches");
  wait();
  expect_step(1, "Separate patches");
  EXPECT_EQ(objects(), 2U);
  press({"Ctrl+Z"});
  EXPECT_EQ(objects(), 1U);
  press({"Ctrl+Shift+Z"});
  EXPECT_EQ(objects(), 2U);
  wait();
  press({"Ctrl+A"});
  bench().from_palette("weld patches", "shape.weld_patches");
  wait();
  expect_step(2, "Weld patches");
  EXPECT_EQ(objects(), 1U);
  EXPECT_EQ(facets(), plain) << "welded";

  press({"Ctrl+Shift+S"});
  name_file("sheet.hariko");
  wait();
  EXPECT_FALSE(editor().history.dirty()) << notice();
  open_again("sheet.bpt");
  open_again("sheet.hariko");
  EXPECT_EQ(objects(), 1U);
  EXPECT_EQ(facets(), plain) << "opened again";
}

TEST_F(PatchesWork, WeightsAndOtherDegreesAreMeshedAndAnotherFileComesInBesideThem) {
  open_text("arc.json", rational_sheet);
  ASSERT_EQ(objects(), 1U) << notice();
  EXPECT_TRUE(shows("patches.weights"));
  EXPECT_GT(facets(), 10U);
  spill(folder() / "sheet.bpt", plain_sheet());
  press({"Ctrl+I"});
  name_file("sheet.bpt");
  wait();
  EXPECT_EQ(objects(), 2U) << notice();
}

TEST_F(PatchesWork, EachNameIsAnObject) {
  open_copy("tests/golden/approximation/surfaces.json");
  std::set<std::string> names;
  for (const auto& object : editor().document().objects) names.insert(object->name);
  EXPECT_EQ(objects(), 8U) << notice();
  EXPECT_EQ(names.size(), 8U);
  for (const char* name : {"dome", "saddle", "wave"}) EXPECT_TRUE(names.contains(name)) << name;
}

}  // namespace
}  // namespace hariko::test
