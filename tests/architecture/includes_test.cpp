// The arrows between the folders, checked on every #include line: app -> ui -> render -> core, those inside
// of core, which are listed here and nowhere else, and inside of ui shell -> workspaces -> view -> widgets ->
// editor -> base. docs/architecture.md has a figure of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/places.hpp"

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// Folders of core that each folder of core may include.
const std::map<std::string, Names>& core_arrows() {
  static const std::map<std::string, Names> arrows = {
      {"base", {"base"}},
      {"geometry", {"geometry", "base"}},
      {"polyhedron", {"polyhedron", "geometry", "base"}},
      {"surface", {"surface", "geometry", "base"}},
      {"subdivision", {"subdivision", "polyhedron", "surface", "geometry", "base"}},
      {"skinning", {"skinning", "subdivision", "polyhedron", "surface", "geometry", "base"}},
      {"network", {"network", "polyhedron", "geometry", "base"}},
      {"g2", {"g2", "network", "polyhedron", "surface", "geometry", "base"}},
      {"patching", {"patching", "g2", "network", "polyhedron", "surface", "geometry", "base"}},
      {"envelope", {"envelope", "patching", "network", "polyhedron", "surface", "geometry", "base"}},
      {"gaussmap",
       {"gaussmap", "analysis", "patching", "network", "polyhedron", "surface", "geometry", "base"}},
      {"document",
       {"document", "skinning", "subdivision", "envelope", "gaussmap", "patching", "network", "polyhedron",
        "surface", "geometry", "base"}},
      {"modeling",
       {"modeling", "document", "approximation", "analysis", "skinning", "subdivision", "envelope",
        "gaussmap", "patching", "network", "polyhedron", "surface", "geometry", "base"}},
      {"analysis", {"analysis", "patching", "network", "polyhedron", "surface", "geometry", "base"}},
      {"approximation", {"approximation", "surface", "geometry", "base"}},
      {"offset", {"offset", "analysis", "surface", "geometry", "base"}},
      {"cad", {"cad", "polyhedron", "surface", "geometry", "base"}},
      {"exchange",
       {"exchange", "subdivision", "patching", "network", "polyhedron", "surface", "geometry", "base"}},
      {"drawing", {"drawing", "exchange", "surface", "geometry", "base"}},
      {"unfolding",
       {"unfolding", "document", "exchange", "patching", "network", "polyhedron", "surface", "geometry",
        "base"}},
  };
  return arrows;
}

/// The level of a folder of ui; it may include those of lower levels. The workspaces, all of one level, do
/// not include each other.
const std::map<std::string, int>& ui_levels() {
  constexpr int workspace = 4;
  static const std::map<std::string, int> levels = {
      {"base", 0},
      {"editor", 1},
      {"widgets", 2},
      {"view", 3},
      {"polyhedron", workspace},
      {"solids", workspace},
      {"skin", workspace},
      {"outline", workspace},
      {"paper", workspace},
      {"pictures", workspace},
      {"measure", workspace},
      {"analysis", workspace},
      {"files", workspace},
      {"shell", workspace + 1},
  };
  return levels;
}

/// Path beginnings that a layer must not include. Windows and GL belong to the outer layers, ImGui to ui and
/// app.
const std::map<std::string, std::vector<std::string>>& forbidden_beginnings() {
  static const std::map<std::string, std::vector<std::string>> forbidden = {
      {"core",
       {"render/", "ui/", "app/", "tests/", "bench/", "imgui", "GLFW/", "epoxy/", "GL/", "GLES", "EGL/",
        "glm/"}},
      {"render", {"ui/", "app/", "tests/", "bench/", "imgui"}},
      {"ui", {"app/", "tests/", "bench/"}},
      {"app", {"tests/", "bench/"}},
  };
  return forbidden;
}

bool begins_with_any(const std::string& target, const std::vector<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& b) { return target.starts_with(b); });
}

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> out;
  for (const fs::path& part : fs::path(path)) out.push_back(part.string());
  return out;
}

std::optional<std::string> core_violation(const std::string& file, const std::string& target) {
  const std::vector<std::string> from = parts_of(file), to = parts_of(target);
  if (from[0] != "core" || from.size() < 3) return {};
  const auto arrows = core_arrows().find(from[1]);
  if (arrows == core_arrows().end()) return "core/" + from[1] + " is not in the table of arrows of this test";
  if (to[0] != "core" || to.size() < 3 || arrows->second.contains(to[1])) return {};
  return "core/" + from[1] + " must not include core/" + to[1];
}

std::optional<std::string> ui_violation(const std::string& file, const std::string& target) {
  const std::vector<std::string> from = parts_of(file), to = parts_of(target);
  if (from[0] != "ui") return {};
  if (from.size() < 3) return "ui holds folders only";
  const auto level = ui_levels().find(from[1]);
  if (level == ui_levels().end()) return "ui/" + from[1] + " is not in the table of levels of this test";
  if (to[0] != "ui" || to.size() < 3 || from[1] == to[1]) return {};
  const auto other = ui_levels().find(to[1]);
  if (other != ui_levels().end() && other->second < level->second) return {};
  return "ui/" + from[1] + " must not include ui/" + to[1];
}

