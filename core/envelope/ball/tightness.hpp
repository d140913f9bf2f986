#pragma once

// Tightness, the designer's setting, and the ball radius it stands for (docs/envelope.md).

#include <optional>
#include <span>

#include "core/envelope/solid.hpp"

namespace hariko {

/// Diagonal of the bounding box of the solids.
double solids_size(std::span<const Solid> solids);

/// Ball radius for a tightness: at 1 the ball is as small as the rounding allows, towards 0 it is 8 times as
/// large as the solids; nothing at 0, where the surface is the rounded hull. Logarithmic in between.
std::optional<double> ball_radius_at(double tightness, double rounding, double size);
/// Tightness of a ball radius, 0 .. 1; larger and smaller balls count as those at the ends.
double tightness_of(std::optional<double> radius, double rounding, double size);

/// Sets the defaults of a new object of these solids: a cylinder stays a cylinder, notches are filled softly.
void choose_ball(EnvelopeInput& input);
/// Converts settings with a tightness, of documents older than method `ball`.
void choose_ball_as_before(EnvelopeInput& input, double tightness);

/// Distance of the surface's flat faces outside those of a solid, a length; for solids without flat faces the
/// distance of the surface where they are curved most. Too small for solids thinner than the rounding.
double faces_outside(const Solid& solid, const EnvelopeSettings& settings, double size);

/// Enlarges the ball to the smallest that makes the surface one component; uses the hull where none does.
/// Returns false, and changes nothing, where it is one component already. Takes as long as eight surfaces.
bool join_parts(EnvelopeInput& input);

}  // namespace hariko
