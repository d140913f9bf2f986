#include "core/document/edits/edit_elements.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "core/base/index_list.hpp"
#include "core/document/edits/edge_set.hpp"
#include "core/document/edits/edit_support.hpp"
#include "core/network/network.hpp"

namespace hariko {
namespace {

/// Calls change(PolyhedronSource&) -> Result<Done> on a copy of the object's polyhedron.
template <class Change>
Result<Document> change_polyhedron(const Document& document, ObjectId id, Change&& change) {
  return detail::change_object(document, id, true, [&](Object& object) -> Result<Done> {
    auto* source = std::get_if<PolyhedronSource>(&object.source);
    if (!source)
      return make_error(e_wrong_kind, "The object \"" + object.name + "\" is not a polyhedron.",
                        "Select a polyhedron.", element_of(id));
    return change(*source);
  });
}

Message unknown_element(const Element& element) {
  return make_error(e_unknown_element, "The object has no such element.", "Select it again.", element);
}

Result<Done> check_elements(const Polyhedron& polyhedron, std::span<const VertexId> ids) {
  for (const VertexId id : ids)
    if (polyhedron.find(id) == no_index) return unknown_element(element_of(id));
  return Done{};
}

Result<Done> check_elements(const Polyhedron& polyhedron, std::span<const EdgeId> ids) {
  if (ids.size() <= 8) {
    for (const EdgeId id : ids)
      if (polyhedron.find(id) == no_index) return unknown_element(element_of(id));
    return Done{};
  }
  const detail::EdgeSet edges(polyhedron);
  for (const EdgeId id : ids)
    if (!edges.contains(id)) return unknown_element(element_of(id));
  return Done{};
}

/// Map with `value` at all ids, or without entries there when there is no value. One merge, O(n log n) in the
/// ids: setting one after the other would be quadratic.
template <class Id, class Value>
FlatMap<Id, Value> with_entries(const FlatMap<Id, Value>& map, std::span<const Id> ids,
                                const std::optional<Value>& value) {
  std::vector<Id> sorted(ids.begin(), ids.end());
  sort_unique(sorted);
  FlatMap<Id, Value> result;
  auto next = sorted.begin();
  const auto add_before = [&](const Id* limit) {
    for (; next != sorted.end() && (!limit || *next < *limit); ++next)
      if (value) result.set(*next, *value);
  };
  for (const auto& [id, old] : map) {
    add_before(&id);
    if (next == sorted.end() || *next != id) result.set(id, old);
  }
  add_before(nullptr);
  return result;
}

/// Faces with a corner at one of the vertices; may contain duplicates.
std::vector<FaceId> faces_round(const Polyhedron& polyhedron, std::span<const VertexId> vertices) {
  std::vector<FaceId> out;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  for (const VertexId id : vertices)
    for (const Index h : mesh.fan_corners(polyhedron.find(id)))
      out.push_back(polyhedron.face_id(mesh.face(h)));
  return out;
}

/// Common implementation of all settings of elements: checks, copies the shaping, changes one of its maps.
template <class Id, class Value>
Result<Document> set_shaping(const Document& document, ObjectId object, std::span<const Id> ids,
                             FlatMap<Id, Value> Shaping::*member, const Value& value, const Value& by_default,
                             const Result<Done>& value_check = Done{}) {
  return change_polyhedron(document, object, [&](PolyhedronSource& source) -> Result<Done> {
    if (!value_check) return value_check.error();
    if (const auto checked = check_elements(source.polyhedron, ids); !checked) return checked.error();
    Shaping shaping = *source.shaping;
    const std::optional<Value> entry = value == by_default ? std::nullopt : std::optional<Value>(value);
    shaping.*member = with_entries(shaping.*member, ids, entry);
    source.shaping = std::move(shaping);
    return Done{};
  });
}

/// Sets one value per id; of repeated ids the last wins.
template <class Id>
Result<Document> set_tensions(const Document& document, ObjectId object, std::span<const Id> ids,
                              std::span<const double> values, FlatMap<Id, double> Shaping::*member,
                              double by_default, Result<Done> (*check)(double)) {
  HARIKO_ASSERT(ids.size() == values.size(), "one value an element");
  return change_polyhedron(document, object, [&](PolyhedronSource& source) -> Result<Done> {
    for (const double value : values)
      if (const auto checked = check(value); !checked) return checked.error();
    if (const auto checked = check_elements(source.polyhedron, ids); !checked) return checked.error();
    std::map<Id, double> changed;
    for (std::size_t i = 0; i < ids.size(); ++i) changed[ids[i]] = values[i];
    Shaping shaping = *source.shaping;
    FlatMap<Id, double> result;
    auto next = changed.begin();
    const auto add = [&](const Id& id, double value) {
      if (value != by_default) result.set(id, value);
    };
    for (const auto& [id, old] : shaping.*member) {
      for (; next != changed.end() && !(id < next->first); ++next) add(next->first, next->second);
      if (!changed.contains(id)) result.set(id, old);
    }
    for (; next != changed.end(); ++next) add(next->first, next->second);
    shaping.*member = std::move(result);
    source.shaping = std::move(shaping);
    return Done{};
  });
}

Result<Done> check_tension(double value, double low, double high, const char* range) {
  if (!std::isfinite(value))
    return make_error(e_tension_nonfinite, "The tension is not a finite number.",
                      std::string("Use ") + range + ".");
  if (value < 0)
    return make_error(e_tension_negative, "The tension is negative.", std::string("Use ") + range + ".");
  if (value < low || value > high)
    return make_error(e_tension_range, "The tension is out of range.", std::string("Use ") + range + ".");
  return Done{};
}

/// Moves vertices of a mirror's seam back into its plane.
Result<Polyhedron> seam_kept_in_plane(const PolyhedronSource& before, const Polyhedron& moved,
                                      std::span<const Index> vertices) {
  const std::vector<char> seam = mirror_seam(before.polyhedron, before.origin, *before.mirror);
  const Eigen::Index axis = index_of(before.mirror->axis);
  std::vector<Index> clipped;
  std::vector<Vector3> positions;
  for (const Index v : vertices) {
    if (!seam[v]) continue;
    clipped.push_back(v);
    positions.push_back(moved.position(v));
    positions.back()[axis] = 0 - before.origin[axis];
  }
  return moved.with_positions(clipped, positions);
}

Result<Document> move_control_points(const Document& document, ObjectId object,
                                     std::span<const VertexId> points, std::span<const Vector3> positions) {
  return detail::change_object(document, object, true, [&](Object& changed) -> Result<Done> {
    auto& source = std::get<PatchSource>(changed.source);
    if (const auto checked = check_elements(source.net, points); !checked) return checked.error();
    std::vector<Index> indices;
    for (const VertexId id : points) indices.push_back(source.net.find(id));
    Result<Polyhedron> moved = source.net.with_positions(indices, positions);
    if (!moved) return moved.error();
    source.net = *std::move(moved);
    return Done{};
  });
}

}  // namespace

Result<Document> move_vertices(const Document& document, ObjectId object, std::span<const VertexId> vertices,
                               std::span<const Vector3> positions) {
  HARIKO_ASSERT(vertices.size() == positions.size(), "one position a vertex");
  if (const Object* found = document.find(object); found && found->patches())
    return move_control_points(document, object, vertices, positions);
  return change_polyhedron(document, object, [&](PolyhedronSource& source) -> Result<Done> {
    if (const auto checked = check_elements(source.polyhedron, vertices); !checked) return checked.error();
    std::vector<Index> indices;
    indices.reserve(vertices.size());
    for (const VertexId id : vertices) indices.push_back(source.polyhedron.find(id));
    Result<Polyhedron> moved = source.polyhedron.with_positions(indices, positions);
    if (moved && source.mirror) moved = seam_kept_in_plane(source, *moved, indices);
    if (!moved) return moved.error();
    source.polyhedron = *std::move(moved);
    return Done{};
  });
}

Result<Document> set_alpha(const Document& document, ObjectId object, std::span<const VertexId> vertices,
                           double alpha) {
  return set_shaping(document, object, vertices, &Shaping::alpha, alpha, 0.0, check_alpha(alpha));
}

Result<Document> set_beta(const Document& document, ObjectId object, std::span<const EdgeId> edges,
                          double beta) {
  return set_shaping(document, object, edges, &Shaping::beta, beta, 1.0, check_beta(beta));
}

Result<Document> set_alphas(const Document& document, ObjectId object, std::span<const VertexId> vertices,
                            std::span<const double> alphas) {
  return set_tensions(document, object, vertices, alphas, &Shaping::alpha, 0.0, &check_alpha);
}

Result<Document> set_betas(const Document& document, ObjectId object, std::span<const EdgeId> edges,
                           std::span<const double> betas) {
  return set_tensions(document, object, edges, betas, &Shaping::beta, 1.0, &check_beta);
}

Result<Document> set_crease(const Document& document, ObjectId object, std::span<const EdgeId> edges,
                            bool crease) {
  return set_shaping(document, object, edges, &Shaping::crease, crease, false);
}

Result<Document> set_vertex_tag(const Document& document, ObjectId object, std::span<const VertexId> vertices,
                                VertexTag tag) {
  return set_shaping(document, object, vertices, &Shaping::tag, tag, VertexTag::automatic);
}

Result<Document> clear_pins(const Document& document, ObjectId object, std::span<const VertexId> vertices) {
  return change_polyhedron(document, object, [&](PolyhedronSource& source) -> Result<Done> {
    if (const auto checked = check_elements(source.polyhedron, vertices); !checked) return checked.error();
    Shaping shaping = *source.shaping;
    shaping.pin = with_entries<VertexId, Pin>(shaping.pin, vertices, std::nullopt);
    shaping.form = with_entries<VertexId, KeptForm>(shaping.form, vertices, std::nullopt);
    shaping.kept_area = with_entries<FaceId, double>(shaping.kept_area,
                                                     faces_round(source.polyhedron, vertices), std::nullopt);
    source.shaping = std::move(shaping);
    return Done{};
  });
}

Result<Document> set_mirror(const Document& document, ObjectId object, const std::optional<Mirror>& mirror) {
  return change_polyhedron(document, object, [&](PolyhedronSource& source) -> Result<Done> {
    if (mirror)
      if (const auto checked = check_mirror(*mirror); !checked) return checked.error();
    source.mirror = mirror;
    return Done{};
  });
}

Result<Document> set_preparation(const Document& document, ObjectId object, const Preparation& preparation) {
  return change_polyhedron(document, object, [&](PolyhedronSource& source) -> Result<Done> {
    if (const auto checked = check_preparation(preparation); !checked) return checked.error();
    source.preparation = preparation;
    return Done{};
  });
}

Result<Document> set_mode(const Document& document, ObjectId object, Mode mode) {
  return change_polyhedron(document, object, [&](PolyhedronSource& source) -> Result<Done> {
    source.mode = mode;
    return Done{};
  });
}

Result<Document> set_frames(const Document& document, ObjectId id, Frames frames) {
  return detail::change_object(document, id, true, [&](Object& object) -> Result<Done> {
    if (auto* polyhedron = std::get_if<PolyhedronSource>(&object.source))
      polyhedron->frames = frames;
    else if (auto* outline = std::get_if<OutlineSource>(&object.source))
      outline->settings.frames = frames;
    else
      return make_error(e_wrong_kind, "The object \"" + object.name + "\" is no polyhedron and no outline.",
                        "Select a polyhedron or an outline.", element_of(id));
    return Done{};
  });
}

Result<Done> check_alpha(double alpha) {
  return check_tension(alpha, 0, max_alpha, "a number from 0 to 1000");
}

Result<Done> check_beta(double beta) {
  return check_tension(beta, min_beta, max_beta, "a number from 0.001 to 1000");
}

Result<Done> check_pin(const Pin& pin) {
  const auto invalid = [](const char* text) {
    return make_error(e_pin_invalid, text, "Give a normal that is not zero, or the tangent vectors.");
  };
  if (pin.vectors.empty()) return invalid("The pin has no vectors.");
  if (pin.vectors.size() > max_pin_vectors) return invalid("The pin has too many vectors.");
  for (const Vector3& vector : pin.vectors)
    if (!vector.allFinite()) return invalid("The pin has a vector that is not finite.");
  if (pin.kind == Pin::Kind::normal && (pin.vectors.size() != 1 || pin.vectors[0].cwiseAbs().maxCoeff() == 0))
    return invalid("The pin's normal must be one vector that is not zero.");
  return Done{};
}

Result<Done> check_kept_area(double factor) {
  if (!(factor >= 1 / max_kept_area && factor <= max_kept_area))
    return make_error(e_form_invalid, "The kept area of a face is out of all proportion.",
                      "Use factors from 0.000001 to 1000000.");
  return Done{};
}

Result<Done> check_form(const KeptForm& form) {
  for (const KeptForm::Edge& edge : form.edges) {
    const double largest = std::max({std::abs(edge.turn), std::abs(edge.stretch),
                                     edge.offset.cwiseAbs().maxCoeff(), std::abs(edge.lean), edge.side});
    if (!(largest <= max_form_number && edge.side >= 0))
      return make_error(e_form_invalid,
                        "The kept form of a vertex has a number that is out of all proportion.",
                        "Use numbers from -100 to 100, and parts of sides from 0 on.");
  }
  return Done{};
}

}  // namespace hariko
