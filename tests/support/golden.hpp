#pragma once

// Independent reader of the reference files in tests/golden: it shares no code with the program's readers.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "core/network/shaping.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "tests/support/places.hpp"

namespace hariko::test {

/// Path of a reference file.
inline std::string golden_path(const std::string& name) {
  return test::source_folder() + "/tests/golden/" + name;
}

/// JSON of a reference file; a missing file fails the test.
inline nlohmann::json golden_json(const std::string& name) {
  std::ifstream file(golden_path(name));
  if (!file) ADD_FAILURE() << "missing " << name;
  return nlohmann::json::parse(file);
}

/// Reads an OBJ file with plain "v" and "f" lines.
inline PolygonMesh golden_obj(const std::string& name) {
  std::ifstream file(golden_path(name));
  if (!file) ADD_FAILURE() << "missing " << name;
  PolygonMesh mesh;
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Vector3 p;
      words >> p.x() >> p.y() >> p.z();
      mesh.positions.push_back(p);
    } else if (kind == "f") {
      std::vector<Index> face;
      for (Index i; words >> i;) face.push_back(i - 1);
      mesh.add_face(face);
    }
  }
  return mesh;
}

/// Edge by its key "a-b".
inline EdgeId golden_edge(const std::string& key) {
  const std::size_t dash = key.find('-');
  return EdgeId::of({static_cast<std::uint32_t>(std::stoul(key.substr(0, dash)))},
                    {static_cast<std::uint32_t>(std::stoul(key.substr(dash + 1)))});
}

/// Shaping from a tension file.
inline Shaping golden_tension(const std::string& name) {
  const nlohmann::json json = golden_json(name);
  Shaping shaping;
  const auto beta = json.value("beta", nlohmann::json::object());
  const auto alpha = json.value("alpha", nlohmann::json::object());
  const auto crease = json.value("crease", nlohmann::json::array());
  for (const auto& [key, value] : beta.items()) shaping.beta.set(golden_edge(key), value.get<double>());
  for (const auto& [key, value] : alpha.items())
    shaping.alpha.set({static_cast<std::uint32_t>(std::stoul(key))}, value.get<double>());
  for (const auto& edge : crease)
    shaping.crease.set(EdgeId::of({edge[0].get<std::uint32_t>()}, {edge[1].get<std::uint32_t>()}), true);
  return shaping;
}

/// Mode by its name in file names.
inline Mode golden_mode(const std::string& name) {
  return name == "paper" ? Mode::paper : name == "target" ? Mode::target : Mode::fair;
}

/// Reference case: file stem, polyhedron, tension file (may be empty).
struct GoldenCase {
  std::string stem, obj, tension;
  friend void PrintTo(const GoldenCase& c, std::ostream* out) { *out << c.stem; }
};

/// All reference cases.
inline std::vector<GoldenCase> golden_cases() {
  std::vector<GoldenCase> cases;
  for (const char* model : {"cube", "octahedron", "grid3", "fig2", "fig2_open", "prism6"})
    for (const char* mode : {"paper", "target", "fair"})
      cases.push_back({std::string(model) + "_" + mode, std::string(model) + ".obj", ""});
  for (const char* mode : {"paper", "fair"}) {
    cases.push_back({std::string("cube_crease_") + mode, "cube.obj", "cube_crease.tension.json"});
    cases.push_back({std::string("fig5c_") + mode, "fig2.obj", "fig5c.tension.json"});
    cases.push_back({std::string("fig5d_") + mode, "fig2.obj", "fig5d.tension.json"});
  }
  return cases;
}

/// Input of a surface from reference files.
inline PolyhedronSurfaceInput golden_input(const std::string& obj, Mode mode,
                                           const std::string& tension = {}) {
  PolyhedronSurfaceInput input{Polyhedron::build(golden_obj(obj)).value(), {}, mode, Vector3::Zero()};
  if (!tension.empty()) input.shaping = golden_tension(tension);
  return input;
}

}  // namespace hariko::test
