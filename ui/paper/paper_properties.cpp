// Part of the properties: the settings of the paper model and what it came to.

#include "ui/paper/paper_properties.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "core/unfolding/cut_large_faces.hpp"
#include "ui/base/text_lines.hpp"
#include "ui/editor/object_size.hpp"
#include "ui/editor/paper_edits.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

constexpr double to_degrees = 180 / std::numbers::pi;

struct NamedPage {
  Choice choice;
  PaperSize size;
};
constexpr std::array pages{
    NamedPage{{"A4", ""}, a4_paper},
    NamedPage{{"A4 across", ""}, {a4_paper.height, a4_paper.width}},
    NamedPage{{"A3", ""}, a3_paper},
    NamedPage{{"A3 across", ""}, {a3_paper.height, a3_paper.width}},
    NamedPage{{"Letter", ""}, letter_paper},
    NamedPage{{"Letter across", ""}, {letter_paper.height, letter_paper.width}},
};
constexpr std::array page_choices{
    pages[0].choice,
    pages[1].choice,
    pages[2].choice,
    pages[3].choice,
    pages[4].choice,
    pages[5].choice,
    Choice{"Own size", "Width and height in mm"},
};
constexpr std::array facet_choices{
    Choice{"Surfaces", "Surfaces cut into triangles within the tolerance"},
    Choice{"Polyhedra", "The faces of polyhedra as they are: flat ones stay whole"},
};
constexpr std::array side_choices{
    Choice{"Outside", "What is printed is seen on the finished model"},
    Choice{"Inside", "What is printed is hidden: mirrored, mountains and valleys swapped"},
};

Quantity millimetres(double low, double high, double standard) {
  Quantity quantity = length_quantity(Unit::millimetre, 100);
  quantity.decimals = 1;
  quantity.step = 1;
  quantity.low = low;
  quantity.high = high;
  quantity.standard = standard;
  return quantity;
}

Quantity degrees(double high, double standard) {
  Quantity quantity = angle_quantity();
  quantity.low = 0;
  quantity.high = high;
  quantity.standard = standard;
  return quantity;
}

/// A number of the paper model.
template <class Get>
void number_row(PanelContext& context, const FieldSpec& spec, Get get) {
  PaperModel now = paper_choices_of(context.editor.document());
  value_row(context, spec, get(now),
            [quantity = spec.quantity, get](const Document& document, const ValueChange& change) {
              return Result<Document>(with_paper_settings(
                  document, [&](PaperModel& paper) { get(paper) = change.apply(quantity, get(paper)); }));
            });
}

/// The same, stored in radians.
template <class Get>
void angle_row(PanelContext& context, const FieldSpec& spec, Get get) {
  PaperModel now = paper_choices_of(context.editor.document());
  value_row(context, spec, get(now) * to_degrees,
            [quantity = spec.quantity, get](const Document& document, const ValueChange& change) {
              return Result<Document>(with_paper_settings(document, [&](PaperModel& paper) {
                get(paper) = change.apply(quantity, get(paper) * to_degrees) / to_degrees;
              }));
            });
}

void set(PanelContext& context, const char* step, const std::function<void(PaperModel&)>& change) {
  context.editor.commit(with_paper_settings(context.editor.history.current(), change), step);
}

/// Width, depth and height of the surfaces that are unfolded, in mm: changing one scales all. The facets lie
/// within the tolerance of the surfaces, so unfolding leaves the numbers as they are.
void size_rows(PanelContext& context) {
  Box3 box;
  for (const ObjectId id : paper_choices_of(context.editor.document()).objects)
    if (const Object* object = context.editor.document().find(id))
      box.extend(shown_box(context.editor, *object));
  if (box.isEmpty()) return;
  struct Row {
    const char *id, *label;
    int axis;
  };
  for (const Row& row :
       {Row{"paper_width", translatable("Width"), 0}, Row{"paper_depth", translatable("Depth"), 1},
        Row{"paper_height", translatable("Height"), 2}}) {
    const double extent = box.sizes()[row.axis];
    if (!(extent > 1e-9 * box.sizes().maxCoeff())) continue;
    Quantity quantity = millimetres(1, 5000, 0);
    quantity.standard.reset();
    value_row(context,
              {row.id, row.label, translatable("Of the finished model"),
               translatable("Size of the paper model"), quantity},
              extent * paper_choices_of(context.editor.document()).settings.scale,
              [quantity, extent](const Document& document, const ValueChange& change) {
                return Result<Document>(with_paper_settings(document, [&](PaperModel& paper) {
                  paper.settings.scale = change.apply(quantity, extent * paper.settings.scale) / extent;
                }));
              });
  }
}

