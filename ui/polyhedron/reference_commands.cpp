// Commands of reference facets, as a scan is: those that bring the vertices of a polyhedron, or its surface,
// to them, and the one that makes fewer of them.

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/approximation/decimation/decimate.hpp"
#include "core/base/assert.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/document/object_box.hpp"
#include "core/exchange/repair/triangulate.hpp"
#include "core/modeling/surfacing/fit_to_reference.hpp"
#include "core/modeling/surfacing/project_to_reference.hpp"
#include "ui/base/quantity.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/last_operation.hpp"
#include "ui/editor/operations.hpp"
#include "ui/widgets/option_fields.hpp"

namespace hariko {

namespace {

bool is_shown_reference(const Object& object) {
  return object.visible && object.mesh();
}

using SharedObjects = std::vector<std::shared_ptr<const Object>>;

/// The references that are chosen, else all that are shown.
SharedObjects references_of(const Editor& editor) {
  SharedObjects chosen, shown;
  for (const auto& object : editor.history.current().objects) {
    if (!is_shown_reference(*object)) continue;
    shown.push_back(object);
    if (editor.selection.objects().contains(object->id)) chosen.push_back(object);
  }
  return chosen.empty() ? shown : chosen;
}

/// Polyhedron that is brought to references, all as they are when that begins.
struct ReferenceTask {
  std::shared_ptr<const Object> object;
  SharedObjects references;
  std::vector<VertexId> vertices;  ///< those that may move
};

/// Whether everything still is as when the task began.
bool still_holds(const ReferenceTask& task, const Document& document) {
  const auto same = [&](const std::shared_ptr<const Object>& then) {
    const auto now = document.find_shared(then->id);
    return now == then || (now && now->source == then->source && now->transform == then->transform);
  };
  return same(task.object) && std::ranges::all_of(task.references, same);
}

using Facets = std::shared_ptr<const ReferenceFacets>;

/// Facets of the references as they are seen from the object.
Facets seen_facets(const ReferenceTask& task) {
  std::vector<FaceTriangles> cut;
  std::vector<FacetPart> parts;
  for (const auto& reference : task.references) cut.push_back(triangulate(*reference->mesh()->mesh));
  for (std::size_t i = 0; i < task.references.size(); ++i) {
    const MeshSource& source = *task.references[i]->mesh();
    parts.push_back({source.mesh->positions, cut[i].triangles, source.origin, task.references[i]->transform});
  }
  const Object& object = *task.object;
  return std::make_shared<const ReferenceFacets>(parts, object.polyhedron()->origin, object.transform);
}

/// Polyhedron at the references, and the notice that tells of it.
struct BroughtToReference {
  PolyhedronSource source;
  std::function<void(Editor&)> say;  ///< may be empty
};
/// Brings the object of a task to the references, in so many steps where it takes any.
using BringToReference = std::function<Result<BroughtToReference>(
    const ReferenceTask&, const ReferenceFacets&, int steps, const CancelToken&, const Progress&)>;

/// Results of one task by their numbers of steps, so that each is made once while the number is adjusted. For
/// the main thread.
struct ReferenceResults {
  ReferenceTask task;
  BringToReference bring;
  Facets facets = {};  ///< null before the first result
  std::map<int, Result<BroughtToReference>> by_steps = {};
};

int steps_of(std::span<const OperationNumber> numbers) {
  return numbers.empty() ? 0 : static_cast<int>(numbers[0].value);
}

/// Work that gives the results one more, unless it is there. `what`: names it, with a place for the object.
PrepareOperation preparing_results(const std::shared_ptr<ReferenceResults>& results, const char* what) {
  return [results, what](const Document& document,
                         std::span<const OperationNumber> numbers) -> std::optional<LongEdit> {
    const int steps = steps_of(numbers);
    const ReferenceTask& task = results->task;
    if (results->by_steps.contains(steps) && still_holds(task, document)) return std::nullopt;
    const auto work = [results, steps, task, bring = results->bring, facets = results->facets](
                          const CancelToken& cancel, const Progress& progress) -> LongEdit::Then {
      const Facets seen = facets ? facets : seen_facets(task);
      const auto made =
          std::make_shared<const Result<BroughtToReference>>(bring(task, *seen, steps, cancel, progress));
      return [results, steps, seen, made] {
        results->facets = seen;
        results->by_steps.insert_or_assign(steps, *made);
      };
    };
    return LongEdit{Phrase(what, {task.object->name}), task.object->id, work};
  };
}

MakeOperation taking_results(const std::shared_ptr<ReferenceResults>& results) {
  return [results](const Document& document,
                   std::span<const OperationNumber> numbers) -> Result<OperationResult> {
    const auto known = results->by_steps.find(steps_of(numbers));
    HARIKO_ASSERT(known != results->by_steps.end(), "the result is prepared before the step is made");
    const Result<BroughtToReference>& brought = known->second;
    auto done = edit_polyhedron(document, results->task.object->id,
                                [&](const PolyhedronSource&) -> Result<EditResult> {
                                  if (!brought) return brought.error();
                                  return EditResult{brought->source, {}};
                                });
    if (!done) return done.error();
    OperationResult out{std::move(done->document), results->task.object->id};
    out.keeps_selection = true;
    out.say = brought->say;
    return out;
  };
}

/// Begins to bring vertices of the active polyhedron to the references, or says at once why none may move.
Result<BegunOperation> begin_bringing(const Editor& editor, const WhyNot& why_not,
                                      std::vector<VertexId> (*vertices_of)(const Editor&), const char* what,
                                      BringToReference bring, WriteOperation written) {
  if (const Reason reason = why_not()) return make_error(e_wrong_selection, *reason);
  const Document& document = editor.history.current();
  ReferenceTask task{document.find_shared(editor.selection.active), references_of(editor),
                     vertices_of(editor)};
  const auto allowed =
      edit_polyhedron(document, task.object->id, [&](const PolyhedronSource& source) -> Result<EditResult> {
        if (const auto moving = vertices_to_move(source, task.vertices); !moving) return moving.error();
        return EditResult{source, {}};
      });
  if (!allowed) return allowed.error();
  const auto results =
      std::make_shared<ReferenceResults>(ReferenceResults{std::move(task), std::move(bring)});
  return BegunOperation{taking_results(results), {}, std::move(written), preparing_results(results, what)};
}

void run_bringing(Editor& editor, const char* label, std::vector<OperationNumber> numbers,
                  Result<BegunOperation> (*begin)(const Editor&)) {
  auto begun = begin(editor);
  if (!begun) return editor.notify(begun.error());
  OperationStep step;
  step.label = label;
  step.numbers = std::move(numbers);
  step.make = begun->make;
  step.begin = begin;
  step.written = begun->written;
  step.prepare = begun->prepare;
  editor.last_operation.run(editor, std::move(step));
}

WhyNot with_a_reference(const Editor& editor, WhyNot first) {
  return only_if(
      std::move(first), [&editor] { return !references_of(editor).empty(); },
      translatable("No reference facets are shown. Import a scan as reference facets, or show it."));
}

// Projection.

WhyNot needs_projectable(const Editor& editor) {
  return with_a_reference(editor, needs_elements(editor, {.vertices = true, .edges = true, .faces = true}));
}

std::vector<VertexId> vertices_to_project(const Editor& editor) {
  return touched_vertices(editor.selection.of_active(), editor.active_object()->polyhedron()->polyhedron);
}

Result<BroughtToReference> brought_by_projection(const ReferenceTask& task, const ReferenceFacets& facets,
                                                 int, const CancelToken&, const Progress&) {
  const PolyhedronSource& source = *task.object->polyhedron();
  auto done = project_to_reference(source, task.vertices, facets);
  if (!done) return done.error();
  BroughtToReference out{std::move(done).value().source, {}};
  if (out.source == source)
    out.say = [](Editor& now) { now.inform("The vertices lie on the reference already."); };
  return out;
}

std::vector<WrittenCommand> written_projection(std::span<const OperationNumber>) {
  return {WrittenCommand{"mesh.project_reference"}};
}

Result<BegunOperation> begin_projection(const Editor& editor) {
  return begin_bringing(editor, needs_projectable(editor), vertices_to_project,
                        translatable("Projecting {0}"), brought_by_projection, written_projection);
}

void run_projection(Editor& editor) {
  run_bringing(editor, translatable("Project onto the reference"), {}, begin_projection);
}

// Fit.

WhyNot needs_fittable(const Editor& editor) {
  return with_a_reference(editor, needs_polyhedron(editor));
}

std::vector<OperationNumber> fit_numbers() {
  return {{"steps", translatable("Steps"), double(FitOptions{}.steps), 1, max_fit_steps, true}};
}

/// Vertices that are touched by what is selected; all where nothing is, or whole objects are.
std::vector<VertexId> vertices_to_fit(const Editor& editor) {
  const Polyhedron& polyhedron = editor.active_object()->polyhedron()->polyhedron;
  std::vector<VertexId> ids;
  if (editor.mode != ElementMode::object) ids = touched_vertices(editor.selection.of_active(), polyhedron);
  if (ids.empty())
    for (Index v = 0; v < polyhedron.vertex_count(); ++v) ids.push_back(polyhedron.vertex_id(v));
  return ids;
}

/// Notice with the distances before and after a fit, in lengths of the document.
void say_fit(Editor& editor, const ReferenceDistance& before, const ReferenceDistance& after, bool nearer,
             double scale) {
  const auto length = [&](double in_object) {
    return format_quantity(measured_length(editor.document().unit, scale * in_object), scale * in_object);
  };
  if (nearer)
    return editor.inform(
        {"The surface was off the reference by {0} on average and by {1} at most. Now it is {2} and {3}.",
         {length(before.mean), length(before.largest), length(after.mean), length(after.largest)}});
  editor.inform(
      {"Moving these vertices brings the surface no nearer to the reference: it is off by {0} on "
       "average and by {1} at most.",
       {length(before.mean), length(before.largest)}});
}

Result<BroughtToReference> brought_by_fit(const ReferenceTask& task, const ReferenceFacets& facets, int steps,
                                          const CancelToken& cancel, const Progress& progress) {
  const auto fit =
      fit_to_reference(*task.object->polyhedron(), task.vertices, facets, {steps}, cancel, progress);
  if (!fit) return fit.error();
  return BroughtToReference{fit->source, [before = fit->before, after = fit->after, nearer = fit->steps > 0,
                                          scale = task.object->transform.scale](Editor& now) {
                              say_fit(now, before, after, nearer, scale);
                            }};
}

std::vector<WrittenCommand> written_fit(std::span<const OperationNumber> numbers) {
  return {WrittenCommand{"mesh.fit_reference", written_numbers(numbers)}};
}

Result<BegunOperation> begin_fit(const Editor& editor) {
  return begin_bringing(editor, needs_fittable(editor), vertices_to_fit, translatable("Fitting {0}"),
                        brought_by_fit, written_fit);
}

void run_fit(Editor& editor, std::vector<OperationNumber> numbers) {
  run_bringing(editor, translatable("Fit to the reference"), std::move(numbers), begin_fit);
}

// Reduction.

/// Fewer facets in the place of others, and how far they are off, in the object's space.
struct Reduction {
  MeshSource source;
  double distance = 0;
};

/// Results for one object by their distances, so that each is made once while the number is adjusted. For the
/// main thread.
struct ReductionResults {
  std::shared_ptr<const Object> object;
  std::map<double, Result<Reduction>> by_distance = {};
};

Result<Reduction> reduced_facets(const Object& object, double distance, const CancelToken& cancel,
                                 const Progress& progress) {
  const MeshSource& source = *object.mesh();
  const TriangleMesh dense{
      source.origin, source.mesh->positions, triangulate(*source.mesh).triangles, {}, {}};
  MeshOptions options;
  options.criteria.distance = distance / object.transform.scale;
  auto made = decimate(dense, options, cancel, progress);
  if (!made) return made.error();
  const CriterionErrors& off = made->distance;
  Reduction out{source, off.certified ? std::max(off.bound, off.largest) : off.largest};
  PolygonMesh fewer;
  for (const auto& triangle : made->mesh.triangles) fewer.add_face({triangle[0], triangle[1], triangle[2]});
  fewer.positions = std::move(made.value().mesh.positions);
  out.source.origin = made->mesh.origin;
  out.source.mesh = Shared<PolygonMesh>(std::move(fewer));
  return out;
}

PrepareOperation preparing_reduction(const std::shared_ptr<ReductionResults>& results) {
  return [results](const Document& document,
                   std::span<const OperationNumber> numbers) -> std::optional<LongEdit> {
    const double distance = numbers[0].value;
    const std::shared_ptr<const Object> object = results->object;
    const auto now = document.find_shared(object->id);
    const bool same = now && now->source == object->source && now->transform == object->transform;
    if (same && results->by_distance.contains(distance)) return std::nullopt;
    const auto work = [results, object, distance](const CancelToken& cancel,
                                                  const Progress& progress) -> LongEdit::Then {
      const auto made =
          std::make_shared<const Result<Reduction>>(reduced_facets(*object, distance, cancel, progress));
      return [results, distance, made] { results->by_distance.insert_or_assign(distance, *made); };
    };
    return LongEdit{Phrase(translatable("Reducing {0}"), {object->name}), object->id, work};
  };
}

/// Notice with the numbers of facets, and with the distance in the document.
void say_reduction(Editor& editor, std::size_t before, std::size_t after, double distance) {
  editor.inform({"{0} facets became {1}, which are off by {2} at the most.",
                 {std::to_string(before), std::to_string(after),
                  format_quantity(measured_length(editor.document().unit, distance), distance)}});
}

MakeOperation taking_reduction(const std::shared_ptr<ReductionResults>& results) {
  return [results](const Document& document,
                   std::span<const OperationNumber> numbers) -> Result<OperationResult> {
    const auto known = results->by_distance.find(numbers[0].value);
    HARIKO_ASSERT(known != results->by_distance.end(), "the result is prepared before the step is made");
    const Result<Reduction>& reduction = known->second;
    if (!reduction) return reduction.error();
    const Object& object = *results->object;
    auto done = set_source(document, object.id, reduction->source);
    if (!done) return done.error();
    OperationResult out{std::move(done).value(), object.id};
    out.keeps_selection = true;
    out.say = [before = object.mesh()->mesh->face_count(), after = reduction->source.mesh->face_count(),
               distance = object.transform.scale * reduction->distance](Editor& now) {
      say_reduction(now, before, after, distance);
    };
    return out;
  };
}

WhyNot needs_facets(const Editor& editor) {
  return only_if(
      needs_object(editor), [&editor] { return editor.active_object()->mesh() != nullptr; },
      translatable("The chosen object has no reference facets. Choose a scan in the list of objects."));
}

std::vector<WrittenCommand> written_reduction(std::span<const OperationNumber> numbers) {
  return {WrittenCommand{"mesh.reduce_reference", written_numbers(numbers)}};
}

Result<BegunOperation> begin_reduction(const Editor& editor) {
  if (const Reason reason = needs_facets(editor)()) return make_error(e_wrong_selection, *reason);
  const Document& document = editor.history.current();
  const auto results = std::make_shared<ReductionResults>();
  results->object = document.find_shared(editor.selection.active);
  if (const auto allowed = set_source(document, results->object->id, results->object->source); !allowed)
    return allowed.error();
  return BegunOperation{taking_reduction(results), {}, written_reduction, preparing_reduction(results)};
}

/// A distance that an eye hardly notices where the whole object is in sight.
std::vector<OperationNumber> reduction_numbers(const Editor& editor) {
  constexpr double usual = 5e-4, finest = 1e-7;
  const double size = world_box(*editor.active_object()).diagonal().norm();
  return {{"distance", translatable("Distance"), one_digit(usual * size), finest * size, size}};
}

}  // namespace

void add_reference_commands(CommandHost& host) {
  Editor& editor = host.editor;
  MenuRows rows(host.table, submenu("Mesh", translatable("Reference facets")));
  rows.add_edit(
      "mesh.project_reference", "Project onto the reference",
      "Move the selected vertices to the nearest points of the scan: of the chosen reference facets, or of "
      "all that are shown.",
      [&editor] { run_projection(editor); }, needs_projectable(editor),
      {.separator_before = true, .contexts = any_element});
  rows.add_edit(
      "mesh.fit_reference", "Fit to the reference",
      "Move the selected vertices, or all, so that the surface is nearest to the scan, the shown reference "
      "facets.",
      [&editor] { run_fit(editor, fit_numbers()); }, needs_fittable(editor),
      {.contexts = any_element,
       .script = {.arguments = arguments_of(fit_numbers()), .run = [&editor](const Arguments& given) {
                    run_fit(editor, with_values(fit_numbers(), given));
                  }}});
  const auto reduce = [&editor](std::vector<OperationNumber> numbers) {
    run_bringing(editor, translatable("Reduce the reference"), std::move(numbers), begin_reduction);
  };
  rows.add_edit(
      "mesh.reduce_reference", "Reduce the reference",
      "Make fewer facets of the chosen scan, which are certainly no farther from it than a distance.",
      [&editor, reduce] { reduce(reduction_numbers(editor)); }, needs_facets(editor),
      {.script = {.arguments = {length_argument("distance", translatable("Distance"), {},
                                                std::numeric_limits<double>::min())},
                  .run = [&editor, reduce](const Arguments& given) {
                    std::vector<OperationNumber> numbers = reduction_numbers(editor);
                    numbers[0].value = given.number("distance");
                    reduce(std::move(numbers));
                  }}});
}

}  // namespace hariko
