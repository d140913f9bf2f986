// A cage and a scan, by hand: vertices onto the scan, the surface fitted to it, and what is said where
// neither can be.

#include "core/document/edits/edits.hpp"
#include "core/geometry/triangle.hpp"
#include "core/modeling/surfacing/surface_input.hpp"
#include "core/surface/surface_triangles.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/program_hands.hpp"

namespace hariko {
namespace {

/// Facets on the surface of a cage.
PolygonMesh scanned(const PolyhedronSource& cage) {
  const Surface surface = PolyhedronSurfacer().rebuild(surface_input(cage).value()).value().surface;
  const SurfaceTriangles net = surface_triangles(surface, 12);
  PolygonMesh out;
  for (const Vector3& p : net.positions) out.positions.push_back(surface.origin() + p);
  for (const auto& t : net.triangles) out.add_face({t[0], t[1], t[2]});
  return out;
}

PolygonMesh larger_cube(double factor) {
  PolygonMesh mesh = test::cube();
  for (Vector3& p : mesh.positions) p = factor * p.cwiseProduct(Vector3(1, 1.2, 0.9));
  return mesh;
}

/// A cube, and scans of the surfaces of other boxes.
Document cage_and_scans(std::initializer_list<double> factors) {
  Document document =
      add_object({}, "Cage", as_new(PolyhedronSource::from_mesh(test::cube()).value()))->document;
  for (const double factor : factors) {
    const PolyhedronSource scan = as_new(PolyhedronSource::from_mesh(larger_cube(factor)).value());
    document = add_object(document, "Scan", MeshSource::from_mesh(scanned(scan)).value())->document;
  }
  return document;
}

class ReferenceHands : public ::testing::Test {
 protected:
  void open(Document document) {
    bench_.reset();  // a second context of ImGui would be lost with the first one
    bench_ = std::make_unique<test::HeadlessWorkbench>(std::move(document), ImVec2{1440, 1000});
    editor().selection.active = editor().document().objects[0]->id;
    bench_->frame();
  }
  Editor& editor() { return bench_->editor(); }
  const PolyhedronSource& cage() { return *editor().document().objects[0]->polyhedron(); }
  Vector3 place(Index vertex) { return cage().origin + cage().polyhedron.position(vertex); }
  void select_vertices(std::initializer_list<unsigned> vertices) {
    editor().mode = ElementMode::vertex;
    editor().selection.clear_elements();
    for (const unsigned v : vertices)
      editor().selection.select({editor().selection.active, element_of(VertexId{v})}, Selection::How::add);
  }
  CommandTable::Outcome run(std::string_view id) {
    const auto outcome = bench_->workbench().commands().run(id);
    bench_->frame();
    return outcome;
  }
  void from_palette(const char* words, const std::string& id) { bench_->from_palette(words, id); }
  double distance_from_scan(std::size_t object, const Vector3& point) {
    const MeshSource& scan = *editor().document().objects[object]->mesh();
    double out = 1e300;
    for (std::size_t f = 0; f < scan.mesh->face_count(); ++f) {
      const auto corners = scan.mesh->face(f);
      TriangleCorners at;
      for (std::size_t k = 0; k < 3; ++k) at[k] = scan.origin + scan.mesh->positions[corners[k]];
      out = std::min(out, ClosedTriangle(at).distance(point));
    }
    return out;
  }
  std::string last_notice() {
    return editor().notices().empty() ? std::string() : editor().notices().back().text;
  }

