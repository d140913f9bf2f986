// Scene of objects without elements that can be selected.

#include "ui/editor/scene_builder.hpp"

#include "core/document/edits/edits.hpp"
#include "tests/app/tool_rig.hpp"

namespace hariko {
namespace {

using test::Rig;

Source reference_mesh() {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  mesh.add_face({0, 1, 2, 3});
  return MeshSource::from_mesh(mesh).value();
}

/// Two patches of degree 2 by 1 side by side.
Source bezier_patches() {
  std::vector<BezierPatch> patches(2);
  for (int k = 0; k < 2; ++k) {
    patches[std::size_t(k)].degree_s = 2;
    patches[std::size_t(k)].degree_t = 1;
    for (int j = 0; j <= 1; ++j)
      for (int i = 0; i <= 2; ++i)
        patches[std::size_t(k)].points.emplace_back(2 * k + i, 2 * j, i == 1 ? 0.5 : 0.0);
  }
  return BezierSource::from_patches(std::move(patches)).value();
}

/// The pointer goes everywhere: nothing is found in the modes of elements, the object in that of objects.
void expect_no_elements(const Source& source) {
  Rig rig(add_object({}, "references", source).value().document);
  for (const ElementMode mode :
       {ElementMode::object, ElementMode::vertex, ElementMode::edge, ElementMode::face}) {
    rig.editor.mode = mode;
    rig.scene.update(rig.editor);
    std::size_t found = 0;
    for (int x = 0; x < 800; x += 10)
      for (int y = 0; y < 600; y += 10)
        for (const ElementRef& ref : elements_under(rig.context(), {x, y})) {
          EXPECT_EQ(ref.element.kind, Element::Kind::object);
          ++found;
        }
    EXPECT_EQ(found > 0, mode == ElementMode::object) << "mode " << int(mode);
  }
}

TEST(SceneBuilder, ReferenceMeshesHaveNoElements) {
  expect_no_elements(reference_mesh());
}

TEST(SceneBuilder, BezierPatchesHaveNoElements) {
  expect_no_elements(bezier_patches());
}

TEST(SceneBuilder, ControlNetsOfBezierPatches) {
  Rig rig(add_object({}, "patches", bezier_patches()).value().document);
  const DisplayPolyhedron& net = *rig.scene.scene().objects[0].polyhedron;
  EXPECT_EQ(net.positions.size(), 12U);
  EXPECT_EQ(net.edges.size(), 2U * (2 * 2 + 3 * 1));
  const Box3 box = world_box(*rig.editor.document().objects[0]);
  EXPECT_LE((net.origin + net.box.min() - box.min()).norm(), 1e-12);
  EXPECT_LE((net.origin + net.box.max() - box.max()).norm(), 1e-12);
  // Hidden things are not picked.
  DisplaySettings display = rig.editor.document().objects[0]->display;
  display.polyhedron = false;
  rig.editor.commit(set_display(rig.editor.history.current(), rig.editor.selection.active, display), "Hide");
  rig.scene.update(rig.editor);
  EXPECT_FALSE(rig.scene.scene().objects[0].elements_pickable);
}

}  // namespace
}  // namespace hariko
