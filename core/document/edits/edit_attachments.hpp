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

/// Attaches a border edge, replacing its previous attachment. Errors: E_UNKNOWN_OBJECT, E_LOCKED,
/// E_WRONG_KIND, E_UNKNOWN_ELEMENT, E_NOT_A_BORDER, E_NO_SIDE, E_SIDE_TAKEN (another edge of the object is
/// attached to the side), E_ATTACHMENT_CYCLE (each object would have to follow the other). O(objects).
Result<Document> attach_edge(const Document& document, ObjectId object, EdgeId edge,
                             const Attachment& attachment);
/// Releases edges; the vertices stay where the sides have put them. Errors: E_UNKNOWN_OBJECT, E_LOCKED,
/// E_WRONG_KIND.
Result<Document> release_edges(const Document& document, ObjectId object, std::span<const EdgeId> edges);

/// Lets a patch adapt at a vertex: of the edges there that take tangent planes from patches, the last one
/// imposes its own tangent planes on its patch instead. Errors: those of `attach_edge`, E_NO_SIDE where there
/// is no such edge.
Result<Document> let_patch_adapt(const Document& document, ObjectId object, VertexId vertex);

/// Side with its points in the object space of a polyhedron, relative to its origin, from its last point to
/// its first if `reversed`.
FrozenSide side_seen_from(const Object& polyhedron, const Object& patches, const BicubicNet& net,
                          NetSide side, bool reversed);
/// Map from positions in one object's source to those in another's: x -> offset + linear x. Exact where both
/// objects have the same placement.
struct RelativePlace {
  Matrix3 linear = Matrix3::Identity();
  Vector3 offset = Vector3::Zero();
};
/// Map from `from`'s cage positions to `to`'s.
RelativePlace relative_place(const Object& from, const Object& to);

/// Whether a side exists.
bool has_side(const PatchSource& patches, NetSide side);
/// Side that an edge of a patch object's net lies on; nothing inside the net.
std::optional<NetSide> side_of(const PatchSource& patches, EdgeId edge);

/// Attachment to the side nearest to a border edge, by the distances of the ends, among all visible patch
/// objects; G1, and the surface adapts. Nothing where there are no patches.
std::optional<Attachment> nearest_side(const Document& document, const Object& polyhedron, EdgeId edge);
/// Attachment to this side, in the direction in which the ends are nearer.
Attachment attachment_to(const Object& polyhedron, EdgeId edge, const Object& patches, NetSide side);

/// Polyhedron of an object as displayed: the ends of attached edges lie at the ends of their sides, as far as
/// those exist. O(attachments).
Polyhedron attached_polyhedron(const Document& document, const Object& polyhedron);
/// Returns the document with the displayed positions of the ends of attached edges stored in the object. The
/// same document for objects without attached edges.
Document with_seen_ends(const Document& document, ObjectId id);

/// Replaces attachments to these objects by copies of their sides; a patch that adapted no longer does.
Source frozen_source(const Object& polyhedron, std::span<const std::shared_ptr<const Object>> gone);
/// Number of edges of other objects that are attached to these objects and would be frozen when they are
/// deleted.
std::size_t attached_to(const Document& document, std::span<const ObjectId> objects);

}  // namespace hariko
