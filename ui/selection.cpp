#include "ui/selection.hpp"

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

void append_count(std::string& text, std::size_t count, const char* one, const char* many) {
  if (count == 0) return;
  if (!text.empty()) text += ", ";
  text += std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

const ElementSelection& Selection::of(ObjectId object) const {
  static const ElementSelection nothing;
  const auto it = elements_.find(object);
  return it == elements_.end() ? nothing : it->second;
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
    default:
      return false;
  }
}

void Selection::select(const ElementRef& ref, How how) {
  if (how == How::replace) elements_.clear();
  active = ref.object;
  ElementSelection& selection = elements_[ref.object];
  const auto id = static_cast<std::uint32_t>(ref.element.id);
  const bool present = how != How::remove;
  switch (ref.element.kind) {
    case Element::Kind::vertex:
      change(selection.vertices, VertexId{id}, present);
      break;
    case Element::Kind::edge:
      change(selection.edges, EdgeId::from_packed(ref.element.id), present);
      break;
    case Element::Kind::face:
      change(selection.faces, FaceId{id}, present);
      break;
    default:
      break;
  }
  if (selection.empty()) elements_.erase(ref.object);
}

void Selection::select_all(const Object& object, ElementMode mode) {
  active = object.id;
  elements_.clear();
  const PolyhedronSource* source = object.polyhedron();
  if (!source) return;
  const Polyhedron& polyhedron = source->polyhedron;
  ElementSelection& selection = elements_[object.id];
  if (mode == ElementMode::vertex)
    for (Index v = 0; v < polyhedron.vertex_count(); ++v) selection.vertices.insert(polyhedron.vertex_id(v));
  if (mode == ElementMode::edge)
    for (Index e = 0; e < polyhedron.edge_count(); ++e) selection.edges.insert(polyhedron.edge_id(e));
  if (mode == ElementMode::face)
    for (Index f = 0; f < polyhedron.face_count(); ++f) selection.faces.insert(polyhedron.face_id(f));
}

void Selection::prune(const Document& document) {
  for (auto it = elements_.begin(); it != elements_.end();) {
    const Object* object = document.find(it->first);
    const PolyhedronSource* source = object ? object->polyhedron() : nullptr;
    if (source) {
      keep_existing(it->second.vertices, source->polyhedron);
      keep_existing(it->second.edges, source->polyhedron);
      keep_existing(it->second.faces, source->polyhedron);
    }
    it = !source || it->second.empty() ? elements_.erase(it) : std::next(it);
  }
  if (!document.find(active)) active = document.objects.empty() ? ObjectId{} : document.objects.back()->id;
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
  return {vertices.begin(), vertices.end()};
}

std::string describe(const ElementSelection& selection) {
  std::string text;
  append_count(text, selection.vertices.size(), "vertex", "vertices");
  append_count(text, selection.edges.size(), "edge", "edges");
  append_count(text, selection.faces.size(), "face", "faces");
  return text.empty() ? "nothing selected" : text;
}

}  // namespace hariko
