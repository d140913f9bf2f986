#include "ui/editor/object_kind.hpp"

#include <variant>

#include "core/document/object_box.hpp"
#include "ui/base/language.hpp"

namespace hariko {

ElementSelection ObjectKind::all(const Object&, ElementMode) const {
  return {};
}

ElementSelection ObjectKind::existing(const Object&, ElementSelection) const {
  return {};
}

ElementSelection ObjectKind::converted(const Object&, const ElementSelection&, ElementMode,
                                       ElementMode) const {
  return {};
}

std::string ObjectKind::describe(const ElementSelection& selection, const Language& tr) const {
  return hariko::describe(selection, tr);
}

Element ObjectKind::element_at(const Object&, Element::Kind, Index) const {
  return {};
}

std::optional<Vector3> ObjectKind::place(const Object&, const Element&) const {
  return std::nullopt;
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

void ObjectKind::adjust(const Object&, const ViewSettings&, SceneObject&) const {}

const ObjectKind& object_kind(const Object& object) {
  struct Visitor {
    const ObjectKind& operator()(const PolyhedronSource&) const { return polyhedron_kind(); }
    const ObjectKind& operator()(const MeshSource&) const { return mesh_kind(); }
    const ObjectKind& operator()(const PatchSource&) const { return patches_kind(); }
    const ObjectKind& operator()(const BezierSource&) const { return bezier_kind(); }
    const ObjectKind& operator()(const SolidsSource&) const { return solids_kind(); }
    const ObjectKind& operator()(const SkinSource&) const { return skin_kind(); }
    const ObjectKind& operator()(const OutlineSource&) const { return outline_kind(); }
    const ObjectKind& operator()(const PictureSource&) const { return without_elements(); }
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
