#pragma once

// Numbering of mode FAIR's unknowns, globally and within each face (kuriyama.md section 6).

#include <memory>
#include <vector>

#include "core/base/lazy_zero_array.hpp"
#include "core/patching/quartic/patch_constants.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// Values of all unknowns, one vector each.
using FairField = ZeroedArray<Vector3>;

/// Numbering of the unknowns. Per face: O, Ys, Yc, then z at both ends of each split edge. Per inner smooth
/// edge: z at both ends, shared by its faces. Per side on a sharp edge: z at both ends, the side's own. A
/// face's *local* vector has its unknowns in that order, those of its sides last, one coordinate after the
/// other.
struct FairNumbering {
  /// `given_side`, per half-edge: z of this border edge is zero; empty when there is none.
  FairNumbering(std::shared_ptr<const HalfEdgeMesh> mesh, const PatchConstants& constants,
                std::vector<bool> given_side);

  std::shared_ptr<const HalfEdgeMesh> mesh;
  std::size_t count = 0;
  std::vector<std::size_t> face_begin;   ///< first unknown of each face
  std::vector<std::size_t> local_begin;  ///< start of each face's local vector in workspaces, in unknowns
  std::vector<std::size_t> side_origin;  ///< per half-edge: unknown z at its origin
  std::vector<std::size_t> side_target;
  /// Per half-edge: factor of the shared z in the point of the half-edge's own face.
  std::vector<double> side_scale;
  std::vector<bool> given_side;

  bool is_given(Index h) const { return !given_side.empty() && given_side[h]; }
  std::size_t local_size(Index face) const { return local_begin[face + 1] - local_begin[face]; }
  /// Place of z at the origin of a half-edge's side in its face's local vector; z at the target follows.
  std::size_t local_side(Index h) const;
  /// Copies the face's unknowns to a local vector, with z scaled as its element expects if `scaled`.
  void gather(Index face, const FairField& x, bool scaled, double* local) const;
  /// Copies back the unknowns that no other face has.
  void scatter_interior(Index face, const double* local, FairField& y) const;
};

}  // namespace hariko
