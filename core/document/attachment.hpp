#pragma once

// Attachment: a border edge of a polyhedron object is joined to a side of a patch object (kuriyama.md section
// 8). This is the document's data; core/modeling/surfacing/object_surfacer.hpp makes joins from it.

#include <array>
#include <optional>

#include "core/base/flat_map.hpp"
#include "core/base/ids.hpp"
#include "core/base/vector.hpp"
#include "core/surface/bicubic_patch.hpp"

namespace hariko {

/// The side of a join that is changed to make the surfaces tangent.
enum class Adapts : std::uint8_t {
  surface,  ///< the polyhedron's surface takes the patch's tangent planes
  patch     ///< the patch's second row of control points takes the surface's tangent planes
};

/// Copy of a side whose patch object was deleted: its points relative to the polyhedron's origin, in the
/// direction of the half-edge.
struct FrozenSide {
  std::array<Vector3, 4> curve, row;
  friend bool operator==(const FrozenSide&, const FrozenSide&) = default;
};

/// Join of one border edge to one side of a patch object or to a frozen side.
struct Attachment {
  ObjectId patch;  ///< ignored when frozen
  NetSide side;
  /// Whether the edge's half-edge runs against the side's direction, as it does where both surfaces have the
  /// same orientation.
  bool reversed = true;
  Continuity continuity = Continuity::g1;  ///< G0 or G1
  Adapts adapts = Adapts::surface;         ///< used with G1 only
  std::optional<FrozenSide> frozen = {};
  friend bool operator==(const Attachment&, const Attachment&) = default;
};

using Attachments = FlatMap<EdgeId, Attachment>;

}  // namespace hariko
