#include "app/engines/paper_engine.hpp"

#include <algorithm>

#include "app/files/model_facets.hpp"
#include "core/unfolding/cut_large_faces.hpp"
#include "core/unfolding/paper_document.hpp"
#include "ui/editor/paper_edits.hpp"

namespace hariko {

namespace {

constexpr std::size_t most_faults = 100;

/// Lines that show the places of faults.
std::vector<std::array<Vector3, 2>> lines_of(const std::vector<Message>& faults, const PolygonMesh& mesh) {
  std::vector<std::array<Vector3, 2>> out;
  const auto line = [&](std::uint64_t a, std::uint64_t b) {
    if (a < mesh.positions.size() && b < mesh.positions.size())
      out.push_back({mesh.positions[a], mesh.positions[b]});
  };
  for (const Message& fault : faults) {
    const std::uint64_t id = fault.element.id;
    if (fault.element.kind == Element::Kind::edge) line(id >> 32, id & 0xffffffffU);
    if (fault.element.kind != Element::Kind::face || id >= mesh.face_count()) continue;
    const auto face = mesh.face(id);
    for (std::size_t k = 0; k < face.size(); ++k) line(face[k], face[(k + 1) % face.size()]);
  }
  return out;
}

/// Name of a corner of divided facets: its number, which is the same for the same facets and paper.
PaperVertex name_of_cut(std::size_t number) {
  PaperVertex name;
  name.object = ObjectId{no_index};
  name.side = static_cast<std::uint32_t>(number);
  return name;
}

/// Facets divided to fit this paper; `before` where it is divided for these settings already.
MadePaperMesh on_paper(std::shared_ptr<const PaperFacets> whole, const PaperSettings& settings,
                       const std::shared_ptr<const PaperMesh>& before = nullptr) {
  MadePaperMesh out;
  out.mesh = before;
  auto made = cut_large_faces(whole->mesh, settings);
  // Without valid paper settings the undivided facets are kept: the settings can be corrected.
  if (!made.ok()) out.fault.messages = {made.error()};
  if (before && (!made.ok() || (before->cut == 0 && made->cut == 0))) return out;
  const CutFaces cut = made.ok() ? std::move(made).value() : CutFaces{whole->mesh, 0};
  auto graph = FacetGraph::build(cut.mesh);
  if (!graph.ok()) {
    out.fault.messages = {graph.error()};
    return out;
  }
  if (before && graph->positions() == before->graph->positions()) return out;
  std::vector<PaperVertex> names = whole->names;
  for (std::size_t v = names.size(); v < cut.mesh.positions.size(); ++v)
    names.push_back(name_of_cut(v - whole->names.size()));
  out.mesh = std::make_shared<const PaperMesh>(
      PaperMesh{std::make_shared<const FacetGraph>(std::move(graph).value()), std::move(names),
                std::move(whole), cut.cut});
  return out;
}

struct Laid {
  MadePaperMesh made;
  std::shared_ptr<const PaperLayout> layout;
};

Laid laid_out(MadePaperMesh made, const std::shared_ptr<const PaperModel>& paper) {
  Laid out;
  out.made = std::move(made);
  if (!out.made.mesh || !paper->unfolded()) return out;
  out.made = on_paper(out.made.mesh->whole, paper->settings, out.made.mesh);
  if (!out.made.fault.messages.empty()) return out;
  auto unfolding = restored(*paper, out.made.mesh->graph, out.made.mesh->names);
  if (unfolding.ok())
    out.layout = lay_out_paper(paper, out.made.mesh, std::move(unfolding).value());
  else
    out.made.fault = {{unfolding.error()}, {}};
  return out;
}

}  // namespace

MadePaperMesh make_paper_mesh(const Document& document, const PaperModel& paper, const CancelToken& cancel,
                              const Progress& progress) {
  MadePaperMesh out;
  auto facets = document_facets(
      document, paper.objects,
      {.of_polyhedra = paper.of_polyhedra, .distance = paper.distance, .normal_angle = paper.normal_angle},
      cancel, progress);
  if (!facets.ok()) {
    out.fault.messages = {facets.error()};
    return out;
  }
  auto faults = unfolding_errors(facets->mesh, most_faults);
  if (!faults.empty()) {
    out.fault.lines = lines_of(faults, facets->mesh);
    out.fault.messages = std::move(faults);
    return out;
  }
  ModelFacets& made = facets.value();
  return on_paper(std::make_shared<const PaperFacets>(
                      PaperFacets{std::move(made.mesh), std::move(made.names), std::move(made.warnings)}),
                  paper.settings);
}

PaperEngine::PaperEngine(Editor& editor, BackgroundWork& searches, std::function<void()> wake)
    : editor_(editor), searches_(searches), lane_(std::move(wake)) {}

PaperEngine::Source PaperEngine::source_of(const Document& document, const PaperModel& paper) {
  Source out;
  out.objects = document.objects;
  out.unit = document.unit;
  out.of_polyhedra = paper.of_polyhedra;
  out.distance = paper.distance;
  out.normal_angle = paper.normal_angle;
  out.wanted = paper.objects;
  return out;
}

/// Whether the same objects give the same facets. Display settings do not matter; all objects count, as
/// surfaces may be attached to others.
bool PaperEngine::same_objects(const Source& a, const Source& b) {
  return a.unit == b.unit && a.wanted == b.wanted &&
         std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                    [](const auto& x, const auto& y) {
                      return x == y || (x->id == y->id && x->transform == y->transform &&
                                        x->source == y->source && x->copies == y->copies);
                    });
}

