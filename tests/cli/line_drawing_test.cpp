// Line drawings by `hariko render`.

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include "tests/cli/program.hpp"

namespace hariko::test {
namespace {

class LineDrawings : public ProgramTest {
 protected:
  /// The drawing of a model of tests/golden.
  std::string drawing(const std::string& model, const std::string& options) {
    const Outcome result = succeed("render " + golden(model) + " " + path("a.svg") + " " + options);
    EXPECT_EQ(result.error, "");
    return read_text(path("a.svg"));
  }
};

std::set<std::string> layers(const std::string& svg) {
  std::set<std::string> out;
  const std::string begin = "<g id=\"";
  for (std::size_t at = svg.find(begin); at != std::string::npos; at = svg.find(begin, at + 1)) {
    const std::size_t name = at + begin.size();
    out.insert(svg.substr(name, svg.find('"', name) - name));
  }
  return out;
}

/// The coordinates of the points of all paths within a layer: least and greatest x, least and greatest y.
std::array<double, 4> extent(const std::string& svg, const std::string& layer) {
  std::array<double, 4> out{1e9, -1e9, 1e9, -1e9};
  const std::size_t begin = svg.find("<g id=\"" + layer + "\"");
  const std::string text =
      begin == std::string::npos ? "" : svg.substr(begin, svg.find("</g>", begin) - begin);
  for (std::size_t at = text.find("d=\""); at != std::string::npos; at = text.find("d=\"", at + 1)) {
    std::string path = text.substr(at + 3, text.find('"', at + 3) - at - 3);
    for (char& c : path)
      if (c == 'M' || c == 'L' || c == 'Z') c = ' ';
    std::istringstream numbers(path);
    for (double x = 0, y = 0; numbers >> x >> y;)
      out = {std::min(out[0], x), std::max(out[1], x), std::min(out[2], y), std::max(out[3], y)};
  }
  return out;
}

TEST_F(LineDrawings, ShowTheWholeModelInLayers) {
  const std::string svg = drawing("fig2.obj", "");
  EXPECT_NE(svg.find("width=\"1280px\" height=\"960px\" viewBox=\"0 0 1280 960\""), std::string::npos);
  EXPECT_EQ(layers(svg), (std::set<std::string>{"silhouette", "network"}));
  // Framed as pictures are: the box round the model fills the page but for 8 %.
  const auto [left, right, top, bottom] = extent(svg, "silhouette");
  EXPECT_GT(left, 40);
  EXPECT_LT(right, 1240);
  EXPECT_GT(top, 30);
  EXPECT_LT(bottom, 930);
  EXPECT_GT(std::max((right - left) / 1280, (bottom - top) / 960), 0.4);
}

TEST_F(LineDrawings, OptionsSayWhichLines) {
  EXPECT_EQ(layers(drawing("fig2.obj", "--lines silhouette")), std::set<std::string>{"silhouette"});
  EXPECT_EQ(layers(drawing("grid3.obj", "--lines border,network --view top")),
            (std::set<std::string>{"border", "network"}));
  // It bends outwards everywhere: nothing hides its outline.
  EXPECT_EQ(layers(drawing("fig2.obj", "--hidden")),
            (std::set<std::string>{"silhouette", "network", "network-hidden"}));
  // The half that is kept is widest where it is cut.
  EXPECT_EQ(layers(drawing("fig2.obj", "--section y=0 --lines section,silhouette --view back")),
            std::set<std::string>{"section"});
  EXPECT_EQ(drawing("fig2.obj", "--hidden"), drawing("fig2.obj", "--hidden")) << "not the same twice";
}

TEST_F(LineDrawings, PagesOfMillimetresHaveTheSameLines) {
  const std::string pixels = drawing("fig2.obj", "--size 960x480 --lines silhouette");
  const std::string page = drawing("fig2.obj", "--size 200x100mm --lines silhouette");
  EXPECT_NE(page.find("width=\"200mm\" height=\"100mm\" viewBox=\"0 0 200 100\""), std::string::npos);
  EXPECT_NE(page.find("stroke-width=\"0.5\""), std::string::npos);
  const auto a = extent(pixels, "silhouette"), b = extent(page, "silhouette");
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(b[k] * 4.8, a[k], 0.2) << k;
}

TEST_F(LineDrawings, WhatMakesNoSenseIsRefused) {
  const std::string model = golden("fig2.obj");
  for (const char* wrong :
       {"a.svg --map zebra", "a.svg --show network", "a.svg --background light", "a.svg --wire mesh",
        "a.svg --lines outline", "a.svg --size 5x5mm", "a.svg --size 200x5000mm", "a.svg --size 200xmm",
        "a.png --lines silhouette", "a.png --hidden", "a.png --size 200x100mm", "a.pdf"}) {
    const Outcome result = run("render " + model + " " + path(wrong));
    EXPECT_EQ(result.exit_code, 2) << wrong << ": " << result.error;
  }
  EXPECT_FALSE(std::filesystem::exists(path("a.svg")));
  write_text(path("old.svg"), "old");
  const Outcome nothing = run("render " + model + " " + path("old.svg") + " --lines section");
  EXPECT_EQ(nothing.exit_code, 1);
  EXPECT_NE(nothing.error.find("E_DRAWING_EMPTY"), std::string::npos) << nothing.error;
  EXPECT_EQ(read_text(path("old.svg")), "old");
  EXPECT_EQ(run("render " + model + " " + path("no/such/folder/a.svg")).exit_code, 1);
}

}  // namespace
}  // namespace hariko::test
