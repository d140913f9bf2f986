// A session with a sample by hand: a vertex is dragged, its tension and that of an edge are set, all is
// undone and made again, saved and opened.

#include <memory>
#include <string>

#include "core/document/file.hpp"
#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

class ModellingWork : public ::testing::Test, protected ProgramHands {
 protected:
  void SetUp() override {
    open_sample("fig2");
    vertex_ = nearest(source().polyhedron, [](Index) { return true; });
  }
  const PolyhedronSource& source() { return *editor().active_object()->polyhedron(); }
  Vector3 place(VertexId v) {
    const PolyhedronSource& now = source();
    return editor().active_object()->transform.apply(now.origin +
                                                     now.polyhedron.position(now.polyhedron.find(v)));
  }
  /// The vertex that is nearest to the eye, of those that are wanted: nothing hides it.
  template <class Wanted>
  VertexId nearest(const Polyhedron& polyhedron, Wanted wanted) {
    VertexId best{no_index};
    for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
      const VertexId id = polyhedron.vertex_id(v);
      if (wanted(v) && (best.value == no_index || depth(place(id)) < depth(place(best)))) best = id;
    }
    return best;
  }
  std::shared_ptr<const DisplayMesh> surface() {
    const SurfaceView* view = editor().view_of(editor().selection.active);
    return view ? view->mesh : nullptr;
  }
  /// Lets go of what is held after its surface has followed.
  void release_when_the_surface_follows(const std::shared_ptr<const DisplayMesh>& before) {
    bench().settle();
    bench().settle();
    EXPECT_TRUE(editor().history.in_gesture());
    EXPECT_NE(surface(), before) << "the surface waits for the release";
    bench().release();
    wait();
    EXPECT_EQ(editor().view_of(editor().selection.active)->quality, Quality::final);
  }
  void drag_the_vertex() {
    const Vector2 from = pixel(place(vertex_)), to = from + Vector2(60, 40);
    const auto before = surface();
    begin_drag(from, to);
    release_when_the_surface_follows(before);
    expect_step(1, "Move vertex");
    EXPECT_LT((pixel(place(vertex_)) - to).cwiseAbs().maxCoeff(), 2) << "it is not at the pointer";
  }
  /// Drags its slider from the left end to six tenths of its way.
  void slide_the_tension() {
    const Marks::Rect slider = marks().at("slider.alpha");
    const double height = slider.y + slider.height / 2.0;
    const auto before = surface();
    begin_drag({slider.x + 8.0, height}, {slider.x + 0.6 * slider.width, height});
    release_when_the_surface_follows(before);
    expect_step(2, "Tension of vertex");
  }
  /// Selects the edge from the vertex to its neighbour nearest to the eye.
  EdgeId take_an_edge() {
    const Polyhedron& polyhedron = source().polyhedron;
    const Index own = polyhedron.find(vertex_);
    const VertexId other = nearest(polyhedron, [&](Index v) {
      for (Index e = 0; v != own && e < polyhedron.edge_count(); ++e)
        if (polyhedron.edge_id(e) == EdgeId::of(vertex_, polyhedron.vertex_id(v))) return true;
      return false;
    });
    press({"Ctrl+Shift+A", "2"});  // the gizmo at the vertex would cover it
    click(curve_near((place(vertex_) + place(other)) / 2));
    EXPECT_EQ(selected(), "1 edge");
    return EdgeId::of(vertex_, other);
  }

  VertexId vertex_;
};

TEST_F(ModellingWork, ADraggedVertexIsAtThePointerAndEscRestoresItExactly) {
  drag_the_vertex();
  const Document moved = editor().document();
  const Vector2 from = pixel(place(vertex_));
  begin_drag(from, from - Vector2(60, 0));
  EXPECT_TRUE(editor().history.in_gesture());
  EXPECT_FALSE(editor().document() == moved);
  press({"Esc"});
  bench().release();
  wait();
  EXPECT_EQ(editor().history.position(), 1U);
  EXPECT_EQ(editor().document(), moved);
}

TEST_F(ModellingWork, TensionsAreSetUndoneMadeAgainSavedAndOpened) {
  const Document first = editor().document();
  drag_the_vertex();
  slide_the_tension();
  const EdgeId edge = take_an_edge();
  enter("beta", "25");
  wait();
  EXPECT_EQ(editor().history.position(), 3U);
  const Shaping& shaping = *source().shaping;
  EXPECT_EQ(shaping.beta.get_or(edge, 1), 25);
  EXPECT_GT(shaping.alpha.get_or(vertex_, 0), 0.1);
  EXPECT_LT(shaping.alpha.get_or(vertex_, 0), 1000);

  press({"Ctrl+Z", "Ctrl+Z", "Ctrl+Z"});
  wait();
  EXPECT_EQ(editor().history.position(), 0U);
  EXPECT_FALSE(editor().history.dirty()) << "back at the start the document still counts as edited";
  EXPECT_EQ(editor().document(), first);
  press({"Ctrl+Shift+Z", "Ctrl+Y", "Ctrl+Shift+Z"});
  wait();
  EXPECT_EQ(editor().history.position(), 3U);

  // The dragged vertex alone has moved.
  const Polyhedron &old = first.objects[0]->polyhedron()->polyhedron, &now = source().polyhedron;
  ASSERT_EQ(now.vertex_count(), old.vertex_count());
  for (Index v = 0; v < now.vertex_count(); ++v)
    EXPECT_EQ(now.position(v) != old.position(v), now.vertex_id(v) == vertex_) << "vertex " << v;

  press({"Ctrl+Shift+S"});
  name_file("a.hariko");
  wait();
  EXPECT_FALSE(editor().history.dirty()) << notice();
  const auto saved = load_document(folder() / "a.hariko");
  ASSERT_TRUE(saved.ok());
  EXPECT_EQ(*saved, editor().document());
}

}  // namespace
}  // namespace hariko::test
