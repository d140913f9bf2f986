#pragma once

// G2Given: what positions, network and joins give to mode G2's system, and its part of the right-hand side
// (g2.md section 6).

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "core/g2/g2_target.hpp"
#include "core/network/network.hpp"

namespace hariko {

/// Without `sides` all that joins give is zero: the answer to a displacement, which they do not feel.
struct G2Given {
  std::span<const Vector3> positions;
  const Network* network = nullptr;
  const GivenSides* sides = nullptr;
  const G2Target* target = nullptr;  ///< none: no curvature; the answer to a displacement
};

Vector3 face_mean(const HalfEdgeMesh& mesh, Index face, const G2Given& given);
/// In the order of `ControlPlaces::given`; positions are relative to `origin`.
void given_controls(const G2Layout& layout, Index face, const G2Given& given, const Vector3& origin,
                    Vector3* out);
/// Right-hand side of the tangents' terms, in the face's controls.
void add_tangents(const G2Layout& layout, const FaceWeights& weights, Index face, const Network& network,
                  Vector3* local);
/// Unknowns that are given, with their values. `fixed`: per vertex, whether its tangents are the network's;
/// empty where none are.
std::vector<std::pair<Index, Vector3>> known_unknowns(const G2Layout& layout, const std::vector<bool>& fixed,
                                                      const G2Given& given);

}  // namespace hariko
