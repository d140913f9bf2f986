#pragma once

// Handles in the notches between solids that touch: the fillet there widens and narrows with the waist.

#include "core/envelope/cage_surface.hpp"
#include "core/envelope/envelope_handles.hpp"
#include "core/envelope/field_cage.hpp"

namespace hariko {

/// On the curves from one solid to another, of those that touch and meet at an angle, where both are equally
/// far. `fillet`: the cage's, over the cell; `distance`: length that it keeps from the solids; `cell`: one
/// a vertex. Middles go about the way that is told. O(edges + vertices * solids).
std::vector<EnvelopeBridge> fillet_bridges(const FieldScene& scene, const EnvelopeInput& input,
                                           const CageSurface& surface, std::span<const double> cell,
                                           double fillet, double distance);

}  // namespace hariko
