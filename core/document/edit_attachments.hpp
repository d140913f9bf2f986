#pragma once

// Edits of attachments: border edges of polyhedra joined to sides of patches.

#include <span>
#include <string>
#include <vector>

#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_not_a_border{"E_NOT_A_BORDER"};
inline constexpr Code e_no_side{"E_NO_SIDE"};
inline constexpr Code e_side_taken{"E_SIDE_TAKEN"};
inline constexpr Code e_attachment_cycle{"E_ATTACHMENT_CYCLE"};

/// Attaches a border edge, in place of what it was attached to. Errors: E_UNKNOWN_OBJECT, E_LOCKED,
/// E_WRONG_KIND, E_UNKNOWN_ELEMENT, E_NOT_A_BORDER, E_NO_SIDE, E_SIDE_TAKEN (another edge of the object has
/// it), E_ATTACHMENT_CYCLE (each would have to follow the other). O(objects).
Result<Document> attach_edge(const Document& document, ObjectId object, EdgeId edge,
                             const Attachment& attachment);
/// Releases edges; the vertices stay where the sides have put them. Errors: E_UNKNOWN_OBJECT, E_LOCKED,
/// E_WRONG_KIND.
Result<Document> release_edges(const Document& document, ObjectId object, std::span<const EdgeId> edges);

/// Of the edges at a vertex that take tangent planes from patches, the last one gives its patch its own
/// instead. Errors: those of `attach_edge`, E_NO_SIDE where there is no such edge.
Result<Document> let_patch_adapt(const Document& document, ObjectId object, VertexId vertex);

/// A side with its points in the object space of a polyhedron, relative to its origin, from its last point to
/// its first if `reversed`.
FrozenSide side_seen_from(const Object& polyhedron, const Object& patches, const BicubicNet& net,
                          NetSide side, bool reversed);
/// From positions in one object's source to those in another's: x -> offset + linear x. Exact where both
/// stand in the same place.
struct RelativePlace {
  Matrix3 linear = Matrix3::Identity();
  Vector3 offset = Vector3::Zero();
};
RelativePlace relative_place(const Object& from, const Object& to);

/// Whether a side exists.
bool has_side(const PatchSource& patches, NetSide side);
/// The side that an edge of a patch object's net lies on. False inside the net.
std::optional<NetSide> side_of(const PatchSource& patches, EdgeId edge);

/// The attachment to the side that lies nearest to a border edge, by the distances of the ends, among all
/// visible patch objects; G1, and the surface adapts. Nothing where there are no patches.
std::optional<Attachment> nearest_side(const Document& document, const Object& polyhedron, EdgeId edge);
/// The attachment to this side, in the direction in which the ends are nearer.
Attachment attachment_to(const Object& polyhedron, EdgeId edge, const Object& patches, NetSide side);

/// The polyhedron of an object as it is seen: with the ends of attached edges where their sides end, as far
/// as those exist. O(attachments).
Polyhedron attached_polyhedron(const Document& document, const Object& polyhedron);
/// The document with the ends of the object's attached edges stored where they are seen. The same document
/// for objects without attached edges.
Document with_seen_ends(const Document& document, ObjectId id);

/// Attachments to these objects become copies of their sides; a patch that adapted does so no more.
Source frozen_source(const Object& polyhedron, std::span<const std::shared_ptr<const Object>> gone);
/// How many edges are attached to these objects from others: they would be frozen with them.
std::size_t attached_to(const Document& document, std::span<const ObjectId> objects);

}  // namespace hariko
