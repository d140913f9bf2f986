#pragma once

// Edits of the elements of one polyhedron object: positions, tensions, creases, tags, pins, mode.
//
// Errors of all functions: E_UNKNOWN_OBJECT, E_LOCKED and E_WRONG_KIND (the object is not a polyhedron); of
// those that take ids: E_UNKNOWN_ELEMENT. Settings at their default value are not stored.

#include <optional>
#include <span>

#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_unknown_element{"E_UNKNOWN_ELEMENT"};
inline constexpr Code e_wrong_kind{"E_WRONG_KIND"};
inline constexpr Code e_tension_range{"E_TENSION_RANGE"};
inline constexpr Code e_pin_invalid{"E_PIN_INVALID"};
inline constexpr Code e_form_invalid{"E_FORM_INVALID"};

inline constexpr double max_alpha = 1000;
inline constexpr double min_beta = 0.001, max_beta = 1000;
/// Largest number of vectors of a pin in a file; only the network knows how many tangents a vertex has.
inline constexpr std::size_t max_pin_vectors = 1000;
/// Largest absolute value of turns, logarithms and fractions in kept forms, far beyond what any surface
/// needs.
inline constexpr double max_form_number = 100;
inline constexpr double max_kept_area = 1e6;  ///< the smallest value is its reciprocal

/// Moves vertices to positions[i], relative to the source's origin like all positions of the polyhedron (not
/// a displacement). Both spans have the same size; of repeated ids the last wins. Errors: E_NONFINITE. Copies
/// 128 positions for each run of moved vertices. Vertices of the seam of a live mirror stay in its plane. In
/// a patch object, moves control points.
Result<Document> move_vertices(const Document& document, ObjectId object, std::span<const VertexId> vertices,
                               std::span<const Vector3> positions);

/// Sets vertex tension, 0 .. 1000. Errors: E_TENSION_NEGATIVE, E_TENSION_NONFINITE, E_TENSION_RANGE.
Result<Document> set_alpha(const Document& document, ObjectId object, std::span<const VertexId> vertices,
                           double alpha);

/// Sets edge tension, 0.001 .. 1000. Errors as for `set_alpha`.
Result<Document> set_beta(const Document& document, ObjectId object, std::span<const EdgeId> edges,
                          double beta);

/// Sets one tension per element; both spans have the same size. Errors as for `set_alpha`. O(n log n).
Result<Document> set_alphas(const Document& document, ObjectId object, std::span<const VertexId> vertices,
                            std::span<const double> alphas);
Result<Document> set_betas(const Document& document, ObjectId object, std::span<const EdgeId> edges,
                           std::span<const double> betas);

/// Makes edges sharp, or smooth again.
Result<Document> set_crease(const Document& document, ObjectId object, std::span<const EdgeId> edges,
                            bool crease);

/// Sets the tag of vertices.
Result<Document> set_vertex_tag(const Document& document, ObjectId object, std::span<const VertexId> vertices,
                                VertexTag tag);

/// Removes pins, kept forms, and kept areas of the faces round the vertices.
Result<Document> clear_pins(const Document& document, ObjectId object, std::span<const VertexId> vertices);

/// Sets the surface mode.
Result<Document> set_mode(const Document& document, ObjectId object, Mode mode);
/// Sets whether angles and lengths of the polyhedron enter the vertex frames (modes TARGET, FAIR and G2), for
/// polyhedra and for outlines, where it is the polyhedron of the control points. Errors: E_UNKNOWN_OBJECT,
/// E_LOCKED, E_WRONG_KIND.
Result<Document> set_frames(const Document& document, ObjectId object, Frames frames);
/// Sets the preparation. Errors: E_AUTOMATIC_TENSION_RANGE.
Result<Document> set_preparation(const Document& document, ObjectId object, const Preparation& preparation);

/// Adds, changes or removes a live mirror; the half stays as it is. Errors: E_MIRROR_INVALID.
Result<Document> set_mirror(const Document& document, ObjectId object, const std::optional<Mirror>& mirror);

/// Checks of the edits above, for values read from files.
Result<Done> check_alpha(double alpha);
Result<Done> check_beta(double beta);
/// Checks a pin. E_PIN_INVALID: vectors missing, too many, not finite, or a zero normal. Only the network
/// knows whether the number of tangents fits the vertex: E_PIN_MISMATCH on rebuild.
Result<Done> check_pin(const Pin& pin);
/// Checks a kept form. E_FORM_INVALID: a number that is not finite or above `max_form_number`.
Result<Done> check_form(const KeptForm& form);
/// Checks a kept area. E_FORM_INVALID: not between 1 / max_kept_area and max_kept_area.
Result<Done> check_kept_area(double factor);

}  // namespace hariko
