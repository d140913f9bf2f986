#include "core/modeling/operations/join.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/document/edits/edit_support.hpp"
#include "core/document/edits/edits.hpp"
#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/objects/edit_modeling.hpp"
#include "core/modeling/surfacing/mirrored.hpp"

namespace hariko {
namespace {

Pin transformed(const Pin& pin, const Similarity& by) {
  Pin out = pin;
  for (Vector3& vector : out.vectors)
    vector = pin.kind == Pin::Kind::normal ? Vector3(by.rotation * vector) : by.apply_to_vector(vector);
  return out;
}

}  // namespace

Result<EditResult> join(const PolyhedronSource& base, const PolyhedronSource& added,
                        const Similarity& to_base) {
  MeshEditor draft(base);
  const Polyhedron& polyhedron = added.polyhedron;
  std::map<VertexId, VertexId> names;
  // Subtracting origins first keeps digits: their difference is small where the objects are near each other,
  // however far from zero.
  const Vector3 shift = to_base.apply(added.origin) - base.origin;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v)
    names.emplace(polyhedron.vertex_id(v),
                  draft.add_vertex(shift + to_base.apply_to_vector(polyhedron.position(v))));
  ElementSet selection;
  std::map<FaceId, double> areas;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    std::vector<VertexId> corners;
    for (const Index v : polyhedron.topology().face_vertices(f))
      corners.push_back(names.at(polyhedron.vertex_id(v)));
    const FaceId face = draft.add_face(std::move(corners));
    selection.faces.insert(face);
    if (const double* area = added.shaping->kept_area.find(polyhedron.face_id(f))) areas.emplace(face, *area);
  }
  Shaping& shaping = draft.shaping();
  const auto take_vertices = [&](const auto& from, auto& to) {
    for (const auto& [id, value] : from)
      if (names.contains(id)) to.set(names.at(id), value);
  };
  const auto take_edges = [&](const auto& from, auto& to) {
    for (const auto& [id, value] : from)
      if (names.contains(id.low) && names.contains(id.high))
        to.set(EdgeId::of(names.at(id.low), names.at(id.high)), value);
  };
  take_vertices(added.shaping->alpha, shaping.alpha);
  take_vertices(added.shaping->tag, shaping.tag);
  take_edges(added.shaping->beta, shaping.beta);
  take_edges(added.shaping->crease, shaping.crease);
  std::map<VertexId, Pin> tangents;
  for (const auto& [id, pin] : added.shaping->pin) {
    if (!names.contains(id)) continue;
    const Pin moved = transformed(pin, to_base);
    if (pin.kind == Pin::Kind::normal)
      shaping.pin.set(names.at(id), moved);
    else
      tangents.emplace(names.at(id), moved);
  }
  auto result = std::move(draft).finish();
  if (!result) return result.error();
  PolyhedronSource source = std::move(result).value();
  if (!tangents.empty() || !added.shaping->form.empty() || !areas.empty()) {
    // The draft drops tangents at new vertices and areas of new faces; here they stay valid, because the
    // edges round them are the same in the same order.
    Shaping with_tangents = *source.shaping;
    for (const auto& [id, pin] : tangents) with_tangents.pin.set(id, pin);
    for (const auto& [id, area] : areas) with_tangents.kept_area.set(id, area);
    for (const auto& [id, form] : added.shaping->form) {
      if (!names.contains(id)) continue;
      KeptForm named = form;
      for (KeptForm::Edge& edge : named.edges)
        if (names.contains(edge.to)) edge.to = names.at(edge.to);
      with_tangents.form.set(names.at(id), std::move(named));
    }
    source.shaping = std::move(with_tangents);
  }
  return EditResult{std::move(source), std::move(selection)};
}

namespace {

/// Joins what stands at the places of an object, from the place `first` on, to what is made of the base. Of
/// places that mirror, the source is reflected first, so that faces stay oriented outward.
Result<Done> join_places(EditResult& all, const Object& base, const Object& object,
                         const PolyhedronSource& source, std::size_t first) {
  const std::vector<Similarity> places = places_of(object);
  PolyhedronSource image = source;
  if (std::ranges::any_of(places, &Similarity::mirrors)) image = mirror_object(source, Axis::x).source;
  const Similarity back = base.transform.inverse();
  for (std::size_t k = first; k < places.size(); ++k) {
    const Similarity place = composed(back, places[k]);
    Result<EditResult> next = place.mirrors() ? join(all.source, image, place_of_reflected(place, 0))
                                              : join(all.source, source, place);
    if (!next) return next.error();
    all = std::move(next).value();
  }
  return Done{};
}

}  // namespace

Result<Document> join_objects(const Document& document, std::span<const ObjectId> objects) {
  std::vector<ObjectId> others;
  for (const ObjectId id : objects)
    if (id != objects[0] && std::find(others.begin(), others.end(), id) == others.end()) others.push_back(id);
  if (others.empty())
    return make_error(e_wrong_selection, "There are no two objects to join.", "Select two or more objects.");
  const Object* base = document.find(objects[0]);
  Result<ModeledDocument> joined =
      edit_polyhedron(document, objects[0], [&](const PolyhedronSource& source) -> Result<EditResult> {
        Result<PolyhedronSource> whole = baked(source);
        if (!whole) return whole.error();
        EditResult all{*whole, {}};
        if (auto repeated = join_places(all, *base, *base, *whole, 1); !repeated) return repeated.error();
        for (const ObjectId id : others) {
          const Object* object = document.find(id);
          if (!object) return detail::unknown_object(id);
          const PolyhedronSource* added = object->polyhedron();
          if (!added)
            return make_error(e_wrong_kind, "The object \"" + object->name + "\" is not a polyhedron.",
                              "Select polyhedra only.", element_of(id));
          const Result<PolyhedronSource> added_whole = baked(*added);
          if (!added_whole) return added_whole.error();
          if (auto joined_all = join_places(all, *base, *object, *added_whole, 0); !joined_all)
            return joined_all.error();
        }
        return all;
      });
  if (!joined) return joined.error();
  const auto once = set_copies(joined->document, objects[0], {});
  return once ? delete_objects(*once, others) : once;
}

}  // namespace hariko
