#pragma once

// Tangent planes at vertices of cages that are not convex (spec 3.1b).

#include "core/envelope/network_cage.hpp"

namespace hariko {

/// The unit vector whose least product with the normals is largest.
Vector3 maximin_normal(std::span<const Vector3> normals);

/// Gives a vertex of a solid, which stands where it is now, the solid's own frame there.
void put_on_solid(CageVertex& vertex, const PlacedSolid& solid);

/// Gives every vertex a normal that sees all its corners from outside: valley vertices one near their outward
/// direction, vertices of solids the solid's own where that does.
void set_valley_frames(NetworkCage& cage);

}  // namespace hariko
