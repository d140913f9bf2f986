#pragma once

// Curves of objects along which others are placed: chains of edges, paths of skins, loops of outlines.

#include <optional>
#include <span>
#include <vector>

#include "core/document/document.hpp"
#include "core/geometry/arc_length_curve.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

inline constexpr Code e_edge_chain{"E_EDGE_CHAIN"};
inline constexpr Code e_unfinished_curve{"E_UNFINISHED_CURVE"};

/// Curve in the document's space.
struct ObjectCurve {
  std::vector<CurvePiece> pieces;
  bool closed = false;
};

/// Curve of edges that follow each other without branches, open or closed, of an object with a cage
/// (asserted). With a surface, which is that of the object, along its curves over the edges; edges without
/// one, and all without a surface, are straight. It begins at the end with the lower vertex id; a closed one
/// at the lowest, towards the lower of both neighbours. Error: E_EDGE_CHAIN (none, one that the cage does not
/// have, branches, or several chains). O(n log n), with a surface O(seams log seams).
Result<ObjectCurve> curve_of_edges(const Object& object, std::span<const EdgeId> edges,
                                   const Surface* surface);

/// The path of a skin (asserted), as it was drawn. Error: E_UNFINISHED_CURVE (fewer than two points).
Result<ObjectCurve> curve_of_path(const Object& object);

/// A loop of an outline (asserted, and so is the loop), which is smooth where it turns by less than 30
/// degrees at a point (`SampledCurve`). Error: E_UNFINISHED_CURVE (fewer than three points).
Result<ObjectCurve> curve_of_loop(const Object& object, std::size_t loop);

/// Number of curves that an object was drawn as: the path of a skin, or the loops of an outline. Nothing for
/// other objects.
std::optional<std::size_t> drawn_curve_count(const Object& object);

/// The drawn curve to which a point of the object belongs, by its id in selections; nothing for points that
/// it does not have.
std::optional<std::size_t> drawn_curve_at(const Object& object, VertexId point);

/// A drawn curve (asserted: below their number). Errors: those of `curve_of_path` and `curve_of_loop`.
Result<ObjectCurve> drawn_curve_of(const Object& object, std::size_t number);

}  // namespace hariko