void page_rows(PanelContext& context) {
  const PaperSettings settings = paper_choices_of(context.editor.document()).settings;
  int current = static_cast<int>(pages.size());
  for (std::size_t i = 0; i < pages.size(); ++i)
    if (pages[i].size == settings.page) current = static_cast<int>(i);
  if (const auto chosen =
          choose(context, "paper_page", "Page", "The paper that is printed on", page_choices, current);
      chosen && static_cast<std::size_t>(*chosen) < pages.size())
    set(context, "Page size",
        [&](PaperModel& paper) { paper.settings.page = pages[static_cast<std::size_t>(*chosen)].size; });
  number_row(
      context,
      {"page_width", translatable("Page width"), "", translatable("Page size"), millimetres(30, 5000, 210)},
      [](PaperModel& paper) -> double& { return paper.settings.page.width; });
  number_row(
      context,
      {"page_height", translatable("Page height"), "", translatable("Page size"), millimetres(30, 5000, 297)},
      [](PaperModel& paper) -> double& { return paper.settings.page.height; });
  const double most = std::min(settings.page.width, settings.page.height) / 2 - 10;
  number_row(context,
             {"paper_margin", translatable("Margin"), translatable("Free of pieces, round each page"),
              translatable("Margin of pages"), millimetres(0, std::max(0.0, most), 10)},
             [](PaperModel& paper) -> double& { return paper.settings.margin; });
  number_row(context,
             {"paper_tab", translatable("Tabs"), translatable("Height of glue tabs where there is room"),
              translatable("Height of tabs"), millimetres(1, 20, 5)},
             [](PaperModel& paper) -> double& { return paper.settings.tab_height; });
  number_row(context,
             {"paper_least_tab", translatable("Least tab"),
              translatable("Where there is no room for a tab of this height there is a strip"),
              translatable("Least height of tabs"), millimetres(0, 20, 2)},
             [](PaperModel& paper) -> double& { return paper.settings.least_tab; });
  number_row(context,
             {"paper_strip", translatable("Strips"),
              translatable("Width of joint strips, where a slit has no room for tabs"),
              translatable("Width of strips"), millimetres(2, 60, 8)},
             [](PaperModel& paper) -> double& { return paper.settings.strip_width; });
  number_row(context,
             {"paper_gap", translatable("Gap"), translatable("Between the pieces on a page"),
              translatable("Gap between pieces"), millimetres(0, 50, 2)},
             [](PaperModel& paper) -> double& { return paper.settings.gap; });
}

/// How many facets there are. Asking for another number changes the tolerance: facets become fewer about as
/// it grows.
void count_row(PanelContext& context, const PaperModel& now) {
  const auto& mesh = context.editor.paper.mesh;
  const double count = mesh ? static_cast<double>(mesh->whole->mesh.face_count()) : 0;
  if (!(count > 0)) return;
  constexpr int least = 10, most = 5000, usual = 100;
  const Quantity quantity = whole_quantity(least, most, usual);
  slider_row(
      context,
      {"paper_count", translatable("How many"),
       translatable("Facets of the paper model: fewer are quicker to build, more are nearer to the surface"),
       translatable("Tolerance of the paper model"), quantity},
      least, most, true, count,
      [quantity, count, distance = now.distance](const Document& document, const ValueChange& change) {
        return Result<Document>(with_paper_settings(document, [&](PaperModel& paper) {
          paper.distance = distance * count / change.apply(quantity, count);
        }));
      });
}

void facet_rows(PanelContext& context) {
  const PaperModel now = paper_choices_of(context.editor.document());
  if (const auto chosen = choose(context, "paper_facets", "Facets", "What is cut and folded", facet_choices,
                                 now.of_polyhedra ? 1 : 0))
    set(context, "Facets of the paper model", [&](PaperModel& paper) { paper.of_polyhedra = *chosen == 1; });
  if (now.of_polyhedra) return;
  count_row(context, now);
  Quantity length = length_quantity(context.editor.document().unit, now.distance);
  length.low = 1e-6 * now.distance;
  length.multiplies = true;
  number_row(context,
             {"paper_distance", translatable("Tolerance"),
              translatable("The farthest that the paper may be from the surface"),
              translatable("Tolerance of the paper model"), length},
             [](PaperModel& paper) -> double& { return paper.distance; });
}

/// Facets that are one polygon: an angle, or nothing at 0.
void merge_row(PanelContext& context) {
  const auto angle = [](const PaperModel& paper) {
    return paper.settings.merge_angle.value_or(0) * to_degrees;
  };
  const Quantity quantity = degrees(30, 0);
  value_row(context,
            {"paper_merge", translatable("Merge below"),
             translatable("Facets whose fold is smaller become one polygon, which is never cut. 0: none"),
             translatable("Merged facets"), quantity},
            angle(paper_choices_of(context.editor.document())),
            [quantity, angle](const Document& document, const ValueChange& change) {
              return Result<Document>(with_paper_settings(document, [&](PaperModel& paper) {
                const double chosen = change.apply(quantity, angle(paper)) / to_degrees;
                paper.settings.merge_angle = chosen > 0 ? std::optional(chosen) : std::nullopt;
              }));
            });
}

