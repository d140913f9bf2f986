#pragma once

// Tightness as designers know it, and the radius of the ball it means (docs/envelope.md).

#include <optional>
#include <span>

#include "core/envelope/solid.hpp"

namespace hariko {

/// Diagonal of the box round the solids.
double solids_size(std::span<const Solid> solids);

/// At tightness 1 the ball is as small as the rounding allows, towards 0 it is 8 times as large as the
/// solids; nothing at 0, where the surface is the rounded hull. Logarithmic between.
std::optional<double> ball_radius_at(double tightness, double rounding, double size);
/// From 0 to 1; larger and smaller balls count as those at the ends.
double tightness_of(std::optional<double> radius, double rounding, double size);

/// Settings that a new object of these solids begins with: a cylinder stays a cylinder, notches are filled
/// softly.
void choose_ball(EnvelopeInput& input);
/// For settings of documents from before there was the ball, which had a tightness.
void choose_ball_as_before(EnvelopeInput& input, double tightness);

/// How far flat faces of the surface lie outside of those of a solid, a length; of solids without flat faces,
/// how far the surface does where they bend most. Said too small of solids thinner than the rounding.
double faces_outside(const Solid& solid, const EnvelopeSettings& settings, double size);

/// Enlarges the ball to the smallest that makes one part of the solids' surface; the hull where none does.
/// False, and nothing is changed, where it is one part already. As long as eight surfaces take.
bool join_parts(EnvelopeInput& input);

}  // namespace hariko
