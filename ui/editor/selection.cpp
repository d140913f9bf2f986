#include "ui/editor/selection.hpp"

#include <algorithm>

#include "core/document/edit_solids.hpp"
#include "core/modeling/select_convert.hpp"
#include "core/modeling/select_region.hpp"
#include "ui/base/language.hpp"
#include "ui/editor/skin_view.hpp"

namespace hariko {

namespace {

template <class Id>
void change(std::set<Id>& set, Id id, bool present) {
  if (present)
    set.insert(id);
  else
    set.erase(id);
}

template <class Id>
void keep_existing(std::set<Id>& set, const Polyhedron& polyhedron) {
  std::erase_if(set, [&](const Id& id) { return polyhedron.find(id) == no_index; });
}

/// Of a skin points of sections can be selected, and those of the path, which have the highest numbers.
void keep_existing(ElementSelection& elements, const Skin& skin) {
  std::erase_if(elements.vertices, [&](VertexId id) {
    return !is_path_point(id.value) &&
           std::none_of(skin.sections.begin(), skin.sections.end(),
                        [&](const SkinSection& section) { return find_point(section, id.value) >= 0; });
  });
  elements.edges.clear();
  elements.faces.clear();
}

/// Solids are selected as vertices with their ids.
void keep_solids(ElementSelection& selection, const Object& object) {
  std::erase_if(selection.vertices, [&](VertexId id) { return !find_solid(object, id.value); });
  selection.edges.clear();
  selection.faces.clear();
}
ElementSelection all_solids(const Object& object) {
  ElementSelection all;
  for (const Solid& solid : object.solids()->input->solids) all.vertices.insert(VertexId{solid.id});
  return all;
}

/// The points of an outline are vertices whose ids are their numbers.
ElementSelection all_points(const OutlineSource& source) {
  ElementSelection out;
  for (Index i = 0; i < source.outline->point_count(); ++i)
    out.vertices.insert(out.vertices.end(), VertexId{i});
  return out;
}

/// The points of all sections and those of the path and of the second rail.
ElementSelection all_points(const Skin& skin) {
  ElementSelection out;
  for (const SkinSection& section : skin.sections)
    for (const SectionPoint& point : section.points) out.vertices.insert(VertexId{point.id});
  const auto add_path = [&](const SubdivisionCurve& path, std::uint32_t ids) {
    for (int i = 0; i < path.size(); ++i) out.vertices.insert(VertexId{ids + std::uint32_t(i)});
  };
  add_path(skin.path, path_point_ids);
  if (skin.second_rail) add_path(*skin.second_rail, rail_point_ids);
  return out;
}

void keep_points(ElementSelection& selection, const OutlineSource& source) {
  const std::size_t count = source.outline->point_count();
  std::erase_if(selection.vertices, [&](VertexId id) { return id.value >= count; });
  selection.edges.clear();
  selection.faces.clear();
}

void append_count(std::string& text, std::size_t count, const char* one, const std::string& many) {
  if (count == 0) return;
  if (!text.empty()) text += ", ";
  text += count == 1 ? std::string(one) : fill(many, {std::to_string(count)});
}

}  // namespace

const ElementSelection& Selection::of(ObjectId object) const {
  static const ElementSelection nothing;
  const auto it = elements_.find(object);
  return it == elements_.end() ? nothing : it->second;
}

ElementKind kind_of(ElementMode mode) {
  return mode == ElementMode::edge   ? ElementKind::edge
         : mode == ElementMode::face ? ElementKind::face
                                     : ElementKind::vertex;
}

bool Selection::contains(const ElementRef& ref) const {
  const ElementSelection& selection = of(ref.object);
  const auto id = static_cast<std::uint32_t>(ref.element.id);
  switch (ref.element.kind) {
    case Element::Kind::vertex:
      return selection.vertices.contains(VertexId{id});
    case Element::Kind::edge:
      return selection.edges.contains(EdgeId::from_packed(ref.element.id));
    case Element::Kind::face:
      return selection.faces.contains(FaceId{id});
    case Element::Kind::object:
      return objects_.contains(ref.object);
    default:
      return false;
  }
}

void Selection::select(const ElementRef& ref, How how) {
  const auto id = static_cast<std::uint32_t>(ref.element.id);
  ElementSelection one;
  switch (ref.element.kind) {
    case Element::Kind::vertex:
      one.vertices.insert(VertexId{id});
      break;
    case Element::Kind::edge:
      one.edges.insert(EdgeId::from_packed(ref.element.id));
      break;
    case Element::Kind::face:
      one.faces.insert(FaceId{id});
      break;
    case Element::Kind::object:
      if (how == How::replace) objects_.clear();
      change(objects_, ref.object, how != How::remove);
      break;
    default:
      break;
  }
  if (ref.element.kind != Element::Kind::object) {
    const bool begins = how == How::replace || (how == How::add && elements_.empty());
    select(ref.object, one, how);
    if (begins) first = ref;
  }
  active = ref.object;
  if (how != How::remove) last = ref;
}

void Selection::select(ObjectId object, const ElementSelection& elements, How how) {
  if (how == How::replace) elements_.clear();
  ElementSelection selection = of(object);
  const bool present = how != How::remove;
  for (const VertexId id : elements.vertices) change(selection.vertices, id, present);
  for (const EdgeId& id : elements.edges) change(selection.edges, id, present);
  for (const FaceId id : elements.faces) change(selection.faces, id, present);
  set(object, std::move(selection));
}

void Selection::set(ObjectId object, ElementSelection elements) {
  if (elements.empty())
    elements_.erase(object);
  else
    elements_[object] = std::move(elements);
  if (first && !contains(*first)) first.reset();
}

void Selection::select_all(const Object& object, ElementMode mode) {
  active = object.id;
  const Polyhedron* cage = object.cage();
  clear_elements();
  if (mode == ElementMode::object)
    objects_.insert(object.id);
  else if (object.outline() && mode == ElementMode::vertex)
    set(object.id, all_points(*object.outline()));
  else if (cage)
    set(object.id, hariko::select_all(*cage, kind_of(mode)));
  else if (object.solids())
    set(object.id, all_solids(object));
  else if (object.skin())
    set(object.id, all_points(*object.skin()->skin));
}

void Selection::prune(const Document& document) {
  for (auto it = elements_.begin(); it != elements_.end();) {
    const Object* object = document.find(it->first);
    // Hidden and locked objects are not selected.
    if (object && (!object->visible || object->locked)) object = nullptr;
    const Polyhedron* cage = object ? object->cage() : nullptr;
    if (cage) {
      keep_existing(it->second.vertices, *cage);
      keep_existing(it->second.edges, *cage);
      keep_existing(it->second.faces, *cage);
    } else if (object && object->solids()) {
      keep_solids(it->second, *object);
    } else if (object && object->outline()) {
      keep_points(it->second, *object->outline());
    } else if (object && object->skin()) {
      keep_existing(it->second, *object->skin()->skin);
    } else {
      it->second = {};
    }
    it = it->second.empty() ? elements_.erase(it) : std::next(it);
  }
  std::erase_if(objects_, [&](ObjectId id) {
    const Object* object = document.find(id);
    return !object || !object->visible || object->locked;
  });
  if (last && !document.find(last->object)) last.reset();
  if (first && !contains(*first)) first.reset();
  if (!document.find(active)) active = document.objects.empty() ? ObjectId{} : document.objects.back()->id;
}

Selection converted(const Selection& selection, const Document& document, ElementMode from, ElementMode to) {
  Selection result = selection;
  if (from == to) return result;
  if (to == ElementMode::object) {
    result.clear_objects();
    for (const auto& entry : selection.elements())
      result.select({entry.first, element_of(entry.first)}, Selection::How::add);
    return result;
  }
  result.clear_elements();
  if (from == ElementMode::object) {
    for (const ObjectId id : selection.objects())
      if (const Object* object = document.find(id); object && object->cage())
        result.set(id, select_all(*object->cage(), kind_of(to)));
      else if (object && object->solids())
        result.set(id, all_solids(*object));
      else if (object && object->outline() && to == ElementMode::vertex)
        result.set(id, all_points(*object->outline()));
      else if (object && object->skin() && to == ElementMode::vertex)
        result.set(id, all_points(*object->skin()->skin));
    return result;
  }
  for (const auto& [id, elements] : selection.elements()) {
    const Object* object = document.find(id);
    if (object && object->solids()) result.set(id, elements);
    if (!object || !object->cage()) continue;
    const Polyhedron& polyhedron = *object->cage();
    // Of corners, what they enclose; of larger elements, what they touch.
    const Reach reach = from < to ? Reach::inside : Reach::touching;
    result.set(id, to == ElementMode::vertex ? to_vertices(polyhedron, elements)
                   : to == ElementMode::edge ? to_edges(polyhedron, elements, reach)
                                             : to_faces(polyhedron, elements, reach));
  }
  return result;
}

void change_elements(
    Selection& selection, const Document& document,
    const std::function<ElementSelection(const PolyhedronSource&, const ElementSelection&)>& change) {
  const auto before = selection.elements();
  for (const auto& [id, elements] : before) {
    const Object* object = document.find(id);
    if (object && object->polyhedron()) selection.set(id, change(*object->polyhedron(), elements));
  }
}

Highlights highlights_of(const ElementSelection& selection, const Polyhedron& polyhedron) {
  Highlights highlights;
  const auto add = [&](std::vector<Index>& to, auto id) {
    const Index index = polyhedron.find(id);
    if (index != no_index) to.push_back(index);
  };
  for (const VertexId id : selection.vertices) add(highlights.vertices, id);
  for (const EdgeId id : selection.edges) add(highlights.edges, id);
  for (const FaceId id : selection.faces) add(highlights.faces, id);
  return highlights;
}

std::vector<VertexId> touched_vertices(const ElementSelection& selection, const Polyhedron& polyhedron) {
  std::set<VertexId> vertices = selection.vertices;
  for (const EdgeId& edge : selection.edges) vertices.insert({edge.low, edge.high});
  for (const FaceId id : selection.faces) {
    const Index face = polyhedron.find(id);
    if (face == no_index) continue;
    for (const Index v : polyhedron.topology().face_vertices(face)) vertices.insert(polyhedron.vertex_id(v));
  }
  keep_existing(vertices, polyhedron);
  return {vertices.begin(), vertices.end()};
}

std::string describe(const ElementSelection& selection) {
  return describe(selection, Language());
}

std::string describe(const ElementSelection& selection, const Language& tr) {
  std::string text;
  append_count(text, selection.vertices.size(), tr("1 vertex"), tr("{0} vertices"));
  append_count(text, selection.edges.size(), tr("1 edge"), tr("{0} edges"));
  append_count(text, selection.faces.size(), tr("1 face"), tr("{0} faces"));
  return text.empty() ? tr("nothing selected") : text;
}

}  // namespace hariko
