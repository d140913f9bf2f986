#include "ui/editor/selection.hpp"

#include <utility>

#include "ui/base/language.hpp"
#include "ui/editor/object_kind.hpp"

namespace hariko {

namespace {

template <class Id>
void change(std::set<Id>& set, Id id, bool present) {
  if (present)
    set.insert(id);
  else
    set.erase(id);
}

void append_count(std::string& text, std::size_t count, const std::string& counted) {
  if (count == 0) return;
  if (!text.empty()) text += ", ";
  text += counted;
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
  clear_elements();
  if (mode == ElementMode::object)
    objects_.insert(object.id);
  else
    set(object.id, object_kind(object).all(object, mode));
}

void Selection::prune(const Document& document) {
  for (auto it = elements_.begin(); it != elements_.end();) {
    const Object* object = document.find(it->first);
    // Nothing is selected of hidden and locked objects.
    const bool selectable = object && object->visible && !object->locked;
    it->second =
        selectable ? object_kind(*object).existing(*object, std::move(it->second)) : ElementSelection{};
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
      if (const Object* object = document.find(id)) result.set(id, object_kind(*object).all(*object, to));
    return result;
  }
  for (const auto& [id, elements] : selection.elements()) {
    if (const Object* object = document.find(id))
      result.set(id, object_kind(*object).converted(*object, elements, from, to));
  }
  return result;
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
  std::erase_if(vertices, [&](VertexId id) { return polyhedron.find(id) == no_index; });
  return {vertices.begin(), vertices.end()};
}

std::string describe(const ElementSelection& selection) {
  return describe(selection, Language());
}

std::string describe(const ElementSelection& selection, const Language& tr) {
  std::string text;
  const std::size_t vertices = selection.vertices.size(), edges = selection.edges.size();
  const std::size_t faces = selection.faces.size();
  append_count(text, vertices, tr.counted(vertices, "1 vertex", "{0} vertices"));
  append_count(text, edges, tr.counted(edges, "1 edge", "{0} edges"));
  append_count(text, faces, tr.counted(faces, "1 face", "{0} faces"));
  return text.empty() ? tr("nothing selected") : text;
}

}  // namespace hariko
