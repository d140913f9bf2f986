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

}  // namespace
}  // namespace hariko