/// Reason why `file` (relative to the top) must not include `target`; none when it may.
std::optional<std::string> violation(const std::string& file, const std::string& target) {
  const std::string layer = parts_of(file)[0];
  const auto forbidden = forbidden_beginnings().find(layer);
  if (forbidden != forbidden_beginnings().end() && begins_with_any(target, forbidden->second))
    return layer + " must not include " + target;
  if (target.starts_with("Eigen/Sparse") && target != "Eigen/SparseCore" &&
      file != "core/base/solvers/sparse_solver.cpp")
    return "core/base/solvers/sparse_solver.cpp is the only door to Eigen's sparse factorisations";
  if (fs::path(file).extension() == ".hpp" &&
      begins_with_any(target, {"nlohmann/json.hpp", "CLI/", "tbb/", "oneapi/"}))
    return target + " is kept out of headers: it slows every build down";
  if (target.ends_with(".hxx") && !file.starts_with("core/cad/kernel/opencascade/"))
    return "core/cad/kernel/opencascade is the only folder that knows OpenCASCADE";
  if (target.starts_with("CLI/") && !file.starts_with("app/commands/command_line/"))
    return "app/commands/command_line is the only folder that knows CLI11";
  if (begins_with_any(target, {"tbb/", "oneapi/"}) && file != "core/base/parallel.cpp")
    return "core/base/parallel.cpp is the only door to the thread library";
  if (target.starts_with("GLFW/") && (file.starts_with("ui/") || file.starts_with("tests/")) &&
      file != "ui/base/system_information.cpp")
    return "app/window is the door to GLFW: keys are told by `Key` (only the version is named elsewhere)";
  if (auto why = ui_violation(file, target)) return why;
  return core_violation(file, target);
}

struct Include {
  std::string file;  ///< relative to the top
  int line;
  std::string target;
  bool quoted;
};

/// The target of an #include line and whether it is in quotes; none for any other line.
std::optional<std::pair<std::string, bool>> include_target(const std::string& line) {
  static const std::string blank = " \t";
  std::size_t at = line.find_first_not_of(blank);
  if (at == std::string::npos || line[at] != '#') return {};
  at = line.find_first_not_of(blank, at + 1);
  if (at == std::string::npos || line.compare(at, 7, "include") != 0) return {};
  at = line.find_first_of("<\"", at + 7);
  if (at == std::string::npos) return {};
  const bool quoted = line[at] == '"';
  const std::size_t end = line.find(quoted ? '"' : '>', at + 1);
  if (end == std::string::npos) return {};
  return std::pair{line.substr(at + 1, end - at - 1), quoted};
}

std::vector<Include> includes_of(const fs::path& top, const fs::path& file) {
  std::vector<Include> out;
  std::ifstream stream(file);
  std::string text;
  for (int line = 1; std::getline(stream, text); ++line)
    if (const auto target = include_target(text))
      out.push_back({fs::relative(file, top).generic_string(), line, target->first, target->second});
  return out;
}

std::vector<Include> all_includes() {
  const fs::path top = hariko::test::source_folder();
  std::vector<Include> out;
  for (const char* layer : {"core", "render", "ui", "app"}) {
    if (!fs::exists(top / layer)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(top / layer)) {
      const fs::path extension = entry.path().extension();
      if (extension != ".hpp" && extension != ".cpp") continue;
      const std::vector<Include> found = includes_of(top, entry.path());
      out.insert(out.end(), found.begin(), found.end());
    }
  }
  return out;
}

TEST(Includes, NoArrowPointsBack) {
  const std::vector<Include> includes = all_includes();
  EXPECT_GT(includes.size(), 50U) << "the sources were not found";
  for (const Include& include : includes) {
    const auto why = violation(include.file, include.target);
    EXPECT_FALSE(why) << include.file << ":" << include.line << ": " << *why;
  }
}

TEST(Includes, OwnHeadersAreNamedFromTheTop) {
  for (const Include& include : all_includes()) {
    if (!include.quoted) continue;
    const std::string layer = parts_of(include.target)[0];
    EXPECT_TRUE((Names{"core", "render", "ui", "app"}).contains(layer))
        << include.file << ":" << include.line
        << ": quotes are for headers of this project, "
           "named from its top folder";
  }
}

TEST(Includes, HeadersAreIncludedOnce) {
  const fs::path top = hariko::test::source_folder();
  for (const char* layer : {"core", "render", "ui", "app"}) {
    if (!fs::exists(top / layer)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(top / layer)) {
      if (entry.path().extension() != ".hpp") continue;
      std::ifstream stream(entry.path());
      std::string first;
      std::getline(stream, first);
      EXPECT_EQ(first, "#pragma once") << entry.path();
    }
  }
}