bool PaperEngine::same(const Source& a, const Source& b) {
  return a.of_polyhedra == b.of_polyhedra && a.distance == b.distance && a.normal_angle == b.normal_angle &&
         same_objects(a, b);
}

/// Settings that a search of this document would use.
PaperModel PaperEngine::choices_of_search(const Document& document) {
  PaperModel paper = paper_of(document);
  paper.objects = unfoldable_objects(document);
  return paper;
}

void PaperEngine::sync() {
  PaperState& state = editor_.paper;
  if (documents_ != editor_.documents) {
    documents_ = editor_.documents;
    state.forget();
    source_.reset();
    asked_.reset();
    asked_model_.reset();
    lane_.cancel(0);
  }
  if (std::exchange(state.wants_unfolding, false)) search();
  const Document& document = editor_.document();
  if (!state.shown || !document.paper) {
    if (!document.paper && !searching_) {
      state.layout.reset();
      state.dragged.reset();
      // The fault found by a search stays as long as the objects are unchanged.
      if (state.fault && source_ && !same_objects(*source_, source_of(document, choices_of_search(document))))
        state.fault.reset();
    }
    state.pending = false;
    return;
  }
  const Source source = source_of(document, *document.paper);
  const bool mesh_fits = source_ && (state.mesh || state.fault) && same(*source_, source);
  // Facets that cannot be made are not retried; a layout may succeed with other settings.
  const bool faulty = state.fault && (!state.mesh || faulty_model_ == document.paper);
  if (mesh_fits &&
      (faulty || (state.layout && state.layout->model == document.paper) || !document.paper->unfolded())) {
    if (!document.paper->unfolded()) state.layout.reset();
    state.pending = false;
    return;
  }
  if (mesh_fits && !state.fault)
    if (auto known = state.find(*document.paper, state.mesh.get())) {
      state.layout = std::move(known);
      state.pending = false;
      return;
    }
  state.pending = true;
  const bool asked = asked_ && asked_model_ == document.paper && same(*asked_, source);
  const bool waits = editor_.history.in_gesture() && source_ && !same_objects(*source_, source);
  if (!asked && !waits) lay_out(document, !mesh_fits);
}

