#pragma once

// Skins with anything in them that skins can have, sound by construction or not made.

#include <cmath>
#include <numbers>

#include "core/skinning/columns/skin_plan.hpp"
#include "core/skinning/edit/edit_correspondence.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

/// Two to five sections of three to nine points along a bent path, all open or all closed, with a few
/// corners, links and merges that do not cross.
inline Skin random_skin(std::mt19937_64& rng) {
  Skin skin;
  skin.path.closed = chance(rng, 0.25);
  const int path_points = uniform_int(rng, skin.path.closed ? 4 : 2, 7);
  for (int i = 0; i < path_points; ++i) {
    const double a = 2 * std::numbers::pi * i / path_points;
    skin.path.points.push_back((skin.path.closed
                                    ? Vector3(8 * std::cos(a), 8 * std::sin(a), 0.3 * std::sin(3 * a))
                                    : Vector3(8.0 * i / (path_points - 1), 0, 0)) +
                               random_vector(rng, 0.4));
  }
  skin.frame = skin.path.closed || chance(rng, 0.5) ? FrameMode::rotation_minimising : FrameMode::automatic;
  const bool closed = chance(rng, 0.4);
  const int count = uniform_int(rng, skin.path.closed ? 3 : 2, 5);
  std::uint32_t id = 0;
  for (int k = 0; k < count; ++k) {
    SkinSection section;
    section.id = std::uint32_t(7 + k);
    section.closed = closed;
    section.v = skin.path.closed ? double(k) / count : double(k) / (count - 1);
    const CurvePoint place = evaluate(skin.path, section.v);
    Vector3 across = Vector3::UnitZ().cross(place.first).normalized();
    const Vector3 up = place.first.cross(across).normalized();
    const int n = uniform_int(rng, closed ? 4 : 3, 9);
    for (int i = 0; i < n; ++i) {
      const double a = 2 * std::numbers::pi * i / n;
      const Vector3 base = closed ? Vector3(std::cos(a) * across + std::sin(a) * up)
                                  : Vector3((4.0 * i / (n - 1) - 2) * across);
      section.points.push_back({id, place.position + base + random_vector(rng, 0.15), chance(rng, 0.1)});
      id += std::uint32_t(uniform_int(rng, 1, 3));
    }
    skin.sections.push_back(section);
  }
  for (int gesture = 0; gesture < 4; ++gesture) {
    const int a = uniform_int(rng, 0, skin.strip_count() - 1), b = (a + 1) % count;
    const SkinSection &first = skin.sections[std::size_t(a)], &second = skin.sections[std::size_t(b)];
    const auto point = [&](const SkinSection& s, int i) { return s.points[std::size_t(i)].id; };
    const std::uint32_t target = point(second, uniform_int(rng, 0, second.size() - 1));
    const int i = uniform_int(rng, 0, first.size() - 2);
    std::vector<std::uint32_t> members{point(first, i), point(first, i + 1)};
    if (i + 2 < first.size() && first.size() > 4 && chance(rng, 0.5)) members.push_back(point(first, i + 2));
    const auto edit = chance(rng, 0.5) ? merge_points(skin, members, target, uniform(rng, 0.2, 0.8))
                                       : join_points(skin, std::vector{members[0], target});
    if (edit) skin = edit->skin;
  }
  return skin;
}

}  // namespace hariko::test
