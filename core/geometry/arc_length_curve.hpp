#pragma once

// ArcLengthCurve: a curve of pieces by its arc length, with frames that turn about it as little as they can.

#include <functional>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"

namespace hariko {

inline constexpr Code e_curve_length{"E_CURVE_LENGTH"};

/// Point of a curve and its derivative with respect to the parameter.
struct CurveSample {
  Vector3 position = Vector3::Zero(), along = Vector3::Zero();
};
/// Piece of a curve over the parameters 0 .. 1, smooth between them.
using CurvePiece = std::function<CurveSample(double)>;

CurvePiece straight_piece(const Vector3& from, const Vector3& to);

/// The pieces of the same curve run through from its end. A closed curve begins where it began before.
std::vector<CurvePiece> run_backward(std::vector<CurvePiece> pieces);

/// Immutable. Pieces follow each other; where their tangents differ the curve has a corner.
class ArcLengthCurve {
 public:
  /// Makes the curve of pieces of which each begins where the one before it ends, the first of a closed curve
  /// where the last ends. Pieces without a length are left out. Error: E_CURVE_LENGTH (no length, or not
  /// finite). O(pieces).
  static Result<ArcLengthCurve> make(std::vector<CurvePiece> pieces, bool closed);

  double length() const { return length_; }
  bool closed() const { return closed_; }

  struct Place {
    Vector3 position;
    /// Right-handed orthonormal columns; the third is the tangent, at a corner between both tangents. Along
    /// the curve the frame is rotation-minimising. On a closed curve the angle by which it comes back turned
    /// is spread over the length, so that the end has the frame of the beginning.
    Matrix3 frame;
  };
  /// Place at an arc length from the beginning, which is accurate to about 1e-12 of the length where the
  /// pieces are cubic or straight. Lengths outside of 0 .. length() count as the nearest end, on closed
  /// curves they go round. O(log pieces).
  Place at(double way) const;

 private:
  /// Part of a piece, short enough for one Gauss rule.
  struct Span {
    std::size_t piece = 0;
    double begin = 0, end = 1;            ///< parameters of the piece
    double way = 0, length = 0;           ///< arc length before it, and its own
    Vector3 first_tangent, last_tangent;  ///< unit vectors
    Vector3 first_across, last_across;    ///< first columns of the frames, before the turn of closed curves
  };
  ArcLengthCurve() = default;
  void add_piece(std::size_t piece);
  void carry_frames();
  std::size_t span_at(double way) const;
  double parameter_at(const Span& span, double way) const;
  /// Corner or smooth joint within a tolerance of the way: the span that begins there.
  const Span* joint_at(std::size_t span, double way) const;

  std::vector<CurvePiece> pieces_;
  std::vector<Span> spans_;
  bool closed_ = false;
  double length_ = 0;
  double turn_ = 0;  ///< radians, spread over the length
};

}  // namespace hariko
