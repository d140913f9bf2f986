// Paper models of the samples: surfaces meshed under tolerances, checked by means of their own.

#include <algorithm>
#include <filesystem>

#include "app/files/model_facets.hpp"
#include "core/document/edits/edit_paper.hpp"
#include "core/document/file.hpp"
#include "core/unfolding/paper_document.hpp"
#include "tests/support/places.hpp"
#include "tests/unfolding/paper.hpp"

namespace hariko::test {
namespace {

std::vector<std::filesystem::path> sample_files() {
  std::vector<std::filesystem::path> out;
  for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() + "/assets/samples"))
    if (entry.path().extension() == ".hariko") out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

double size_of(const PolygonMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3& p : mesh.positions) box.extend(p);
  return box.sizes().maxCoeff();
}

/// Facets of a sample, without names twice.
ModelFacets facets_of(const Document& document, double factor) {
  const auto objects = unfoldable_objects(document);
  FacetOptions options;
  options.distance = factor * proposed_distance(document, objects);
  auto facets = must(document_facets(document, objects, options));
  EXPECT_EQ(facets->names.size(), facets->mesh.positions.size());
  auto names = facets->names;
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end()) << "two vertices have one name";
  return std::move(facets).value();
}

Unfolding unfolded(const ModelFacets& facets, std::uint64_t steps) {
  PaperSettings settings;
  settings.scale = 200 / size_of(facets.mesh);
  return unfold(shared_graph(facets.mesh), settings, {.goal = CutGoal::balanced, .steps = steps}).value();
}

/// Every sample at three tolerances in long runs; three samples at one otherwise.
TEST(Samples, AreUnfoldedWithoutOverlaps) {
  const bool all = repetitions(1) > 1;
  std::size_t number = 0;
  for (const auto& file : sample_files()) {
    if (!all && number++ % 4 != 0) continue;
    const auto document = load_document(file);
    ASSERT_TRUE(document.ok()) << file;
    for (const double factor : {4.0, 1.0, 0.5}) {
      if (!all && factor < 4) continue;
      SCOPED_TRACE(file.filename().string() + ", " + std::to_string(factor) + " of the proposed distance");
      const ModelFacets facets = facets_of(*document, factor);
      const Unfolding model = unfolded(facets, all ? 20'000 : 500);
      EXPECT_TRUE(unfolding_messages(model).empty());
      check_pages(facets.mesh, model);
    }
  }
}

/// A patch of this sample turns back: halves of its diagonal are longer than the diagonal.
TEST(Samples, ASurfaceThatTurnsBackNeedsFewFacets) {
  const auto document = must(load_document(test::source_folder() + "/assets/samples/solids_ten.hariko"));
  EXPECT_LT(facets_of(*document, 4).mesh.face_count(), 2000U);
}

/// A dented sample: what is left of the mesh keeps its folds and most of its places.
TEST(Samples, AMovedVertexKeepsMostCuts) {
  const auto document = must(load_document(test::source_folder() + "/assets/samples/fig2.hariko"));
  const ModelFacets facets = facets_of(*document, 4);
  const Unfolding model = unfolded(facets, 500);
  const PaperModel kept = kept_of(model, facets.names, PaperModel{});
  Document moved = *document;
  Object object = *moved.objects.front();
  PolyhedronSource source = *object.polyhedron();
  const Index vertex = 0;
  const Vector3 to = source.polyhedron.position(vertex) + Vector3(0.02, 0.03, 0.05);
  source.polyhedron = source.polyhedron.with_positions(std::vector{vertex}, std::vector{to}).value();
  object.source = source;
  moved.objects.front() = std::make_shared<const Object>(object);
  const ModelFacets after = facets_of(moved, 4);
  const auto graph = shared_graph(after.mesh);
  const auto back = must(restored(kept, graph, after.names));
  check_shape(after.mesh, checked_layout(*back));
  // Edges by the names of their ends.
  const auto name_of = [](const ModelFacets& of, const FacetEdge& edge) {
    return std::minmax(of.names[edge.low], of.names[edge.high]);
  };
  std::map<std::pair<PaperVertex, PaperVertex>, bool> folded;
  for (Index e = 0; e < model.graph->edge_count(); ++e)
    if (!model.graph->edge(e).border()) folded[name_of(facets, model.graph->edge(e))] = model.folds[e] != 0;
  std::size_t common = 0, inner = 0, changed = 0;
  for (Index e = 0; e < graph->edge_count(); ++e) {
    if (graph->edge(e).border()) continue;
    ++inner;
    const auto found = folded.find(name_of(after, graph->edge(e)));
    if (found == folded.end()) continue;
    ++common;
    changed += found->second != (back->folds[e] != 0) ? 1 : 0;
  }
  EXPECT_GT(common, inner / 2) << "of " << inner << " edges";
  EXPECT_EQ(changed, 0U);
}

}  // namespace
}  // namespace hariko::test
