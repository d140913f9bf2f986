#pragma once

// Kept forms: conversion between the offsets that a vertex keeps along its edges and those of its basis
// vectors (kuriyama.md section 12.7).

#include <span>
#include <vector>

#include "core/network/shaping.hpp"
#include "core/network/vertex_frames.hpp"

namespace hariko {

/// Coordinate frames of the edges of a fan, as columns: along the edge and at right angles to the mean normal
/// of the corners; to the left; and that normal. Zero where an edge has no such direction.
std::vector<Matrix3> edge_directions(const Polyhedron& polyhedron, Index v, std::span<const FanEnd> fan);

/// Image of an end's unit vector under basis vectors.
Vector3 image_of_unit(const VertexFrames& frames, Index end, std::span<const Vector3> basis);

/// Fits the vertex's basis vectors (its part of `basis`, the basis vectors of all vertices): sets them to
/// those whose images of the unit vectors of `ends` come nearest to `images`, by least squares. False, and no
/// change, where the edges do not determine them.
bool fit_basis(const VertexFrames& frames, Index v, std::span<const Index> ends,
               std::span<const Vector3> images, std::span<Vector3> basis);

/// Sets the vertex's part of `offset` (one per basis vector of all vertices) to what the kept form gives.
void add_form_offset(const Polyhedron& polyhedron, const VertexFrames& frames, Index v, const KeptForm& form,
                     std::span<Vector3> offset);

/// Mirror image of a vertex's kept form, with the same ids.
KeptForm reflected_form(KeptForm form);

}  // namespace hariko
