#pragma once

// Attachment: a border edge of a polyhedron object is joined to a side of a patch object (kuriyama.md section
// 8). Here is what a document says about it; core/modeling/attached.hpp makes joins of it.

#include <array>
#include <optional>

#include "core/base/flat_map.hpp"
#include "core/base/ids.hpp"
#include "core/base/vector.hpp"
#include "core/surface/bicubic_patch.hpp"

namespace hariko {

/// Who gives way where the two meet.
enum class Adapts : std::uint8_t {
  surface,  ///< the polyhedron's surface takes the patch's tangent planes
  patch     ///< the patch's second row of points takes the surface's
};

/// A side whose patch is gone: its points relative to the polyhedron's origin, in the half-edge's direction.
struct FrozenSide {
  std::array<Vector3, 4> curve, row;
  friend bool operator==(const FrozenSide&, const FrozenSide&) = default;
};

struct Attachment {
  ObjectId patch;  ///< does not count when frozen
  NetSide side;
  /// The edge's half-edge runs against the side's direction, as it does where both face the same way.
  bool reversed = true;
  Continuity continuity = Continuity::g1;  ///< G0 or G1
  Adapts adapts = Adapts::surface;         ///< counts with G1 only
  std::optional<FrozenSide> frozen = {};
  friend bool operator==(const Attachment&, const Attachment&) = default;
};

using Attachments = FlatMap<EdgeId, Attachment>;

}  // namespace hariko