TEST(Includes, LinesAreRead) {
  const auto target = [](const char* line) {
    const auto found = include_target(line);
    return found ? (found->second ? "q:" : "a:") + found->first : "";
  };
  EXPECT_EQ(target("#include \"core/base/ids.hpp\"  // why"), "q:core/base/ids.hpp");
  EXPECT_EQ(target("  #  include <vector>"), "a:vector");
  EXPECT_EQ(target("// #include <vector>"), "");
  EXPECT_EQ(target("#define X \"y\""), "");
  EXPECT_EQ(target("#include MACRO"), "");
  EXPECT_EQ(target("#"), "");
}

TEST(Includes, TheRulesFindWhatTheyForbid) {
  const auto refused = [](const char* file, const char* target) {
    return violation(file, target).has_value();
  };
  EXPECT_TRUE(refused("core/base/x.cpp", "render/camera.hpp"));
  EXPECT_TRUE(refused("core/document/x.cpp", "imgui.h"));
  EXPECT_TRUE(refused("core/document/x.cpp", "GLFW/glfw3.h"));
  EXPECT_TRUE(refused("ui/view/x.cpp", "GLFW/glfw3.h"));
  EXPECT_TRUE(refused("core/document/x.cpp", "epoxy/gl.h"));
  EXPECT_TRUE(refused("core/document/x.cpp", "GL/gl.h"));
  EXPECT_TRUE(refused("core/base/x.cpp", "core/polyhedron/polyhedron.hpp"));
  EXPECT_TRUE(refused("core/polyhedron/x.hpp", "core/surface/surface.hpp"));
  EXPECT_TRUE(refused("core/surface/x.hpp", "core/network/network.hpp"));
  EXPECT_TRUE(refused("core/network/x.cpp", "core/patching/polyhedron_surface.hpp"));
  EXPECT_TRUE(refused("core/patching/x.cpp", "core/document/document.hpp"));
  EXPECT_TRUE(refused("core/document/x.cpp", "core/exchange/obj.hpp"));
  EXPECT_TRUE(refused("core/unknown/x.cpp", "vector"));
  EXPECT_TRUE(refused("render/x.cpp", "ui/panel.hpp"));
  EXPECT_TRUE(refused("render/x.cpp", "imgui_internal.h"));
  EXPECT_TRUE(refused("ui/view/x.cpp", "app/main_loop.hpp"));
  EXPECT_TRUE(refused("app/x.cpp", "tests/support/random.hpp"));
  EXPECT_TRUE(refused("ui/x.cpp", "imgui.h"));
  EXPECT_TRUE(refused("ui/unknown/x.cpp", "imgui.h"));
  EXPECT_TRUE(refused("ui/view/x.cpp", "ui/skin/skin_tools.hpp"));
  EXPECT_TRUE(refused("ui/paper/x.cpp", "ui/skin/skin_tools.hpp"));
  EXPECT_TRUE(refused("ui/paper/x.cpp", "ui/shell/workbench.hpp"));
  EXPECT_TRUE(refused("core/network/x.hpp", "Eigen/Sparse"));
  EXPECT_TRUE(refused("core/network/x.hpp", "Eigen/SparseCholesky"));
  EXPECT_TRUE(refused("app/x.hpp", "nlohmann/json.hpp"));
  EXPECT_TRUE(refused("app/commands/command_line/x.hpp", "CLI/CLI.hpp"));
  EXPECT_TRUE(refused("app/x.cpp", "CLI/CLI.hpp"));
  EXPECT_FALSE(refused("app/commands/command_line/x.cpp", "CLI/CLI.hpp"));
  EXPECT_TRUE(refused("core/network/x.cpp", "tbb/parallel_for.h"));
  EXPECT_TRUE(refused("core/cad/x.cpp", "TopoDS.hxx"));
  EXPECT_TRUE(refused("core/cad/kernel/cad_file.hpp", "gp_Pnt.hxx"));

  EXPECT_FALSE(refused("ui/skin/x.cpp", "ui/view/tool.hpp"));
  EXPECT_FALSE(refused("ui/shell/x.cpp", "ui/skin/skin_tools.hpp"));
  EXPECT_FALSE(refused("core/network/x.cpp", "Eigen/SparseCore"));
  EXPECT_FALSE(refused("core/base/solvers/sparse_solver.cpp", "Eigen/SparseCholesky"));
  EXPECT_FALSE(refused("core/base/parallel.cpp", "tbb/parallel_for.h"));
  EXPECT_FALSE(refused("core/cad/kernel/opencascade/shape.cpp", "TopoDS.hxx"));
  EXPECT_FALSE(refused("core/patching/x.hpp", "core/surface/surface.hpp"));
  EXPECT_FALSE(refused("core/document/x.cpp", "core/patching/polyhedron_surface.hpp"));
  EXPECT_FALSE(refused("ui/view/x.cpp", "imgui.h"));
  EXPECT_FALSE(refused("app/x.cpp", "ui/panel.hpp"));
  EXPECT_FALSE(refused("render/x.cpp", "core/surface/surface.hpp"));
  EXPECT_FALSE(refused("core/document/x.hpp", "nlohmann/json_fwd.hpp"));
}

}  // namespace
