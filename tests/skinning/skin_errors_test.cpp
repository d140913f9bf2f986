// Every error and warning of a skin.

#include <cmath>

#include "core/skinning/evaluate_skin.hpp"
#include "core/skinning/skin_messages.hpp"
#include "tests/skinning/skin_inputs.hpp"

namespace hariko::test {
namespace {

std::string code_of(const Skin& skin) {
  const auto result = evaluate_skin(skin);
  return result.ok() ? "" : std::string(result.error().code.name);
}

std::uint32_t point(const Skin& skin, int section, int i) {
  return skin.sections[std::size_t(section)].points[std::size_t(i)].id;
}

void link(Skin& skin, std::vector<int> a, std::vector<int> b) {
  SkinLink made;
  made.id = skin.free_link_id();
  made.first = skin.sections[0].id, made.second = skin.sections[1].id;
  for (const int i : a) made.a.push_back(point(skin, 0, i));
  for (const int i : b) made.b.push_back(point(skin, 1, i));
  skin.links.push_back(made);
}

void merge(Skin& skin, std::vector<int> members, int target, double v = 0.5) {
  SkinMerge made;
  made.id = skin.free_link_id();
  made.first = skin.sections[0].id, made.second = skin.sections[1].id;
  for (const int i : members) made.members.push_back(point(skin, 0, i));
  made.target = point(skin, 1, target);
  made.v = v;
  skin.merges.push_back(made);
}

TEST(SkinErrors, SectionsAndPath) {
  const Skin good = skin_input("tube");
  EXPECT_EQ(code_of(good), "");
  Skin skin = good;
  skin.sections.resize(1);
  EXPECT_EQ(code_of(skin), "E_FEW_SECTIONS");
  skin = good;
  skin.path.points.resize(1);
  EXPECT_EQ(code_of(skin), "E_PATH_SHORT");
  skin = good;
  skin.path.points.resize(2);
  skin.path.closed = true;
  EXPECT_EQ(code_of(skin), "E_PATH_SHORT");
  skin = good;
  skin.sections[1].v = skin.sections[0].v;
  EXPECT_EQ(code_of(skin), "E_SECTION_ORDER");
  EXPECT_EQ(evaluate_skin(skin).error().text,
            "Sections 1 and 2 are at the same place on the path (or in the wrong order).");
  skin = good;
  skin.sections[2].v = 0.9;
  EXPECT_EQ(code_of(skin), "E_SECTION_RANGE");
  skin = good;
  skin.sections[1].points[2].position.y() = std::nan("");
  EXPECT_EQ(code_of(skin), "E_NOT_FINITE");
  EXPECT_EQ(evaluate_skin(skin).error().element, element_of(VertexId{point(skin, 1, 2)}));
  skin = good;
  skin.path.points[1].x() = INFINITY;
  EXPECT_EQ(code_of(skin), "E_NOT_FINITE");
  skin = good;
  skin.sections[1].v = std::nan("");
  EXPECT_EQ(code_of(skin), "E_NOT_FINITE");
  skin = good;
  skin.sections[1].points.resize(2);
  EXPECT_EQ(code_of(skin), "E_FEW_POINTS");
  skin = good;
  skin.sections[1].points.clear();
  EXPECT_EQ(code_of(skin), "E_FEW_POINTS");
  skin = good;
  skin.sections[1].points.resize(1);
  EXPECT_EQ(code_of(skin), "E_POINT_SECTION");
  skin = good;
  skin.sections[0].points.resize(1);
  EXPECT_EQ(code_of(skin), "") << "a tip at an end";
  skin = good;
  skin.sections[1].closed = false;
  EXPECT_EQ(code_of(skin), "E_OPEN_CLOSED");
  skin = good;
  skin.path.points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 1, 0}};
  EXPECT_EQ(code_of(skin), "E_PATH_CUSP");
  skin = skin_input("ring");
  skin.sections[2].v = 1.2;
  EXPECT_EQ(code_of(skin), "E_SECTION_RANGE");
}

