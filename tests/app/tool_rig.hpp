#pragma once

// Rig of the tests of tools: an editor without a window, and a tool driven as the viewport drives it.

#include <gtest/gtest.h>

#include "core/document/edits/edits.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "ui/view/tool.hpp"

namespace hariko::test {

inline Document cube_document() {
  return document_from_mesh(cube(), "cube").value();
}

/// n x n squares of side 1 in the plane z = 0.
inline Document grid_document(int n) {
  PolygonMesh mesh;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) mesh.positions.emplace_back(x, y, 0);
  const auto at = [n](int x, int y) { return static_cast<Index>(y * (n + 1) + x); };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) mesh.add_face({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
  return document_from_mesh(mesh, "grid").value();
}

/// An editor of 800 x 600 pixels, the scene that it shows, and the tool that runs.
struct Rig {
  Editor editor;
  SceneBuilder scene;
  std::unique_ptr<Tool> tool;
  PointerEvent at;

  explicit Rig(Document document = cube_document()) {
    editor.viewport = {800, 600};
    editor.open(std::move(document), {});
    editor.frame_all(true);
    scene.update(editor);
  }
  ToolContext context() { return {editor, scene}; }
  const PolyhedronSource& source(std::size_t object = 0) const {
    return *editor.document().objects[object]->polyhedron();
  }
  Vector3 place(VertexId id, std::size_t object = 0) const {
    const PolyhedronSource& s = source(object);
    return editor.document().objects[object]->transform.apply(s.origin +
                                                              s.polyhedron.position(s.polyhedron.find(id)));
  }
  Vector2 pixel(const Vector3& world) const {
    return Projector(editor.camera(), editor.viewport).project(world)->head<2>();
  }
  void choose(std::initializer_list<unsigned> vertices) {
    editor.mode = ElementMode::vertex;
    editor.selection.clear_elements();
    for (const unsigned v : vertices)
      editor.selection.select({editor.document().objects[0]->id, element_of(VertexId{v})},
                              Selection::How::add);
    scene.update(editor);
  }
  void start(std::unique_ptr<Tool> next, const Vector2& pixel = {400, 300}) {
    at = {};
    at.pixel = pixel;
    tool = std::move(next);
    ToolContext now = context();
    tool->begin(now, at);
  }
  void handle(ToolState state) {
    if (state == ToolState::stay) return;
    const std::unique_ptr<Tool> done = std::move(tool);
    if (auto next = state == ToolState::commit ? done->successor() : nullptr) {
      tool = std::move(next);
      ToolContext now = context();
      tool->begin(now, at);
      handle(tool->update(now, at));
    }
    scene.update(editor);
  }
  void send(PointerEvent::Kind kind, const Vector2& pixel, bool shift = false, bool control = false) {
    ASSERT_NE(tool, nullptr);
    PointerEvent event;
    event.kind = kind;
    event.pixel = pixel;
    event.shift = shift;
    event.control = control;
    at.pixel = pixel;
    ToolContext now = context();
    handle(tool->update(now, event));
  }
  void move(const Vector2& pixel, bool shift = false, bool control = false) {
    send(PointerEvent::Kind::move, pixel, shift, control);
  }
  void key(Key key, bool shift = false, char32_t text = 0) {
    ASSERT_NE(tool, nullptr);
    ToolContext now = context();
    const auto state = tool->key(now, {{key, false, shift, false}, text});
    if (state) handle(*state);
  }
  void type(std::string_view text) {
    for (const char c : text) {
      const int code = c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c;
      key(Key{code}, false, static_cast<char32_t>(c));
    }
  }
  void enter() { key(Key::enter); }
  void escape() {
    ToolContext now = context();
    tool->cancel(now);
    tool.reset();
    scene.update(editor);
  }
};

}  // namespace hariko::test