/// How long cuts are looked for.
void effort_row(PanelContext& context) {
  Quantity quantity = whole_quantity(1000, 100'000'000, static_cast<int>(PaperModel().steps));
  quantity.multiplies = true;
  value_row(context,
            {"paper_steps", translatable("Effort"),
             translatable("Steps of the search for cuts: more may find fewer pieces, and take longer"),
             translatable("Effort of the search"), quantity},
            static_cast<double>(paper_choices_of(context.editor.document()).steps),
            [quantity](const Document& document, const ValueChange& change) {
              return Result<Document>(with_paper_settings(document, [&](PaperModel& paper) {
                paper.steps =
                    static_cast<std::uint64_t>(change.apply(quantity, static_cast<double>(paper.steps)));
              }));
            });
}

void fold_rows(PanelContext& context) {
  angle_row(context,
            {"paper_flat", translatable("Flat below"), translatable("Folds of a smaller angle have no line"),
             translatable("Flat folds"), degrees(90, 0.5)},
            [](PaperModel& paper) -> double& { return paper.settings.flat_fold; });
  merge_row(context);
  const PaperModel now = paper_choices_of(context.editor.document());
  if (const auto chosen = choose(context, "paper_side", "Print on the", "Which side of the paper is printed",
                                 side_choices, now.settings.inside ? 1 : 0))
    set(context, "Printed side", [&](PaperModel& paper) { paper.settings.inside = *chosen == 1; });
  if (const auto on = check_row(context, "paper_angles", "Fold angles",
                                "Write the angle beside each fold, in degrees", now.settings.fold_angles))
    set(context, "Fold angles", [&](PaperModel& paper) { paper.settings.fold_angles = *on; });
}

void result_rows(PanelContext& context) {
  const PaperLayout* layout = context.editor.paper.visible();
  if (!layout) return;
  const Language& tr = context.tr;
  const Unfolding& u = layout->unfolding;
  const std::size_t strips = strip_count(u);
  const auto count = [](std::size_t n) { return std::to_string(n); };
  text_in_lines(fill(tr("facets: {0}   pieces: {1}   pages: {2}"),
                     {count(u.graph->face_count()), count(u.pieces.size()), count(u.page_count)}));
  text_in_lines(fill(tr("tabs: {0}   strips: {1}   paper used: {2} %"),
                     {count(u.joints.size() - strips), count(strips),
                      count(static_cast<std::size_t>(std::lround(100 * paper_use(u))))}));
  bool large = false, cut = false;
  for (const Message& message : layout->messages) {
    const TextColour colour(message.severity == Severity::error ? palette().error : palette().warning);
    text_in_lines(tr.text_of(message));
    large = large || message.code == e_piece_too_large;
    cut = cut || message.code == w_facet_cut;
  }
  if (!large && !cut) return;
  const double percent = std::floor(1000 * 0.998 * layout->fitting) / 10;
  if (ImGui::Button(
          (fill(tr("Scale to {0} %"), {format_quantity(plain_quantity(1, 1), percent)}) + "##fit").c_str(),
          {-1, 0}))
    context.run("paper.scale_to_fit");
  context.marks.item("paper.scale_to_fit");
  if (!large) return;
  if (ImGui::Button(tr("Split what is too large"), {-1, 0})) context.run("paper.split_to_fit");
  context.marks.item("paper.split_to_fit");
}

void fault_rows(PanelContext& context) {
  const auto& fault = context.editor.paper.fault;
  if (!fault) return;
  constexpr std::size_t most = 6;
  for (std::size_t i = 0; i < std::min(most, fault->messages.size()); ++i) {
    const TextColour red(palette().error);
    text_in_lines(context.tr.text_of(fault->messages[i]));
  }
  if (const std::string remedy = context.tr.remedy_of(fault->messages.front()); !remedy.empty()) {
    const TextColour dim(palette().dim_text);
    text_in_lines(remedy);
  }
}

}  // namespace

void draw_paper_properties(PanelContext& context) {
  heading(context, "Paper model");
  result_rows(context);
  fault_rows(context);
  size_rows(context);
  facet_rows(context);
  heading(context, "Pages");
  page_rows(context);
  heading(context, "Cuts and folds");
  const PaperModel now = paper_choices_of(context.editor.document());
  if (const auto chosen = choose(context, "paper_goal", "Aim at",
                                 "What matters most when cuts are looked for", std::optional(now.goal)))
    set(context, "Aim of the cuts", [&](PaperModel& paper) { paper.goal = *chosen; });
  effort_row(context);
  fold_rows(context);
}

}  // namespace hariko
