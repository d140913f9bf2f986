#include "core/skinning/sections/section_direction.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <optional>

#include "core/skinning/sections/section_starts.hpp"
#include "core/skinning/sections/skin_frames.hpp"

namespace hariko {

namespace {

/// Sum of squared distances at equal parameters, relative to the places on the path.
double gap(const SkinSection& a, const Vector3& at_a, const SkinSection& b, const Vector3& at_b,
           bool turned) {
  constexpr int samples = 32;
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    const double u = double(i) / (samples - 1);
    const Vector3 p = evaluate(a.curve(), u).position - at_a;
    sum += (p - (evaluate(b.curve(), turned ? 1 - u : u).position - at_b)).squaredNorm();
  }
  return sum;
}

/// Whether the closed section is nearer to the one before when it is reversed, each direction at its best
/// start.
bool nearer_reversed(const SubdivisionCurve& before, const SubdivisionCurve& own) {
  const StartMatch straight = nearest_start(before, own), turned = nearest_start(before, reversed(own));
  return turned.displacement < straight.displacement - 1e-9 * straight.size;
}

/// Section curve relative to the path, in its frames; without frames only relative to the path's point.
SubdivisionCurve offsets_of(const Skin& skin, const SkinSection& section, const SkinFrames* frames) {
  SubdivisionCurve curve = section.curve();
  const Vector3 place = evaluate(skin.path, section.v).position;
  const Matrix3 inverse = frames ? Matrix3(frames->frame(section.v).inverse()) : Matrix3::Identity();
  for (Vector3& p : curve.points) p = inverse * (p - place);
  return curve;
}

}  // namespace

Skin turn_sections(Skin skin) {
  if (skin.path.size() < (skin.path.closed ? 3 : 2)) return skin;
  const bool closed = std::any_of(skin.sections.begin(), skin.sections.end(),
                                  [](const SkinSection& s) { return s.closed && s.size() > 2; });
  std::optional<SkinFrames> frames;
  if (closed && skin.frame != FrameMode::two_rail)
    if (auto made = SkinFrames::make(skin)) frames = *std::move(made);
  const SkinSection* before = nullptr;
  for (SkinSection& section : skin.sections) {
    if (section.size() < 2) continue;
    bool turn = false;
    if (before && section.closed && before->closed && section.size() > 2) {
      const SkinFrames* turning = frames ? &*frames : nullptr;
      turn = nearer_reversed(offsets_of(skin, *before, turning), offsets_of(skin, section, turning));
    } else if (before && !section.closed) {
      const Vector3 at = evaluate(skin.path, section.v).position;
      const Vector3 at_before = evaluate(skin.path, before->v).position;
      const double straight = gap(*before, at_before, section, at, false);
      turn = gap(*before, at_before, section, at, true) < 0.99 * straight;
    }
    // A start that the designer has chosen stays the first point.
    const auto first = section.points.begin() + (section.closed && section.start_chosen ? 1 : 0);
    if (turn && !section.direction_chosen) std::reverse(first, section.points.end());
    before = &section;
  }
  return skin;
}

}  // namespace hariko