void PaperEngine::lay_out(const Document& document, bool mesh_anew) {
  const auto paper = document.paper;
  const Source source = source_of(document, *paper);
  asked_ = source;
  asked_model_ = paper;
  MadePaperMesh present;
  if (!mesh_anew) present.mesh = editor_.paper.mesh;
  lane_.submit(
      0,
      [this, document, paper, source, present](const CancelToken& cancel) -> WorkLane::Publication {
        auto laid = std::make_shared<Laid>(
            laid_out(present.mesh ? present : make_paper_mesh(document, *paper, cancel), paper));
        return [this, laid, source, paper] {
          if (asked_model_ == paper) asked_.reset(), asked_model_.reset();
          take_mesh(laid->made, source);
          if (editor_.paper.fault) faulty_model_ = paper;
          editor_.paper.layout = laid->layout;
          if (laid->layout) editor_.paper.remember(laid->layout);
        };
      },
      WorkLane::Running::finish);
}

void PaperEngine::take_mesh(const MadePaperMesh& made, const Source& source) {
  PaperState& state = editor_.paper;
  source_ = source;
  state.mesh = made.mesh;
  state.fault.reset();
  if (!made.fault.messages.empty()) {
    state.fault = made.fault;
    state.layout.reset();
  }
}

void PaperEngine::search() {
  if (searching_) return;
  const Document document = editor_.history.current();
  const PaperModel paper = choices_of_search(document);
  const Source source = source_of(document, paper);
  MadePaperMesh present;
  if (source_ && same(*source_, source)) present.mesh = editor_.paper.mesh;
  searching_ = true;
  struct Found {
    MadePaperMesh made;
    std::optional<Unfolding> unfolding;
  };
  searches_.run_cancellable(
      translatable("Unfolding the model"),
      [document, paper, present](const CancelToken& cancel, const Progress& progress) {
        Found found;
        found.made = present.mesh ? present : make_paper_mesh(document, paper, cancel, progress.part(0, 0.1));
        if (found.made.mesh) found.made = on_paper(found.made.mesh->whole, paper.settings, found.made.mesh);
        if (!found.made.mesh || !found.made.fault.messages.empty()) return found;
        const PaperMesh& mesh = *found.made.mesh;
        UnfoldOptions options;
        options.goal = paper.goal;
        options.steps = paper.steps;
        options.wishes = wishes_on(paper, *mesh.graph, mesh.names);
        auto unfolded = unfold(mesh.graph, paper.settings, options, cancel, progress.part(0.1, 1));
        if (unfolded.ok())
          found.unfolding = std::move(unfolded).value();
        else
          found.made.fault = {{unfolded.error()}, {}};
        return found;
      },
      [this, source, paper, before = document.paper, opened = editor_.documents](const Found& found) {
        searching_ = false;
        if (opened != editor_.documents) return;
        const auto& faults = found.made.fault.messages;
        if (!faults.empty() && faults.front().code == e_cancelled) return editor_.notify(faults.front());
        // Settings and cuts that were chosen meanwhile stay; the search knew none of them.
        const auto& now = editor_.history.current().paper;
        if (now != before && !(now && before && *now == *before))
          return editor_.warn("The paper model was changed while it was unfolded. Unfold it again.");
        take_mesh(found.made, source);
        if (!found.unfolding) {
          if (!faults.empty()) editor_.notify(faults.front());
          return;
        }
        if (editor_.history.in_gesture()) editor_.cancel_preview();
        const PaperModel kept = kept_of(*found.unfolding, found.made.mesh->names, paper);
        if (!editor_.commit(set_paper(editor_.history.current(), kept), "Unfold"))
          return editor_.inform("The search found the same pages again.");
        PaperState& state = editor_.paper;
        state.layout = lay_out_paper(editor_.document().paper, found.made.mesh, *found.unfolding);
        state.remember(state.layout);
        state.selected = no_index;
        state.wants_framing = true;
      },
      Job::Kind::unfolding);
}

}  // namespace hariko
