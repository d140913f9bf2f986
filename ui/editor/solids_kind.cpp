// The kind of objects made of solids, each selected as a vertex with its id.

#include "core/document/edits/edit_solids.hpp"
#include "ui/base/language.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/solids_display.hpp"

namespace hariko {

namespace {

class SolidsKind final : public ObjectKind {
 public:
  ElementSelection all(const Object& object, ElementMode) const override {
    ElementSelection all;
    for (const Solid& solid : object.solids()->input->solids) all.vertices.insert(VertexId{solid.id});
    return all;
  }

  ElementSelection existing(const Object& object, ElementSelection selection) const override {
    std::erase_if(selection.vertices, [&](VertexId id) { return !find_solid(object, id.value); });
    selection.edges.clear();
    selection.faces.clear();
    return selection;
  }

  ElementSelection converted(const Object&, const ElementSelection& selection, ElementMode,
                             ElementMode) const override {
    return selection;
  }

  std::string describe(const ElementSelection& selection, const Language& tr) const override {
    const std::size_t count = selection.vertices.size();
    if (count == 0) return ObjectKind::describe(selection, tr);
    return count == 1 ? std::string(tr("1 solid")) : fill(tr("{0} solids"), {std::to_string(count)});
  }

  std::optional<Vector3> place(const Object& object, const Element& element) const override {
    const Solid* solid = find_solid(object, static_cast<std::uint32_t>(element.id));
    return solid ? std::optional<Vector3>(solid->position) : std::nullopt;
  }

  ObjectLines lines(const Document&, const Object& object, const Object* before,
                    const ObjectLines& drawn) const override {
    const SolidsSource* old = before ? before->solids() : nullptr;
    if (old && *old == *object.solids()) return drawn;
    return {display_of(*object.solids()), {}};
  }

  Highlights highlights(const Object&, const ElementSelection& selection,
                        const DisplayPolyhedron& lines) const override {
    return highlights_of_solids(lines, selection.vertices);
  }

  /// They lie inside of their surface.
  void adjust(const Object& object, const ViewSettings& view, SceneObject& shown) const override {
    if (view.surfaces_only) return;
    shown.x_ray = true;
    shown.show_points = false;
    shown.show_bodies = view.bodies && shown.show_polyhedron;
    shown.faint_bodies = object.locked;
  }
};

}  // namespace

const ObjectKind& solids_kind() {
  static const SolidsKind kind;
  return kind;
}

}  // namespace hariko
