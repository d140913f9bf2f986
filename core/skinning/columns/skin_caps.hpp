#pragma once

// Faces that close the ends of a tube.

#include "core/skinning/columns/skin_mesh.hpp"

namespace hariko {

/// Adds the skin's caps at the ends of an open path with closed sections; `mesh` has the faces of the strips.
/// Flat: one face inside an infinitely sharp crease. Dome: a ring at half the size, pushed outwards by 0.35
/// of the section's mean radius, and one face; the row of the section then moves so that the surface still
/// passes through the section's curve, wherever the vertices of the row are regular.
void add_caps(const Skin& skin, const SkinPlan& plan, SkinMesh& mesh);

}  // namespace hariko