TEST(SkinErrors, RowsAndRails) {
  Skin skin = skin_input("car_default");
  skin.method = SkinMethod::smooth;
  skin.smooth.rows = 5;
  EXPECT_EQ(code_of(skin), "E_FEW_ROWS");
  skin.smooth.rows = 2'000'000;
  skin.smooth.columns = 2'000;
  EXPECT_EQ(code_of(skin), "E_SKIN_SIZE");
  Skin rails = skin_input("tworail");
  EXPECT_EQ(code_of(rails), "");
  rails.sections[1].points.back().position.x() += 0.01;
  EXPECT_EQ(code_of(rails), "E_RAIL");
  rails.second_rail.reset();
  EXPECT_EQ(code_of(rails), "E_RAIL");
}

TEST(SkinErrors, Correspondences) {
  Skin skin = skin_input("fig6a");
  link(skin, {2}, {3});
  link(skin, {4}, {2});
  EXPECT_EQ(code_of(skin), "E_LINK_CROSS");
  EXPECT_EQ(evaluate_skin(skin).error().text, "These correspondences cross: (2-3) and (4-2).");
  skin = skin_input("fig6a");
  merge(skin, {2, 3}, 3);
  merge(skin, {4, 5}, 2);
  EXPECT_EQ(code_of(skin), "E_LINK_CROSS");
  skin = skin_input("fig6a");
  merge(skin, {2, 3}, 2, 1.2);
  EXPECT_EQ(code_of(skin), "E_MERGE_V");
  skin = skin_input("fig6a");
  merge(skin, {2}, 2);
  EXPECT_EQ(code_of(skin), "E_MERGE_SMALL");
  skin = skin_input("fig6a");
  merge(skin, {1, 3}, 2);
  EXPECT_EQ(code_of(skin), "E_MERGE_GAP");
  skin = skin_input("fig6a");
  merge(skin, {2, 3}, 2);
  merge(skin, {3, 4}, 2);
  EXPECT_EQ(code_of(skin), "E_MERGE_OVERLAP");
  skin = skin_input("fig6a");
  merge(skin, {2, 3}, 2);
  merge(skin, {3, 4}, 3);
  EXPECT_EQ(code_of(skin), "") << "two merges may share a point";
  skin = skin_input("tube");
  merge(skin, {0, 1, 2, 3, 4, 5, 6, 7}, 2);
  EXPECT_EQ(code_of(skin), "E_MERGE_ALL");
  skin = skin_input("fig6b");
  skin.sections[0].points.erase(skin.sections[0].points.begin() + 2);
  EXPECT_EQ(code_of(skin), "E_INDEX");
}

TEST(SkinErrors, NameAPointOfWhatIsWrong) {
  const auto element = [](const Skin& skin) {
    const auto result = evaluate_skin(skin);
    EXPECT_FALSE(result.ok());
    return result.ok() ? Element{} : result.error().element;
  };
  const auto at = [](const Skin& skin, int k, int i) { return element_of(VertexId{point(skin, k, i)}); };
  Skin skin = skin_input("tube");
  skin.sections[2].v = skin.sections[1].v;
  EXPECT_EQ(element(skin), at(skin, 2, 0));
  skin = skin_input("tube");
  skin.sections[2].v = 0.9;
  EXPECT_EQ(element(skin), at(skin, 2, 0));
  skin.sections[0].v = 0.1;
  EXPECT_EQ(element(skin), at(skin, 0, 0));
  skin = skin_input("tube");
  skin.sections[1].points.resize(2);
  EXPECT_EQ(element(skin), at(skin, 1, 0));
  skin.sections[1].points.resize(1);
  EXPECT_EQ(element(skin), at(skin, 1, 0));
  skin = skin_input("tube");
  skin.sections[1].closed = false;
  EXPECT_EQ(element(skin), at(skin, 1, 0));
  skin = skin_input("tworail");
  skin.sections[1].points.back().position.x() += 0.01;
  EXPECT_EQ(element(skin), at(skin, 1, 0));
  skin = skin_input("fig6a");
  link(skin, {2}, {3});
  link(skin, {4}, {2});
  EXPECT_EQ(element(skin), at(skin, 0, 2));
  skin = skin_input("fig6a");
  merge(skin, {2, 3}, 2, 1.2);
  EXPECT_EQ(element(skin), at(skin, 0, 2));
  skin = skin_input("fig6a");
  merge(skin, {1, 3}, 2);
  EXPECT_EQ(element(skin), at(skin, 0, 1));
}

