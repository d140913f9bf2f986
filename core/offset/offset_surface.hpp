#pragma once

// Offset surfaces and shells: a surface at a distance, and a closed body with a thickness, both as Surfaces.

#include <array>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/result.hpp"
#include "core/base/text/enum_words.hpp"
#include "core/offset/offset_folds.hpp"

namespace hariko {

inline constexpr Code e_offset_distance{"E_OFFSET_DISTANCE"};  ///< not a number, or no thickness
inline constexpr Code e_offset_nothing{"E_OFFSET_NOTHING"};    ///< a surface without patches
inline constexpr Code e_offset_edge{"E_OFFSET_EDGE"};          ///< a sharp edge without a way round it
inline constexpr Code w_offset_folds{"W_OFFSET_FOLDS"};        ///< the offset runs back into itself
inline constexpr Code w_offset_crosses{"W_OFFSET_CROSSES"};    ///< it crosses itself along sharp edges
inline constexpr Code w_offset_gaps{"W_OFFSET_GAPS"};          ///< places that are left open
inline constexpr Code w_offset_tips{"W_OFFSET_TIPS"};          ///< sharp tips, which have no normal

/// Side of the surface on which a wall gets its thickness.
enum class WallSide : std::uint8_t { inside, outside, both };
template <>
inline constexpr auto enum_words<WallSide> = all_words<WallSide>({{WallSide::inside, "inside"},
                                                                  {WallSide::outside, "outside"},
                                                                  {WallSide::both, "both"}});

/// Wall along a surface: `offset` moves the surface along its outward normals, `thickness` makes it a closed
/// body. Lengths in the surface's unit.
struct Wall {
  double offset = 0;     ///< any sign
  double thickness = 0;  ///< 0: a surface, otherwise a body
  WallSide side = WallSide::inside;

  /// Whether the surface stays what it is.
  bool none() const { return offset == 0 && thickness == 0; }
  friend bool operator==(const Wall&, const Wall&) = default;
};

/// Offset surface or shell. Its first patches are those of the surface, in their order.
struct OffsetSurface {
  Surface surface;
  std::vector<OffsetFolds> folds;  ///< folds of the offset, or of the outer and the inner one
  std::size_t sharp_edges = 0;     ///< closed by parts of tubes round them
  std::size_t crossings = 0;       ///< sharp edges on whose narrow side the offsets cross
  std::size_t gaps = 0;            ///< ends of strips that could not be joined
  std::size_t tips = 0;            ///< sides shrunk to a point whose normals differ there
  std::vector<Message> warnings;
};

/// Offset or shell that a wall describes; lengths divided by `scale` are those of the surface.
/// Without a thickness: the surface at a distance, p + d n. Sharp edges are joined by parts of tubes round
/// them and their corners by parts of spheres, so that on the wide side every point has exactly the distance.
/// On the narrow side these cross the surface, and beyond a radius of curvature the surface folds; neither is
/// trimmed but told.
/// With a thickness: the body between two such offsets, with ruled strips along the surface's border. Closed
/// and oriented where the surface has seams or borders everywhere and there are no gaps.
/// Errors: E_OFFSET_DISTANCE (not finite, or a negative thickness), E_OFFSET_NOTHING, E_OFFSET_EDGE where two
/// patches meet back to back, E_CANCELLED. O(patches).
Result<OffsetSurface> wall_surface(const Surface& surface, const Wall& wall, double scale = 1,
                                   const CancelToken& cancel = {});

}  // namespace hariko
