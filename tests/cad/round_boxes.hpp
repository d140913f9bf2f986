#pragma once

// Closed surfaces of six biquadratic patches, to be put into each other.

#include <cmath>
#include <vector>

#include "core/surface/weld_patches.hpp"

namespace hariko::test {

/// Box with bulging faces: similar to all others, and round a middle that it contains. Inward: its faces look
/// at the middle.
struct RoundBox {
  double size = 1;
  Vector3 middle = Vector3::Zero();
  bool inward = false;
};

/// Control point for a place of the lattice -1, 0, 1 on the sides of a cube.
inline Vector3 round_box_point(const RoundBox& box, const Vector3& place) {
  return box.middle + box.size * place / std::pow(place.norm(), 0.7);
}

inline std::vector<BezierPatch> patches_of(const RoundBox& box) {
  std::vector<BezierPatch> out;
  for (int axis = 0; axis < 3; ++axis)
    for (const int end : {-1, 1}) {
      BezierPatch patch;
      patch.degree_s = patch.degree_t = 2;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
          Vector3 place;
          place[axis] = end;
          place[(axis + 1) % 3] = i;
          place[(axis + 2) % 3] = j;
          patch.points.push_back(round_box_point(box, place));
        }
      out.push_back((end < 0) != box.inward ? flipped(patch) : patch);
    }
  return out;
}

/// One surface of several boxes.
inline Surface surface_of(const std::vector<RoundBox>& boxes) {
  std::vector<BezierPatch> patches;
  for (const RoundBox& box : boxes) {
    const auto own = patches_of(box);
    patches.insert(patches.end(), own.begin(), own.end());
  }
  return weld_patches(Vector3::Zero(), std::move(patches)).value();
}

}  // namespace hariko::test
