#pragma once

// Surfaces of every producer: the samples, and some in other modes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "core/document/file.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

struct Produced {
  std::string name;
  Surface surface;
};

struct WantedSample {
  std::string file;  ///< name in assets/samples, without its ending
  std::optional<Mode> mode = {};
};

/// All objects of a sample, by their surfaces; `mode` instead of the polyhedra's own.
inline std::vector<Produced> surfaces_of(const WantedSample& wanted) {
  const auto document = load_document(test::source_folder() + "/assets/samples/" + wanted.file + ".hariko");
  if (!document.ok()) {
    ADD_FAILURE() << wanted.file << ": " << document.error().text;
    return {};
  }
  Document changed = *document;
  std::vector<Produced> out;
  for (auto& object : changed.objects) {
    if (wanted.mode && object->polyhedron()) {
      Object other = *object;
      std::get<PolyhedronSource>(other.source).mode = *wanted.mode;
      object = std::make_shared<const Object>(std::move(other));
    }
    if (!object->has_surface()) continue;
    auto made = object_surface(changed, *object);
    if (!made.ok()) {
      ADD_FAILURE() << wanted.file << ": " << made.error().text;
      continue;
    }
    out.push_back({wanted.file + ", " + object->name, std::move(made->surface)});
  }
  return out;
}

/// One of each kind of patches; all samples, polyhedra in all modes, in long runs: there only the sample that
/// the environment variable HARIKO_SAMPLE names, where it is set.
inline std::vector<WantedSample> wanted_samples() {
  if (repetitions(1) < 2)
    return {{"cube_crease"}, {"grid3", Mode::paper}, {"fig2_open"},   {"cube", Mode::g2},
            {"solids_one"},  {"skin_merge_inside"},  {"skin_smooth"}, {"wheel_arch"}};
  std::vector<WantedSample> out;
  for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() + "/assets/samples")) {
    if (entry.path().extension() != ".hariko") continue;
    const std::string name = entry.path().stem().string();
    if (const char* only = std::getenv("HARIKO_SAMPLE"); only && name != only) continue;
    out.push_back({name});
    for (const Mode mode : {Mode::paper, Mode::target, Mode::g2})
      if (name == "cube" || name == "cube_crease" || name == "fig2_open" || name == "grid3" ||
          name == "torus")
        out.push_back({name, mode});
  }
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) {
    return std::pair(a.file, a.mode) < std::pair(b.file, b.mode);
  });
  return out;
}

/// test(name, surface).
template <class Test>
void for_named(const Test& test) {
  for (const WantedSample& wanted : wanted_samples())
    for (const Produced& produced : surfaces_of(wanted)) {
      const std::string name =
          produced.name + (wanted.mode ? ", mode " + std::to_string(int(*wanted.mode)) : "");
      SCOPED_TRACE(name);
      test(name, produced.surface);
    }
}

template <class Test>
void for_produced(const Test& test) {
  for_named([&](const std::string&, const Surface& surface) { test(surface); });
}

}  // namespace hariko::test
