#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/gaussmap/truths.hpp"
#include "tests/support/places.hpp"

namespace hariko::test {

Outline golden_outline(const std::string& name) {
  std::ifstream file(test::source_folder() + "/tests/golden/gaussmap/" + name + ".json");
  const auto json = nlohmann::json::parse(file);
  Outline out;
  for (const auto& loop : json.at("loops")) {
    OutlineLoop& made = out.loops.emplace_back();
    for (const auto& p : loop.at("points")) made.points.emplace_back(p[0], p[1], p[2]);
    for (const auto& n : loop.at("normals")) made.normals.emplace_back(n[0], n[1], n[2]);
    for (const auto& k : loop.at("K")) made.curvature.push_back(k);
  }
  return out;
}

}  // namespace hariko::test
