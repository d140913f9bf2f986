// Every operation of the modeler as a step of a document: a valid manifold that undo takes back to an equal
// document and redo brings again, or a refusal with a code that changes nothing. What each makes of the Euler
// number beyond keeping it is tested beside the operation.

#include <functional>

#include "core/document/edits/edits.hpp"
#include "core/document/history/history.hpp"
#include "core/modeling/cuts/bisect.hpp"
#include "core/modeling/cuts/cut.hpp"
#include "core/modeling/cuts/cut_faces.hpp"
#include "core/modeling/cuts/knife_path.hpp"
#include "core/modeling/cuts/loop_cut.hpp"
#include "core/modeling/cuts/subdivide.hpp"
#include "core/modeling/objects/edit_modeling.hpp"
#include "core/modeling/operations/bevel_edges.hpp"
#include "core/modeling/operations/bevel_vertices.hpp"
#include "core/modeling/operations/bridge.hpp"
#include "core/modeling/operations/delete_elements.hpp"
#include "core/modeling/operations/dissolve.hpp"
#include "core/modeling/operations/extrude.hpp"
#include "core/modeling/operations/fill_hole.hpp"
#include "core/modeling/operations/flip.hpp"
#include "core/modeling/operations/inset.hpp"
#include "core/modeling/operations/merge_vertices.hpp"
#include "core/modeling/operations/separate.hpp"
#include "core/modeling/surfacing/project_to_reference.hpp"
#include "tests/modeling/support.hpp"

