// Part of the properties: the settings of the paper model and what it came to.

#include "ui/paper/paper_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/unfolding/cut_large_faces.hpp"
#include "ui/editor/object_size.hpp"
#include "ui/editor/paper_edits.hpp"
#include "ui/widgets/binding.hpp"
#include "ui/widgets/items.hpp"

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

using PaperRows = Binding<PaperModel>;

constexpr PropertyRange millimetres(double low, double high, std::optional<double> standard) {
  return {.low = low, .high = high, .standard = standard, .unit = PropertyUnit::millimetres};
}
constexpr PropertyRange degrees(double high, double standard) {
  return {.low = 0, .high = high, .standard = standard, .unit = PropertyUnit::degrees};
}

/// Width, depth and height of the surfaces that are unfolded, in mm: changing one scales all. The facets lie
/// within the tolerance of the surfaces, so unfolding leaves the numbers as they are.
void size_rows(PanelContext& context, const PaperRows& rows, const PaperModel& now) {
  Box3 box;
  for (const ObjectId id : now.objects)
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
    rows.row(
        {row.id, row.label, "Of the finished model", "Size of the paper model", millimetres(1, 5000, {})},
        [extent](const PaperModel& paper) { return extent * paper.settings.scale; },
        [extent](PaperModel& paper, double size) { paper.settings.scale = size / extent; });
  }
}

constexpr std::array page_properties{
    member_property<&PaperModel::settings, &PaperSettings::page, &PaperSize::width>(
        {"page_width", "Page width", "", "Page size", millimetres(30, 5000, 210)}),
    member_property<&PaperModel::settings, &PaperSettings::page, &PaperSize::height>(
        {"page_height", "Page height", "", "Page size", millimetres(30, 5000, 297)}),
};
constexpr std::array piece_properties{
    member_property<&PaperModel::settings, &PaperSettings::tab_height>(
        {"paper_tab", "Tabs", "Height of glue tabs where there is room", "Height of tabs",
         millimetres(1, 20, 5)}),
    member_property<&PaperModel::settings, &PaperSettings::least_tab>(
        {"paper_least_tab", "Least tab", "Where there is no room for a tab of this height there is a strip",
         "Least height of tabs", millimetres(0, 20, 2)}),
    member_property<&PaperModel::settings, &PaperSettings::strip_width>(
        {"paper_strip", "Strips", "Width of joint strips, where a slit has no room for tabs",
         "Width of strips", millimetres(2, 60, 8)}),
    member_property<&PaperModel::settings, &PaperSettings::gap>(
        {"paper_gap", "Gap", "Between the pieces on a page", "Gap between pieces", millimetres(0, 50, 2)}),
};

void page_rows(PanelContext& context, const PaperRows& rows, const PaperSize& page) {
  int current = static_cast<int>(pages.size());
  for (std::size_t i = 0; i < pages.size(); ++i)
    if (pages[i].size == page) current = static_cast<int>(i);
  if (const auto chosen =
          choose(context, "paper_page", "Page", "The paper that is printed on", page_choices, current);
      chosen && static_cast<std::size_t>(*chosen) < pages.size())
    rows.commit("Page size", [&](PaperModel& paper) {
      paper.settings.page = pages[static_cast<std::size_t>(*chosen)].size;
    });
  rows.rows(page_properties);
  const double most = std::min(page.width, page.height) / 2 - 10;
  rows.row(member_property<&PaperModel::settings, &PaperSettings::margin>(
      {"paper_margin", "Margin", "Free of pieces, round each page", "Margin of pages",
       millimetres(0, std::max(0.0, most), 10)}));
  rows.rows(piece_properties);
}

/// Number of facets. Asking for another number changes the tolerance: facets become fewer about as it grows.
void count_row(PanelContext& context, const PaperRows& rows, double distance) {
  const auto& mesh = context.editor.paper.mesh;
  const double count = mesh ? static_cast<double>(mesh->whole->mesh.face_count()) : 0;
  if (!(count > 0)) return;
  rows.row(
      {"paper_count", "How many",
       "Facets of the paper model: fewer are quicker to build, more are nearer to the surface",
       "Tolerance of the paper model", whole_range(10, 5000, 100, SliderKind::logarithmic)},
      [count](const PaperModel&) { return count; },
      [count, distance](PaperModel& paper, double wanted) { paper.distance = distance * count / wanted; });
}

