#pragma once

// G2Given: the data of mode G2's system from positions, network and joins, and its contribution to the
// right-hand side (g2.md section 6).

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "core/g2/g2_target.hpp"
#include "core/network/network.hpp"

namespace hariko {

/// Given data of a solve. Without `sides` everything that joins give is zero, as in the response to a
/// displacement, which does not affect them.
struct G2Given {
  std::span<const Vector3> positions;
  const Network* network = nullptr;
  const GivenSides* sides = nullptr;
  const G2Target* target = nullptr;  ///< null: no target curvature, as in the response to a displacement
};

/// Mean of a face's vertices.
Vector3 face_mean(const HalfEdgeMesh& mesh, Index face, const G2Given& given);
/// Given controls of a face, in the order of `ControlPlaces::given`; positions are relative to `origin`.
void given_controls(const G2Layout& layout, Index face, const G2Given& given, const Vector3& origin,
                    Vector3* out);
/// Adds the right-hand side of the tangents' terms, in the face's controls.
void add_tangents(const G2Layout& layout, const FaceWeights& weights, Index face, const Network& network,
                  Vector3* local);
/// Unknowns with known values, and these values. `fixed`, per vertex: its tangents are the network's; empty
/// where none are.
std::vector<std::pair<Index, Vector3>> known_unknowns(const G2Layout& layout, const std::vector<bool>& fixed,
                                                      const G2Given& given);

}  // namespace hariko
