// Facets of paper models in the window.

#include "app/engines/paper_engine.hpp"

#include "core/document/edits/edit_objects.hpp"
#include "core/document/edits/edit_paper.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "ui/editor/paper_edits.hpp"

namespace hariko {
namespace {

TEST(PaperEngine, ReferenceFacetsAreUnfoldedAsTheyAreBesideSurfaces) {
  // A closed box of facets with quads, and a surface whose polyhedron is unfolded.
  PolygonMesh facets = test::prism(4);
  for (Vector3& p : facets.positions) p += Vector3(10, 0, 0);
  const Document surface = document_from_mesh(test::prism(5), "Surface").value();
  const Document document = add_object(surface, "Facets", MeshSource::from_mesh(facets).value())->document;
  PaperModel paper = default_paper(document);
  paper.of_polyhedra = true;
  const MadePaperMesh made = make_paper_mesh(document, paper, {});
  ASSERT_TRUE(made.fault.messages.empty()) << to_string(made.fault.messages.front());
  ASSERT_TRUE(made.mesh);
  EXPECT_EQ(made.mesh->graph->component_count(), 2U);
  EXPECT_EQ(made.mesh->graph->face_count(), 6U + 7U);
  // Alone, too.
  const Document alone = add_object({}, "Facets", MeshSource::from_mesh(facets).value())->document;
  const MadePaperMesh only = make_paper_mesh(alone, default_paper(alone), {});
  ASSERT_TRUE(only.mesh);
  EXPECT_EQ(only.mesh->graph->face_count(), 6U);
}

TEST(PaperEngine, WhatIsChosenDuringTheSearchStays) {
  const Document prism = document_from_mesh(test::prism(5), "Prism").value();
  PaperModel paper = default_paper(prism);
  paper.of_polyhedra = true;
  Editor editor;
  editor.open(set_paper(prism, paper), std::nullopt);
  BackgroundWork searches(editor, [] {});
  PaperEngine engine(editor, searches, [] {});
  engine.sync();  // it forgets the wishes of earlier documents
  const auto search = [&] {
    editor.paper.wants_unfolding = true;
    engine.sync();
  };
  const auto finish = [&] {
    searches.wait();
    searches.publish();
  };
  search();
  const Document changed =
      with_paper_settings(editor.history.current(), [](PaperModel& model) { model.settings.gap = 7; });
  ASSERT_TRUE(editor.commit(changed, "Gap between pieces"));
  finish();
  EXPECT_EQ(editor.document().paper->settings.gap, 7);
  EXPECT_FALSE(editor.document().paper->unfolded());
  ASSERT_FALSE(editor.notices().empty()) << "the search was dropped in silence";
  search();
  finish();
  EXPECT_EQ(editor.document().paper->settings.gap, 7);
  EXPECT_TRUE(editor.document().paper->unfolded());
}

}  // namespace
}  // namespace hariko