void facet_rows(PanelContext& context, const PaperRows& rows, const PaperModel& now) {
  rows.row(
      list_row("paper_facets", "Facets", "What is cut and folded", "Facets of the paper model",
               facet_choices),
      [](const PaperModel& paper) { return paper.of_polyhedra ? 1.0 : 0.0; },
      [](PaperModel& paper, double chosen) { paper.of_polyhedra = chosen != 0; });
  if (now.of_polyhedra) return;
  count_row(context, rows, now.distance);
  PropertyRange tolerances = lengths_from(1e-6 * now.distance);
  tolerances.multiplies = true;
  rows.row(member_property<&PaperModel::distance>({"paper_distance", "Tolerance",
                                                   "The farthest that the paper may be from the surface",
                                                   "Tolerance of the paper model", tolerances}));
}

/// Angles of folds are in radians there, and none is an angle of 0.
constexpr std::array fold_properties{
    Property<PaperModel>{
        {"paper_flat", "Flat below", "Folds of a smaller angle have no line", "Flat folds", degrees(90, 0.5)},
        [](const PaperModel& paper) { return paper.settings.flat_fold * to_degrees; },
        [](PaperModel& paper, double angle) { paper.settings.flat_fold = angle / to_degrees; }},
    Property<PaperModel>{
        {"paper_merge", "Merge below",
         "Facets whose fold is smaller become one polygon, which is never cut. 0: none", "Merged facets",
         degrees(30, 0)},
        [](const PaperModel& paper) { return paper.settings.merge_angle.value_or(0) * to_degrees; },
        [](PaperModel& paper, double angle) {
          paper.settings.merge_angle = angle > 0 ? std::optional(angle / to_degrees) : std::nullopt;
        }},
    Property<PaperModel>{list_row("paper_side", "Print on the", "Which side of the paper is printed",
                                  "Printed side", side_choices),
                         [](const PaperModel& paper) { return paper.settings.inside ? 1.0 : 0.0; },
                         [](PaperModel& paper, double side) { paper.settings.inside = side != 0; }},
    member_property<&PaperModel::settings, &PaperSettings::fold_angles>(
        {"paper_angles", "Fold angles", "Write the angle beside each fold, in degrees", "Fold angles"}),
};

/// Aim of the search for cuts, and for how long it goes on.
void search_rows(const PaperRows& rows) {
  rows.row(member_property<&PaperModel::goal>(
      {"paper_goal", "Aim at", "What matters most when cuts are looked for", "Aim of the cuts"}));
  PropertyRange steps = whole_range(1000, 1e8, static_cast<double>(PaperModel().steps));
  steps.multiplies = true;
  rows.row(member_property<&PaperModel::steps>(
      {"paper_steps", "Effort", "Steps of the search for cuts: more may find fewer pieces, and take longer",
       "Effort of the search", steps}));
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
  if (text_button(context.marks, "paper.scale_to_fit",
                  fill(tr("Scale to {0} %"), {format_quantity(plain_quantity(1, 1), percent)}), -1))
    context.run("paper.scale_to_fit");
  if (large && text_button(context.marks, "paper.split_to_fit", tr("Split what is too large"), -1))
    context.run("paper.split_to_fit");
}

void fault_rows(PanelContext& context) {
  const auto& fault = context.editor.paper.fault;
  if (!fault) return;
  constexpr std::size_t most = 6;
  for (std::size_t i = 0; i < std::min(most, fault->messages.size()); ++i)
    coloured_lines(palette().error, context.tr.text_of(fault->messages[i]));
  if (const std::string remedy = context.tr.remedy_of(fault->messages.front()); !remedy.empty())
    coloured_lines(palette().dim_text, remedy);
}

}  // namespace

void draw_paper_properties(PanelContext& context) {
  const PaperModel now = paper_choices_of(context.editor.document());
  const PaperRows rows(
      context, {&now},
      [](const Document& document, const PaperRows::Change& change) {
        return Result<Document>(with_paper_settings(document, change));
      },
      now.distance);
  heading(context, "Paper model");
  result_rows(context);
  fault_rows(context);
  size_rows(context, rows, now);
  facet_rows(context, rows, now);
  heading(context, "Pages");
  page_rows(context, rows, now.settings.page);
  heading(context, "Cuts and folds");
  search_rows(rows);
  rows.rows(fold_properties);
}

}  // namespace hariko
