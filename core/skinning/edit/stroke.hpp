#pragma once

// Recognition of strokes over the picture: the three gestures of Izumi and Suzuki. Pixels are design pixels.

#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Kind of a stroke. line: from one end to the other, nearly straight. lasso: closed. wedge: two nearly
/// straight legs that meet at a tip, 8 to 120 degrees apart.
enum class StrokeKind { none, line, lasso, wedge };

struct Stroke {
  StrokeKind kind = StrokeKind::none;
  /// line: its ends; lasso: the polygon; wedge: the end of a leg, the tip, the end of the other leg.
  std::vector<Vector2> points;
};

/// Classifies a stroke, resampled to 4 px. Lasso: start and end nearer than max(12 px, 8% of the length),
/// area above 150 px^2. Line: chord above 20 px, deviation below max(6 px, 6% of the chord). Wedge: one
/// corner splits it into two legs, each straight to 10% of its length. O(n^2) for n resampled points.
Stroke classify_stroke(const std::vector<Vector2>& pixels);

/// Crossing of segments a0-a1 and b0-b1, as fractions of both.
struct SegmentCrossing {
  bool crosses = false;
  double along_a = 0, along_b = 0;
};
/// Crossing of two segments; `crosses` is false if there is none.
SegmentCrossing cross_segments(const Vector2& a0, const Vector2& a1, const Vector2& b0, const Vector2& b1);

/// Nearest point of a segment, as a fraction of it and a distance.
struct SegmentFoot {
  double along = 0, distance = 0;
};
/// Nearest point of segment a-b to a point.
SegmentFoot foot_on_segment(const Vector2& a, const Vector2& b, const Vector2& point);

}  // namespace hariko