namespace hariko::test {
namespace {

using Rng = std::mt19937_64;

struct Operation {
  const char* name;
  std::function<Result<EditResult>(const PolyhedronSource&, Rng&)> run;
  bool keeps_euler = true;
  int least = 50;  ///< number out of 300 meshes on which it must succeed
};

EdgeId some_edge(const PolyhedronSource& source, Rng& rng) {
  return source.polyhedron.edge_id(static_cast<Index>(rng() % source.polyhedron.edge_count()));
}
FaceId some_face(const PolyhedronSource& source, Rng& rng) {
  return source.polyhedron.face_id(static_cast<Index>(rng() % source.polyhedron.face_count()));
}
VertexId corner_of(const PolyhedronSource& source, FaceId face, Rng& rng) {
  const auto corners = source.polyhedron.topology().face_vertices(source.polyhedron.find(face));
  return source.polyhedron.vertex_id(corners[rng() % corners.size()]);
}
double amount(const PolyhedronSource& source, Rng& rng) {
  return random_amount(rng, size_of(source) / 10);
}

/// Between two points of any edges, in any plane through them.
Result<EditResult> straight_cut(const PolyhedronSource& source, Rng& rng) {
  const CutPoint from = EdgePoint{some_edge(source, rng), uniform(rng, 0.05, 0.95)};
  const CutPoint to = chance(rng, 0.3)
                          ? CutPoint(corner_of(source, some_face(source, rng), rng))
                          : CutPoint(EdgePoint{some_edge(source, rng), uniform(rng, 0.05, 0.95)});
  const Vector3 way = position_of(source.polyhedron, to) - position_of(source.polyhedron, from);
  const auto between = knife_path(source.polyhedron, from, to, way.cross(random_vector(rng)));
  if (!between) return between.error();
  std::vector<CutPoint> path{from};
  path.insert(path.end(), between->begin(), between->end());
  path.push_back(to);
  return cut_path(source, path);
}

std::vector<Operation> making() {
  return {
      {"extrude",
       [](const auto& s, Rng& rng) {
         return extrude_faces(s, random_faces(s, rng),
                              {amount(s, rng), chance(rng, 0.5) ? Grouping::region : Grouping::individual});
       },
       false},
      {"extrude borders",
       [](const auto& s, Rng& rng) { return extrude_borders(s, border_edges(s.polyhedron), amount(s, rng)); },
       true, 20},
      {"inset",
       [](const auto& s, Rng& rng) {
         return inset_faces(s, random_faces(s, rng),
                            {uniform(rng, 0, 0.9), InsetOptions::Measure::share,
                             chance(rng, 0.5) ? Grouping::region : Grouping::individual});
       },
       false},
      {"bevel vertices",
       [](const auto& s, Rng& rng) {
         return bevel_vertices(s, random_vertices(s, rng),
                               {uniform(rng, 0, 0.6), BevelVerticesOptions::Measure::share});
       }},
      {"bevel edges",
       [](const auto& s, Rng& rng) {
         const auto edges = random_edges(s, rng);
         const auto limit = largest_edge_bevel(s, edges);
         return bevel_edges(s, edges, limit ? *limit * uniform(rng, 0.01, 1.1) : amount(s, rng));
       }},
      {"loop cut",
       [](const auto& s, Rng& rng) {
         return loop_cut(s, some_edge(s, rng), {uniform_int(rng, 0, 4), uniform(rng, -1, 1)});
       }},
      {"connect", [](const auto& s,
                     Rng& rng) { return connect_points(s, random_vertices(s, rng), random_edges(s, rng)); }},
      {"knife", straight_cut},
      {"split face",
       [](const auto& s, Rng& rng) {
         const FaceId face = some_face(s, rng);
         return split_face(s, face, corner_of(s, face, rng), corner_of(s, face, rng));
       },
       true, 20},
      {"subdivide",
       [](const auto& s, Rng& rng) {
         return chance(rng, 0.5) ? subdivide_faces(s, random_faces(s, rng))
                                 : subdivide_edges(s, random_edges(s, rng));
       }},
      {"poke", [](const auto& s, Rng& rng) { return poke_faces(s, random_faces(s, rng)); }},
  };
}

std::vector<Operation> tidying() {
  return {
      {"triangulate", [](const auto& s, Rng& rng) { return triangulate_faces(s, random_faces(s, rng)); }},
      {"decompose", [](const auto& s, Rng& rng) { return decompose_concave_faces(s, random_faces(s, rng)); },
       true, 1},
      {"dissolve vertices",
       [](const auto& s, Rng& rng) { return dissolve_vertices(s, random_vertices(s, rng)); }, false, 20},
      {"dissolve edges", [](const auto& s, Rng& rng) { return dissolve_edges(s, random_edges(s, rng)); },
       false, 20},
      {"dissolve faces", [](const auto& s, Rng& rng) { return dissolve_faces(s, random_faces(s, rng)); },
       false, 20},
      {"delete vertices", [](const auto& s, Rng& rng) { return delete_vertices(s, random_vertices(s, rng)); },
       false, 20},
      {"delete edges", [](const auto& s, Rng& rng) { return delete_edges(s, random_edges(s, rng)); }, false,
       20},
      {"delete faces", [](const auto& s, Rng& rng) { return delete_faces(s, random_faces(s, rng)); }, false,
       20},
      {"merge",
       [](const auto& s, Rng& rng) {
         constexpr std::array at{MergeAt::centre, MergeAt::first, MergeAt::last};
         const EdgeId edge = some_edge(s, rng);
         std::vector<VertexId> ids{edge.low, edge.high};
         if (chance(rng, 0.3)) ids = random_vertices(s, rng);
         return merge_vertices(s, ids, at[rng() % 3]);
       },
       false},
      {"merge by distance",
       [](const auto& s, Rng& rng) {
         return merge_by_distance(s, random_vertices(s, rng), size_of(s) * log_uniform(rng, 1e-3, 0.3));
       },
       false, 5},
      {"collapse",
       [](const auto& s, Rng& rng) { return collapse_edges(s, std::vector<EdgeId>{some_edge(s, rng)}); },
       false},
      {"bridge faces",
       [](const auto& s, Rng& rng) { return bridge_faces(s, some_face(s, rng), some_face(s, rng)); }, false,
       20},
      {"bridge borders", [](const auto& s, Rng&) { return bridge_borders(s, border_edges(s.polyhedron)); },
       false, 1},
      {"fill hole",
       [](const auto& s, Rng& rng) {
         const auto borders = border_edges(s.polyhedron);
         const EdgeId edge = borders.empty() ? some_edge(s, rng) : borders[rng() % borders.size()];
         return fill_holes(s, std::vector<EdgeId>{edge});
       },
       false, 20},
      {"flip",
       [](const auto& s, Rng& rng) {
         return flip_faces(s, chance(rng, 0.7) ? all_faces(s) : random_faces(s, rng));
       }},
      {"halve",
       [](const auto& s, Rng& rng) {
         const Mirror mirror{static_cast<Axis>(uniform_int(rng, 0, 2)), 1e-6 * size_of(s)};
         return halved(s, mirror);
       },
       false, 20},
      {"duplicate faces", [](const auto& s, Rng& rng) { return duplicate_faces(s, random_faces(s, rng)); },
       false},
      {"separate faces", [](const auto& s, Rng& rng) { return separate_faces(s, random_faces(s, rng)); },
       false, 20},
      {"project",
       [](const auto& s, Rng& rng) {
         const double size = size_of(s);
         const std::vector<Vector3> sheet{random_vector(rng, size), random_vector(rng, size),
                                          random_vector(rng, size)};
         const std::vector<std::array<Index, 3>> triangle{{0, 1, 2}};
         const FacetPart part{sheet, triangle, s.origin, {}};
         return project_to_reference(s, random_vertices(s, rng), ReferenceFacets({&part, 1}, s.origin, {}));
       }},
  };
}

void expect_steps(const Operation& operation, std::uint64_t seed) {
  SCOPED_TRACE(operation.name);
  int done = 0;
  for_random(seed, 300, [&](Rng& rng) {
    Document before = document_from_mesh(cube(), "Shape").value();
    const ObjectId id = before.objects[0]->id;
    before = set_source(before, id, random_shape_source(rng)).value();
    const PolyhedronSource source = *before.objects[0]->polyhedron();
    History history(before);
    const auto result =
        edit_polyhedron(before, id, [&](const PolyhedronSource& s) { return operation.run(s, rng); });
    EXPECT_TRUE(history.current() == before) << "operations are pure";
    if (!result) {
      EXPECT_TRUE(result.error().code.name.starts_with("E_")) << to_string(result.error());
      EXPECT_FALSE(result.error().text.empty());
      return;
    }
    ++done;
    const PolyhedronSource& after = *result->document.find(id)->polyhedron();
    EXPECT_TRUE(HalfEdgeMesh::build(after.polyhedron.to_mesh()).ok());
    for (Index v = 0; v < after.polyhedron.vertex_count(); ++v) {
      EXPECT_TRUE(after.polyhedron.position(v).allFinite());
      EXPECT_NE(after.polyhedron.topology().outgoing(v), no_index);
    }
    if (operation.keeps_euler) {
      EXPECT_EQ(euler(after), euler(source));
    }
    if (!history.push(result->document, operation.name)) {
      EXPECT_TRUE(result->document == before) << "only what changes nothing makes no step";
      return;
    }
    ASSERT_TRUE(history.undo());
    EXPECT_TRUE(history.current() == before);
    ASSERT_TRUE(history.redo());
    EXPECT_TRUE(history.current() == result->document);
  });
  EXPECT_GE(done, repetitions(operation.least));
}

TEST(EveryOperation, ThatMakesIsAStepOrARefusal) {
  std::uint64_t seed = 20'000;
  for (const Operation& operation : making()) expect_steps(operation, seed += 1000);
}

TEST(EveryOperation, ThatTidiesIsAStepOrARefusal) {
  std::uint64_t seed = 60'000;
  for (const Operation& operation : tidying()) expect_steps(operation, seed += 1000);
}

}  // namespace
}  // namespace hariko::test