TEST(SkinErrors, Warnings) {
  const auto warned = [](const Skin& skin, const char* code) {
    auto made = SkinSurfacer().surface(skin, Vector3::Zero());
    EXPECT_TRUE(made.ok()) << to_string(made.error());
    if (!made) return false;
    return std::any_of(made->result.warnings.begin(), made->result.warnings.end(), [&](const Message& m) {
      return m.code.name == code && m.severity == Severity::warning;
    });
  };
  Skin spacing = skin_input("tube");
  spacing.method = SkinMethod::smooth;
  EXPECT_FALSE(warned(spacing, "W_SPACING"));
  spacing.sections[1].v = 0.15;
  EXPECT_TRUE(warned(spacing, "W_SPACING"));
  Skin collars = skin_input("car_default");
  EXPECT_FALSE(warned(collars, "W_SECTION_NOT_EXACT"));
  collars.pleat.collars = false;
  EXPECT_TRUE(warned(collars, "W_SECTION_NOT_EXACT"));
  Skin fold = skin_input("car_default");
  EXPECT_FALSE(warned(fold, "W_FOLD"));
  // A point pulled back over its neighbours.
  fold.sections[1].points[5].position.y() = -3;
  EXPECT_TRUE(warned(fold, "W_FOLD"));
  Skin twist = skin_input("fig5");
  EXPECT_FALSE(warned(twist, "W_TWIST"));
  for (SectionPoint& p : twist.sections[1].points) p.position.y() *= -12;
  EXPECT_TRUE(warned(twist, "W_TWIST"));
  // The section to be turned round.
  EXPECT_EQ(evaluate_skin(twist)->warnings.back().element, element_of(VertexId{point(twist, 1, 0)}));
}

TEST(SkinErrors, LayoutsThatAreWrong) {
  EXPECT_EQ(read_skin_layout("{").error().code.name, "E_PARSE");
  EXPECT_EQ(read_skin_layout("[]").error().code.name, "E_SCHEMA");
  EXPECT_EQ(read_skin_layout(R"({"path": {"points": []}})").error().code.name, "E_SCHEMA");
  EXPECT_EQ(read_skin_layout(R"({"path": {"points": [[0,0]]}, "sections": []})").error().code.name,
            "E_SCHEMA");
  const std::string two = R"({"path": {"points": [[0,0,0],[1,0,0]]}, "sections": [)"
                          R"({"v": 0, "points": [[0,0,0],[0,1,0]]}, {"v": 1, "points": [[1,0,0],[1,1,0]]}])";
  EXPECT_TRUE(read_skin_layout(two + "}").ok());
  EXPECT_EQ(read_skin_layout(two + R"(, "links": [{"strip": 1, "a": [0], "b": [0]}]})").error().code.name,
            "E_INDEX");
  EXPECT_EQ(read_skin_layout(two + R"(, "links": [{"strip": 0, "a": [0], "b": [2]}]})").error().code.name,
            "E_INDEX");
  EXPECT_EQ(read_skin_layout(two + R"(, "frame": "spiral"})").error().code.name, "E_SCHEMA");
}

}  // namespace
}  // namespace hariko::test