 private:
  std::unique_ptr<test::HeadlessWorkbench> bench_;
};

TEST_F(ReferenceHands, SelectedVerticesGoOntoTheScanAndUndoTakesThemBack) {
  open(cage_and_scans({0.7}));
  const Document before = editor().document();
  select_vertices({0, 3});
  from_palette("project onto", "mesh.project_reference");
  for (Index v = 0; v < 8; ++v) {
    const bool moves = v == 0 || v == 3;
    EXPECT_EQ(distance_from_scan(1, place(v)) < 1e-12, moves) << v;
  }
  EXPECT_EQ(editor().selection.of_active().vertices.size(), 2U) << "what was selected stays so";
  EXPECT_EQ(editor().history.undo_label(), "Project onto the reference");
  run("mesh.project_reference");
  EXPECT_NE(last_notice().find("already"), std::string::npos) << last_notice();
  editor().undo();
  EXPECT_EQ(editor().document(), before);
}

TEST_F(ReferenceHands, TheSurfaceIsFittedToldOfAndAdjusted) {
  open(cage_and_scans({1.1}));
  const Document before = editor().document();
  editor().mode = ElementMode::object;
  from_palette("fit to the reference", "mesh.fit_reference");
  EXPECT_EQ(editor().history.undo_label(), "Fit to the reference");
  EXPECT_NE(last_notice().find("off the reference"), std::string::npos) << last_notice();
  const PolygonMesh wanted = larger_cube(1.1);
  for (Index v = 0; v < 8; ++v) EXPECT_LT((place(v) - wanted.positions[v]).norm(), 0.05) << v;
  const Document fitted = editor().document();
  ASSERT_TRUE(editor().last_operation.can_adjust(editor()));
  EXPECT_TRUE(editor().last_operation.adjust(editor(), 0, 1));
  EXPECT_FALSE(editor().document() == fitted);
  EXPECT_TRUE(editor().last_operation.adjust(editor(), 0, 8));
  EXPECT_EQ(editor().document(), fitted);
  editor().undo();
  EXPECT_EQ(editor().document(), before);
}

TEST_F(ReferenceHands, AScanIsReducedAndUndoTakesItBack) {
  open(cage_and_scans({1.1}));
  const Document before = editor().document();
  editor().mode = ElementMode::object;
  EXPECT_FALSE(run("mesh.reduce_reference").ran) << "the cage has no facets";
  editor().selection.active = before.objects[1]->id;
  const auto facets = [&] { return editor().document().objects[1]->mesh()->mesh->face_count(); };
  const std::size_t dense = facets();
  from_palette("reduce the reference", "mesh.reduce_reference");
  EXPECT_LE(facets(), dense) << "this scan is about as coarse as the usual distance";
  EXPECT_TRUE(editor().last_operation.adjust(editor(), 0, 0.02));
  const std::size_t fewer = facets();
  EXPECT_LT(fewer, dense);
  EXPECT_GT(fewer, 0U);
  EXPECT_NE(last_notice().find("off by"), std::string::npos) << last_notice();
  EXPECT_TRUE(editor().last_operation.adjust(editor(), 0, 0.1));
  EXPECT_LT(facets(), fewer) << "a larger distance needs fewer";
  editor().undo();
  EXPECT_EQ(editor().document(), before);
}

TEST_F(ReferenceHands, OfSeveralScansTheChosenOneCounts) {
  open(cage_and_scans({0.8, 1.5}));
  select_vertices({0});
  run("mesh.project_reference");
  EXPECT_LT(distance_from_scan(1, place(0)), 1e-12) << "the nearer one";
  editor().undo();
  const ObjectId cage_id = editor().document().objects[0]->id, other = editor().document().objects[2]->id;
  editor().selection.select({other, element_of(other)}, Selection::How::add);
  editor().selection.active = cage_id;
  select_vertices({0});
  run("mesh.project_reference");
  EXPECT_LT(distance_from_scan(2, place(0)), 1e-12) << "the chosen one";
}

TEST_F(ReferenceHands, WhatCannotBeDoneSaysWhy) {
  open(cage_and_scans({}));
  select_vertices({0});
  for (const char* id : {"mesh.project_reference", "mesh.fit_reference"}) {
    const auto outcome = run(id);
    EXPECT_FALSE(outcome.ran) << id;
    EXPECT_NE(outcome.reason.find("reference facets"), std::string::npos) << outcome.reason;
  }
  Document hidden = cage_and_scans({0.8});
  hidden = set_visible(hidden, hidden.objects[1]->id, false).value();
  open(hidden);
  EXPECT_FALSE(run("mesh.fit_reference").ran) << "what is hidden is no reference";
  open(cage_and_scans({0.8}));
  editor().mode = ElementMode::vertex;
  editor().selection.clear_elements();
  const auto nothing = run("mesh.project_reference");
  EXPECT_FALSE(nothing.ran);
  EXPECT_NE(nothing.reason.find("selected"), std::string::npos) << nothing.reason;

  Document locked = cage_and_scans({0.8});
  locked = set_locked(locked, locked.objects[0]->id, true).value();
  open(locked);
  run("mesh.fit_reference");
  EXPECT_EQ(editor().document(), locked);
}

/// With a worker, as in the window.
class ReferenceWork : public ::testing::Test, protected test::ProgramHands {
 protected:
  ReferenceWork() {
    editor().open(cage_and_scans({1.1}), {});
    editor().selection.active = cage_id();
    editor().mode = ElementMode::object;
    frames(2);
  }
  ObjectId cage_id() { return editor().document().objects[0]->id; }
  ObjectId scan_id() { return editor().document().objects[1]->id; }
  bool run(std::string_view id) { return bench().workbench().commands().run(id).ran; }
  void move_object(ObjectId id) {
    Similarity placed = editor().document().find(id)->transform;
    placed.translation.x() += 0.1;
    ASSERT_TRUE(editor().commit(set_transform(editor().history.current(), id, placed), "Move"));
  }
};

TEST_F(ReferenceWork, AFitIsWorkThatEndsInOneStepAndIsAdjustedLikewise) {
  const Document before = editor().document();
  ASSERT_TRUE(run("mesh.fit_reference"));
  EXPECT_EQ(editor().document(), before) << "the window waited";
  ASSERT_EQ(editor().jobs.size(), 1U);
  EXPECT_EQ(editor().jobs[0]->text, "Fitting Cage");
  EXPECT_TRUE(editor().jobs[0]->can_be_cancelled);
  wait();
  EXPECT_EQ(editor().history.position(), 1U);
  EXPECT_EQ(editor().history.undo_label(), "Fit to the reference");
  EXPECT_NE(notice().find("off the reference"), std::string::npos) << notice();
  const Document fitted = editor().document();
  EXPECT_TRUE(editor().last_operation.adjust(editor(), 0, 1));
  EXPECT_EQ(editor().document(), fitted) << "the window waited";
  wait();
  EXPECT_FALSE(editor().document() == fitted);
  EXPECT_EQ(editor().history.position(), 1U);
  // The first fit is known.
  EXPECT_TRUE(editor().last_operation.adjust(editor(), 0, 8));
  EXPECT_EQ(editor().document(), fitted);
  press({"Ctrl+Z"});
  EXPECT_EQ(editor().document(), before);
}

TEST_F(ReferenceWork, AProjectionIsWorkToo) {
  editor().mode = ElementMode::vertex;
  editor().selection.select({cage_id(), element_of(VertexId{0})}, Selection::How::add);
  const Document before = editor().document();
  ASSERT_TRUE(run("mesh.project_reference"));
  EXPECT_EQ(editor().document(), before);
  wait();
  EXPECT_EQ(editor().history.undo_label(), "Project onto the reference");
  EXPECT_FALSE(editor().document() == before);
  EXPECT_TRUE(editor().selection.of(cage_id()).vertices.contains(VertexId{0}));
}

TEST_F(ReferenceWork, WhatWasChangedMeanwhileIsNotFitted) {
  for (const bool scan : {false, true}) {
    ASSERT_TRUE(run("mesh.fit_reference"));
    move_object(scan ? scan_id() : cage_id());
    const Document moved = editor().document();
    wait();
    EXPECT_EQ(editor().document(), moved) << scan;
    EXPECT_NE(notice().find("changed meanwhile"), std::string::npos) << notice();
    editor().notices().clear();
  }
}

TEST_F(ReferenceWork, ACancelledFitChangesNothing) {
  const Document before = editor().document();
  ASSERT_TRUE(run("mesh.fit_reference"));
  ASSERT_TRUE(run("file.cancel_job"));
  wait();
  EXPECT_EQ(editor().document(), before);
  EXPECT_EQ(editor().history.position(), 0U);
  EXPECT_TRUE(editor().notices().empty()) << notice();
}

TEST_F(ReferenceWork, WhatMayNotMoveIsRefusedAtOnce) {
  ASSERT_TRUE(editor().commit(set_locked(editor().history.current(), cage_id(), true), "Lock"));
  run("mesh.fit_reference");
  EXPECT_TRUE(editor().jobs.empty());
  EXPECT_FALSE(editor().notices().empty());
}

}  // namespace
}  // namespace hariko
