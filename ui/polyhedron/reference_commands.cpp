// Commands that bring a polyhedron to reference facets, as a scan is: its vertices, or its surface.

#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "core/exchange/repair/triangulate.hpp"
#include "core/modeling/surfacing/fit_to_reference.hpp"
#include "core/modeling/surfacing/project_to_reference.hpp"
#include "ui/base/quantity.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/operation_arguments.hpp"
#include "ui/editor/operations.hpp"

namespace hariko {

namespace {

using Facets = std::shared_ptr<const ReferenceFacets>;

bool is_shown_reference(const Object& object) {
  return object.visible && object.mesh();
}

/// The references that are chosen, else all that are shown.
std::vector<const Object*> references_of(const Editor& editor) {
  std::vector<const Object*> chosen, shown;
  for (const auto& object : editor.history.current().objects) {
    if (!is_shown_reference(*object)) continue;
    shown.push_back(object.get());
    if (editor.selection.objects().contains(object->id)) chosen.push_back(object.get());
  }
  return chosen.empty() ? shown : chosen;
}

/// Their facets as they are seen from an object with a polyhedron.
Facets facets_seen_from(const Object& object, const std::vector<const Object*>& references) {
  std::vector<FaceTriangles> cut;
  std::vector<FacetPart> parts;
  for (const Object* reference : references) cut.push_back(triangulate(*reference->mesh()->mesh));
  for (std::size_t i = 0; i < references.size(); ++i) {
    const MeshSource& source = *references[i]->mesh();
    parts.push_back({source.mesh->positions, cut[i].triangles, source.origin, references[i]->transform});
  }
  return std::make_shared<const ReferenceFacets>(parts, object.polyhedron()->origin, object.transform);
}

WhyNot with_a_reference(const Editor& editor, WhyNot first) {
  return only_if(
      std::move(first), [&editor] { return !references_of(editor).empty(); },
      translatable("No reference facets are shown. Import a scan as reference facets, or show it."));
}

WhyNot needs_projectable(const Editor& editor) {
  return with_a_reference(editor, needs_elements(editor, {.vertices = true, .edges = true, .faces = true}));
}

void project_selected(Editor& editor) {
  const Object& object = *editor.active_object();
  const auto ids = touched_vertices(editor.selection.of_active(), object.polyhedron()->polyhedron);
  const auto done = edit_polyhedron(editor.history.current(), object.id, [&](const PolyhedronSource& source) {
    return project_to_reference(source, ids, *facets_seen_from(object, references_of(editor)));
  });
  if (!done) return editor.notify(done.error());
  if (!editor.commit(Result<Document>(done->document), translatable("Project onto the reference")))
    editor.notify(Notice::Kind::info, editor.language("The vertices lie on the reference already."));
}

std::vector<OperationNumber> fit_numbers() {
  return {{"steps", translatable("Steps"), double(FitOptions{}.steps), 1, max_fit_steps, true}};
}

/// Notice with the distances before and after a fit, in lengths of the document.
void say_fit(Editor& editor, const ReferenceFit& fit, double scale) {
  const auto length = [&](double in_object) {
    return format_quantity(measured_length(editor.document().unit, scale * in_object), scale * in_object);
  };
  const ReferenceDistance &before = fit.before, &after = fit.after;
  editor.notify(
      Notice::Kind::info,
      fit.steps == 0
          ? fill(editor.language(
                     "Moving these vertices brings the surface no nearer to the reference: it is off by "
                     "{0} on average and by {1} at most."),
                 {length(before.mean), length(before.largest)})
          : fill(editor.language(
                     "The surface was off the reference by {0} on average and by {1} at most. Now it "
                     "is {2} and {3}."),
                 {length(before.mean), length(before.largest), length(after.mean), length(after.largest)}));
}

std::vector<WrittenCommand> written_fit(std::span<const OperationNumber> numbers) {
  return {WrittenCommand{"mesh.fit_reference", written_numbers(numbers)}};
}

/// Fits of one polyhedron by their numbers of steps, so that each is made once while the number is adjusted.
class KnownFits {
 public:
  KnownFits(Facets facets, std::vector<VertexId> vertices)
      : facets_(std::move(facets)), vertices_(std::move(vertices)) {}

