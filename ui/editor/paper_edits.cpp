#include "ui/editor/paper_edits.hpp"

#include "core/unfolding/edit_unfolding.hpp"
#include "core/unfolding/paper_document.hpp"

namespace hariko {

namespace {

constexpr double least_size = 50, greatest_size = 500, usual_size = 200;  // mm

}  // namespace

PaperModel default_paper(const Document& document) {
  PaperModel paper;
  paper.objects = unfoldable_objects(document);
  // As many facets as one builds in an evening, about a hundred, instead of as many as are near the surface.
  constexpr double coarser = 4;
  paper.distance = coarser * proposed_distance(document, paper.objects);
  paper.settings.scale = millimetres_per(document.unit);
  Box3 box;
  for (const ObjectId id : paper.objects) box.extend(world_box(*document.find(id)));
  const double size = box.isEmpty() ? 0 : box.sizes().maxCoeff() * paper.settings.scale;
  if (size > 0 && (size < least_size || size > greatest_size)) paper.settings.scale *= usual_size / size;
  return paper;
}

PaperModel paper_of(const Document& document) {
  return document.paper ? *document.paper : default_paper(document);
}

PaperModel paper_choices_of(const Document& document) {
  if (!document.paper) return default_paper(document);
  const PaperModel& paper = *document.paper;
  PaperModel out;
  out.objects = paper.objects;
  out.of_polyhedra = paper.of_polyhedra;
  out.distance = paper.distance;
  out.normal_angle = paper.normal_angle;
  out.settings = paper.settings;
  out.goal = paper.goal;
  out.steps = paper.steps;
  return out;
}

Document with_paper_settings(const Document& document, const std::function<void(PaperModel&)>& change) {
  PaperModel paper = paper_of(document);
  const PaperSettings old = paper.settings;
  change(paper);
  const PaperSettings& next = paper.settings;
  const bool same_lengths = next.scale == old.scale && next.page == old.page && next.margin == old.margin &&
                            next.gap == old.gap && next.tab_height == old.tab_height &&
                            next.least_tab == old.least_tab && next.strip_width == old.strip_width;
  if (!same_lengths) {
    paper.places.clear();
    paper.strip_places.clear();
  }
  return set_paper(document, std::move(paper));
}

bool commit_paper(Editor& editor, const Result<Unfolding>& edited, const std::string& label) {
  PaperState& state = editor.paper;
  if (!edited.ok()) return editor.refuse(edited.error());
  const auto mesh = state.layout ? state.layout->mesh : nullptr;
  if (!mesh) return false;
  const Document& document = editor.history.current();
  const Document next = set_paper(document, kept_of(*edited, mesh->names, paper_of(document)));
  if (!editor.commit(next, label)) return false;
  state.layout = lay_out_paper(editor.document().paper, mesh, *edited);
  state.remember(state.layout);
  return true;
}

void toggle_edge(Editor& editor, Index edge) {
  const PaperLayout* layout = editor.paper.layout.get();
  if (!layout) return;
  if (layout->unfolding.folds[edge])
    commit_paper(editor, split_aside(layout->unfolding, edge), translatable("Split at an edge"));
  else
    commit_paper(editor, join_at(layout->unfolding, edge), translatable("Join at an edge"));
}

void flip_tab(Editor& editor, Index number) {
  const PaperLayout* layout = editor.paper.layout.get();
  if (!layout || number >= layout->unfolding.joints.size()) return;
  const Unfolding& u = layout->unfolding;
  const Joint& joint = u.joints[number];
  const bool on_first = joint.tab && joint.tab->facet == u.graph->edge(joint.edge).facets[0];
  const bool on_second = joint.tab && !on_first;
  for (const TabChoice choice : {TabChoice::first, TabChoice::second}) {
    if ((choice == TabChoice::first && on_first) || (choice == TabChoice::second && on_second)) continue;
    Unfolding next = choose_tab(u, joint.edge, choice);
    if (!next.joints[next.joint_at(joint.edge)].tab) continue;
    commit_paper(editor, std::move(next), translatable("Side of a tab"));
    return;
  }
  editor.inform(joint.tab ? "There is no room for the tab on the other side."
                          : "There is no room for a tab on either side.");
}

void use_strip(Editor& editor, Index number) {
  const PaperLayout* layout = editor.paper.layout.get();
  if (!layout || number >= layout->unfolding.joints.size()) return;
  const Index edge = layout->unfolding.joints[number].edge;
  commit_paper(editor, choose_tab(layout->unfolding, edge, TabChoice::strip),
               translatable("Strip instead of a tab"));
}

void scale_to_fit(Editor& editor) {
  const PaperLayout* layout = editor.paper.layout.get();
  if (!layout) return;
  // A little less: the packer turns pieces in steps.
  const double factor = 0.998 * layout->fitting;
  editor.commit(with_paper_settings(editor.history.current(),
                                    [factor](PaperModel& paper) { paper.settings.scale *= factor; }),
                translatable("Scale to fit the page"));
}

}  // namespace hariko
