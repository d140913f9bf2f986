#include "core/geometry/arc_length_curve.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/geometry/angles.hpp"
#include "core/geometry/rotation.hpp"

namespace hariko {

namespace {

constexpr int spans_of_piece = 16;
/// Pieces that are shorter count as points, relative to the whole length.
constexpr double least_piece = 1e-12;
/// Places this near to a joint have its tangent, relative to the whole length.
constexpr double joint_tolerance = 1e-8;

/// Nodes and weights of the Gauss rule of five points on 0 .. 1.
constexpr std::array<std::pair<double, double>, 5> gauss_of_span{
    {{0.046910077030668004, 0.11846344252809454},
     {0.23076534494715845, 0.23931433524968324},
     {0.5, 0.28444444444444444},
     {0.76923465505284155, 0.23931433524968324},
     {0.95308992296933200, 0.11846344252809454}}};

double length_between(const CurvePiece& piece, double begin, double end) {
  double sum = 0;
  for (const auto& [node, weight] : gauss_of_span)
    sum += weight * piece(begin + node * (end - begin)).along.norm();
  return sum * (end - begin);
}

/// Unit tangent; where the derivative vanishes, that of a short chord.
Vector3 tangent_of_piece(const CurvePiece& piece, double x) {
  constexpr double least_speed = 1e-9, half = 1e-4;
  const Vector3 along = piece(x).along;
  const double from = std::clamp(x - half, 0.0, 1 - 2 * half);
  const Vector3 chord = piece(from + 2 * half).position - piece(from).position;
  return along.norm() > least_speed * chord.norm() / (2 * half) ? along.normalized() : chord.normalized();
}

/// Carries a vector over a part of a piece. A chord that does not go with the tangents is but rounding, or
/// goes round a cusp, and is left out.
Vector3 carried_over(const Vector3& across, const Vector3& from, const Vector3& to, const Vector3& chord) {
  const bool goes_along = chord.dot(from + to) > 0.5 * chord.norm();
  return carried_along(across, from, to, goes_along ? chord : Vector3(Vector3::Zero()));
}

}  // namespace

CurvePiece straight_piece(const Vector3& from, const Vector3& to) {
  return [from, along = Vector3(to - from)](double x) -> CurveSample { return {from + x * along, along}; };
}

std::vector<CurvePiece> run_backward(std::vector<CurvePiece> pieces) {
  std::reverse(pieces.begin(), pieces.end());
  for (CurvePiece& piece : pieces)
    piece = [forward = std::move(piece)](double x) -> CurveSample {
      const CurveSample sample = forward(1 - x);
      return {sample.position, -sample.along};
    };
  return pieces;
}

Result<ArcLengthCurve> ArcLengthCurve::make(std::vector<CurvePiece> pieces, bool closed) {
  ArcLengthCurve out;
  out.closed_ = closed;
  double whole = 0;
  std::vector<double> lengths;
  for (const CurvePiece& piece : pieces) {
    lengths.push_back(length_between(piece, 0, 1));
    whole += lengths.back();
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (lengths[i] > least_piece * whole) out.pieces_.push_back(std::move(pieces[i]));
  for (std::size_t i = 0; i < out.pieces_.size(); ++i) out.add_piece(i);
  if (!(out.length_ > 0) || !std::isfinite(out.length_))
    return make_error(e_curve_length, "The curve has no length.", "Move its points apart.");
  out.carry_frames();
  return out;
}

void ArcLengthCurve::add_piece(std::size_t piece) {
  for (int i = 0; i < spans_of_piece; ++i) {
    Span span;
    span.piece = piece;
    span.begin = double(i) / spans_of_piece;
    span.end = double(i + 1) / spans_of_piece;
    span.way = length_;
    span.length = length_between(pieces_[piece], span.begin, span.end);
    span.first_tangent = tangent_of_piece(pieces_[piece], span.begin);
    span.last_tangent = tangent_of_piece(pieces_[piece], span.end);
    length_ += span.length;
    spans_.push_back(span);
  }
}

void ArcLengthCurve::carry_frames() {
  Vector3 across = spans_.front().first_tangent.unitOrthogonal();
  const Vector3 nowhere = Vector3::Zero();
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    Span& span = spans_[i];
    if (i > 0) across = carried_along(across, spans_[i - 1].last_tangent, span.first_tangent, nowhere);
    span.first_across = across;
    const CurvePiece& piece = pieces_[span.piece];
    const Vector3 chord = piece(span.end).position - piece(span.begin).position;
    across = span.last_across = carried_over(across, span.first_tangent, span.last_tangent, chord);
  }
  if (!closed_) return;
  const Span& first = spans_.front();
  const Vector3 back = carried_along(across, spans_.back().last_tangent, first.first_tangent, nowhere);
  turn_ = signed_angle(back, first.first_across, first.first_tangent);
}

std::size_t ArcLengthCurve::span_at(double way) const {
  const auto after = std::upper_bound(spans_.begin(), spans_.end(), way,
                                      [](double w, const Span& span) { return w < span.way; });
  return after == spans_.begin() ? 0 : static_cast<std::size_t>(after - spans_.begin()) - 1;
}

/// Newton's method, kept between two parameters round the solution.
double ArcLengthCurve::parameter_at(const Span& span, double way) const {
  const CurvePiece& piece = pieces_[span.piece];
  const double wanted = std::clamp(way - span.way, 0.0, span.length);
  if (!(span.length > 0)) return span.begin;
  double low = span.begin, high = span.end;
  double x = low + wanted / span.length * (high - low);
  constexpr int most_steps = 40;
  constexpr double accuracy = 1e-15;
  for (int step = 0; step < most_steps; ++step) {
    const double excess = length_between(piece, span.begin, x) - wanted;
    if (std::abs(excess) <= accuracy * length_) break;
    (excess > 0 ? high : low) = x;
    const double speed = piece(x).along.norm();
    double next = speed > 0 ? x - excess / speed : low;
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (next == x) break;
    x = next;
  }
  return x;
}

const ArcLengthCurve::Span* ArcLengthCurve::joint_at(std::size_t span, double way) const {
  const double tolerance = joint_tolerance * length_;
  const auto begins_piece = [&](std::size_t i) {
    return i == 0 ? closed_ : spans_[i].piece != spans_[i - 1].piece;
  };
  const Span& here = spans_[span];
  if (way - here.way <= tolerance && begins_piece(span)) return &here;
  if (here.way + here.length - way > tolerance) return nullptr;
  const std::size_t next = (span + 1) % spans_.size();
  return begins_piece(next) ? &spans_[next] : nullptr;
}

ArcLengthCurve::Place ArcLengthCurve::at(double way) const {
  double place = closed_ ? way - std::floor(way / length_) * length_ : way;
  place = std::clamp(place, 0.0, length_);
  const std::size_t index = span_at(place);
  const Span& span = spans_[index];
  const CurvePiece& piece = pieces_[span.piece];
  const double x = parameter_at(span, place);
  Place out{piece(x).position, Matrix3::Identity()};
  Vector3 tangent, across;
  if (const Span* joint = joint_at(index, place)) {
    const Span& before = joint == &spans_.front() ? spans_.back() : *(joint - 1);
    const Vector3 sum = before.last_tangent + joint->first_tangent;
    tangent = sum.norm() > joint_tolerance ? Vector3(sum.normalized()) : joint->first_tangent;
    across = carried_along(joint->first_across, joint->first_tangent, tangent, Vector3::Zero());
    place = joint->way;
  } else {
    tangent = tangent_of_piece(piece, x);
    const Vector3 chord = out.position - piece(span.begin).position;
    across = carried_over(span.first_across, span.first_tangent, tangent, chord);
  }
  across = Eigen::AngleAxisd(turn_ * place / length_, tangent) * across;
  across = (across - across.dot(tangent) * tangent).normalized();
  out.frame.col(0) = across;
  out.frame.col(1) = tangent.cross(across);
  out.frame.col(2) = tangent;
  return out;
}

}  // namespace hariko