  Result<std::shared_ptr<const ReferenceFit>> of(const PolyhedronSource& source, int steps) {
    if (!source_ || !(*source_ == source)) fits_.clear();
    source_ = source;
    if (const auto known = fits_.find(steps); known != fits_.end()) return known->second;
    auto fit = fit_to_reference(source, vertices_, *facets_, {steps});
    if (!fit) return fit.error();
    return fits_[steps] = std::make_shared<const ReferenceFit>(std::move(fit).value());
  }

 private:
  Facets facets_;
  std::vector<VertexId> vertices_;
  std::optional<PolyhedronSource> source_;
  std::map<int, std::shared_ptr<const ReferenceFit>> fits_;
};

/// A fit of the vertices that are touched by what is selected; of all where nothing is, or whole objects are.
BegunOperation fitting(const Editor& editor) {
  const Object& object = *editor.active_object();
  const Polyhedron& polyhedron = object.polyhedron()->polyhedron;
  std::vector<VertexId> ids;
  if (editor.mode != ElementMode::object) ids = touched_vertices(editor.selection.of_active(), polyhedron);
  if (ids.empty())
    for (Index v = 0; v < polyhedron.vertex_count(); ++v) ids.push_back(polyhedron.vertex_id(v));
  const auto fits =
      std::make_shared<KnownFits>(facets_seen_from(object, references_of(editor)), std::move(ids));
  const auto make = [fits, id = object.id, scale = object.transform.scale](
                        const Document& document,
                        std::span<const OperationNumber> numbers) -> Result<OperationResult> {
    std::shared_ptr<const ReferenceFit> fit;
    auto done = edit_polyhedron(document, id, [&](const PolyhedronSource& source) -> Result<EditResult> {
      const auto found = fits->of(source, static_cast<int>(numbers[0].value));
      if (!found) return found.error();
      fit = *found;
      return EditResult{fit->source, {}};
    });
    if (!done) return done.error();
    OperationResult out{std::move(done->document), id};
    out.keeps_selection = true;
    out.say = [fit, scale](Editor& now) { say_fit(now, *fit, scale); };
    return out;
  };
  return {make, {}, written_fit};
}

WhyNot needs_fittable(const Editor& editor) {
  return with_a_reference(editor, needs_polyhedron(editor));
}

void run_fit(Editor& editor, std::vector<OperationNumber> numbers) {
  OperationStep step;
  step.label = translatable("Fit to the reference");
  step.numbers = std::move(numbers);
  step.make = fitting(editor).make;
  step.begin = [](const Editor& now) -> Result<BegunOperation> {
    if (const Reason reason = needs_fittable(now)()) return make_error(e_wrong_selection, *reason);
    return fitting(now);
  };
  step.written = written_fit;
  editor.last_operation.run(editor, std::move(step));
}

}  // namespace

void add_reference_commands(CommandHost& host) {
  Editor& editor = host.editor;
  host.table.add({.id = "mesh.project_reference",
                  .menu = submenu("Mesh", translatable("Reference facets")),
                  .label = "Project onto the reference",
                  .help =
                      "Move the selected vertices to the nearest points of the scan: of the chosen reference "
                      "facets, or of all that are shown.",
                  .changes_document = true,
                  .separator_before = true,
                  .run = [&editor] { project_selected(editor); },
                  .why_not = needs_projectable(editor),
                  .contexts = any_element});
  host.table.add(
      {.id = "mesh.fit_reference",
       .menu = submenu("Mesh", translatable("Reference facets")),
       .label = "Fit to the reference",
       .help = "Move the selected vertices, or all, so that the surface is nearest to the scan, the shown "
               "reference facets.",
       .changes_document = true,
       .run = [&editor] { run_fit(editor, fit_numbers()); },
       .why_not = needs_fittable(editor),
       .contexts = any_element,
       .script = {.arguments = arguments_of(fit_numbers()), .run = [&editor](const Arguments& given) {
                    run_fit(editor, with_values(fit_numbers(), given));
                  }}});
}

}  // namespace hariko
