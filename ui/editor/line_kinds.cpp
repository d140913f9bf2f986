// The kinds of objects whose lines are only looked at: facets of reference meshes, control nets of Bezier
// patches.

#include "ui/editor/object_kind.hpp"
#include "ui/editor/object_lines.hpp"

namespace hariko {

namespace {

class MeshKind final : public ObjectKind {
 public:
  ObjectLines lines(const Document&, const Object& object, const Object* before,
                    const ObjectLines& drawn) const override {
    const MeshSource* old = before ? before->mesh() : nullptr;
    if (old && *old == *object.mesh()) return drawn;
    return {lines_of(*object.mesh()), {}};
  }
};

class BezierKind final : public ObjectKind {
 public:
  ObjectLines lines(const Document&, const Object& object, const Object* before,
                    const ObjectLines& drawn) const override {
    const BezierSource* old = before ? before->bezier() : nullptr;
    if (old && *old == *object.bezier()) return drawn;
    return {lines_of(*object.bezier()), {}};
  }
  void adjust(const Object&, const ViewSettings&, SceneObject& shown) const override {
    shown.elements_pickable = shown.show_polyhedron;
  }
};

}  // namespace

const ObjectKind& mesh_kind() {
  static const MeshKind kind;
  return kind;
}

const ObjectKind& bezier_kind() {
  static const BezierKind kind;
  return kind;
}

}  // namespace hariko
