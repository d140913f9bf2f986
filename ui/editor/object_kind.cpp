#include "ui/editor/object_kind.hpp"

#include <cctype>
#include <variant>

#include "core/document/object_box.hpp"
#include "ui/base/icons.hpp"
#include "ui/base/language.hpp"

namespace hariko {

ElementSelection ObjectKind::all(const Object&, ElementMode) const {
  return {};
}

ElementSelection ObjectKind::existing(const Object& object, ElementSelection selection) const {
  std::erase_if(selection.vertices, [&](VertexId id) { return !place(object, element_of(id)); });
  selection.edges.clear();
  selection.faces.clear();
  return selection;
}

ElementSelection ObjectKind::converted(const Object&, const ElementSelection&, ElementMode,
                                       ElementMode) const {
  return {};
}

std::string ObjectKind::describe(const ElementSelection& selection, const Language& tr) const {
  return hariko::describe(selection, tr);
}

std::string ObjectKind::title(const Element& element, const Language& tr) const {
  std::string text = to_string(element);
  if (text.empty()) return text;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));  // as the catalogue has it
  const std::size_t space = text.find(' ');
  return tr(text.substr(0, space)) + text.substr(space);
}

ElementSelection ObjectKind::continued(const Object&, const Element&, bool) const {
  return {};
}

ElementSelection ObjectKind::linked(const Object&, const ElementSelection& selection) const {
  return selection;
}

Element ObjectKind::element_at(const Object&, Element::Kind, Index) const {
  return {};
}

std::optional<Vector3> ObjectKind::place(const Object&, const Element&) const {
  return std::nullopt;
}

std::vector<Vector3> ObjectKind::extent(const Object& object, const ElementSelection& selection) const {
  std::vector<Vector3> out;
  for (const VertexId id : selection.vertices)
    if (const auto at = place(object, element_of(id))) out.push_back(*at);
  return out;
}

ObjectLines ObjectKind::lines(const Document&, const Object&, const Object*, const ObjectLines&) const {
  return {};
}

Highlights ObjectKind::highlights(const Object&, const ElementSelection&, const DisplayPolyhedron&) const {
  return {};
}

Highlights ObjectKind::failed(const Object&, const Element&, const DisplayPolyhedron&) const {
  return {};
}

std::vector<ObjectBody> ObjectKind::bodies(const Object&) const {
  return {};
}

void ObjectKind::adjust(const Object&, const ViewSettings&, SceneObject&) const {}

void ObjectKind::adjust_in_file(const Object&, SceneObject&, std::vector<OverlayLine>&) const {}

std::vector<OverlayLine> ObjectKind::guides(const Object&) const {
  return {};
}

const char* ObjectKind::list_icon() const {
  return icon::object;
}

std::string ObjectKind::size_text(const Object&, const Language&) const {
  return {};
}

const ObjectKind& object_kind(const Object& object) {
  struct Visitor {
    const ObjectKind& operator()(const PolyhedronSource&) const { return polyhedron_kind(); }
    const ObjectKind& operator()(const MeshSource&) const { return mesh_kind(); }
    const ObjectKind& operator()(const PatchSource&) const { return patches_kind(); }
    const ObjectKind& operator()(const BezierSource&) const { return bezier_kind(); }
    const ObjectKind& operator()(const SolidsSource&) const { return solids_kind(); }
    const ObjectKind& operator()(const SkinSource&) const { return skin_kind(); }
    const ObjectKind& operator()(const OutlineSource&) const { return outline_kind(); }
    const ObjectKind& operator()(const PictureSource&) const { return picture_kind(); }
    const ObjectKind& operator()(const UnknownSource&) const { return without_elements(); }
    static const ObjectKind& without_elements() {
      static const ObjectKind kind;
      return kind;
    }
  };
  return std::visit(Visitor{}, object.source);
}

std::optional<Vector3> place_of(const Document& document, const ElementRef& ref) {
  const Object* object = document.find(ref.object);
  if (!object) return std::nullopt;
  if (ref.element.kind == Element::Kind::object) {
    const Box3 box = world_box(*object);
    return box.isEmpty() ? object->transform.translation : Vector3(box.center());
  }
  const auto place = object_kind(*object).place(*object, ref.element);
  return place ? std::optional<Vector3>(object->transform.apply(*place)) : std::nullopt;
}

}  // namespace hariko
