#include "ui/paper/paper_panel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/skinning/edit/stroke.hpp"
#include "core/unfolding/edit_unfolding.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/paper_edits.hpp"
#include "ui/widgets/command_menu.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

constexpr float bar_height = 38, edge_reach = 4, drag_pixels = 3, handle_radius = 6;  // design pixels
constexpr double least_zoom = 0.02, greatest_zoom = 60;

Vector2 mouse() {
  return {double(ImGui::GetIO().MousePos.x), double(ImGui::GetIO().MousePos.y)};
}

/// Either way round.
template <class Corners>
bool holds(const Corners& corners, const Vector2& p) {
  int left = 0, right = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector2 &a = corners[k], &b = corners[(k + 1) % corners.size()];
    (cross(b - a, p - a) >= 0 ? left : right) += 1;
  }
  return left == 0 || right == 0;
}

const Job* search_job(const Editor& editor) {
  const auto found =
      std::ranges::find_if(editor.jobs, [](const auto& job) { return job->kind == Job::Kind::unfolding; });
  return found == editor.jobs.end() ? nullptr : found->get();
}

/// Hint of what a click or a drag does at a place of the pages.
const char* hint_over(const Unfolding& unfolding, const PaperHover& on) {
  if (on.joint != no_index)
    return unfolding.joints[on.joint].tab
               ? translatable("Click puts the tab on the other side   Shift: a strip instead")
               : translatable("Click puts a tab in the place of the strip");
  if (on.edge != no_index)
    return unfolding.folds[on.edge] ? translatable("Click splits the piece here")
                                    : translatable("Click joins the pieces here");
  if (on.facet != no_index)
    return translatable("Drag moves the piece   click selects it   the right button has more");
  return translatable("Drag moves the paper   the wheel zooms");
}

/// A button of the bar that runs a command; greyed where it cannot run.
void command_button(PanelContext& context, const char* id) {
  const Command& command = *context.commands.find(id);
  const bool blocked = command.why_not && command.why_not().has_value();
  ImGui::SameLine();
  // The menu Paper has those for which a narrow view has no room.
  const float width =
      ImGui::CalcTextSize(context.tr(command.label).c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
  if (ImGui::GetCursorPosX() + width > ImGui::GetWindowWidth()) return;
  {
    const Disabled disabled(blocked);
    if (text_button(context.marks, id, context.tr(command.label))) context.run(id);
  }
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
    show_tip((blocked ? context.tr.phrase(*command.why_not()) : context.tr(command.help)));
}

}  // namespace

void PaperPanel::draw(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  const float bar = m.px(bar_height);
  hint_.clear();
  if (begin_panel("Paper", {rect.min, {rect.max.x, rect.min.y + bar}}, palette().panel, {m.px(8), m.px(6)},
                  ImGuiWindowFlags_NoScrollbar))
    toolbar(context);
  ImGui::End();
  end_stale_drag(context.editor.paper);
  const bool foldable = context.editor.paper.visible() != nullptr;
  const float foot = foldable ? bar : 0;
  const PanelRect middle{{rect.min.x, rect.min.y + bar}, {rect.max.x, rect.max.y - foot}};
  if (begin_panel("Pages", middle, palette().window, {0, 0},
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    if (foldable)
      pages(context, middle);
    else
      empty_page(context, middle);
  }
  ImGui::End();
  if (!foldable) return;
  if (begin_panel("Folding", {{rect.min.x, rect.max.y - bar}, rect.max}, palette().panel, {m.px(8), m.px(6)},
                  ImGuiWindowFlags_NoScrollbar))
    fold_bar(context);
  ImGui::End();
}

void PaperPanel::toolbar(PanelContext& context) {
  const Job* job = search_job(context.editor);
  if (job) {
    aligned_text(context.tr("Looking for cuts"));
    ImGui::SameLine();
    if (job_bar(context.marks, "paper.cancel", *job, context.metrics.px(140), context.tr("Cancel")))
      job->cancel.cancel();
    return;
  }
  if (main_button(context.marks, "paper.unfold", context.tr("Unfold"))) context.run("paper.unfold");
  if (ImGui::IsItemHovered())
    show_tip(context.tr("Look for the cuts anew. Edges that you cut or joined stay so."));
  if (!context.editor.paper.visible()) return;
  for (const char* id : {"paper.arrange", "paper.straighten", "paper.turn", "paper.export"})
    command_button(context, id);
}

void PaperPanel::end_stale_drag(PaperState& state) {
  if (!drag_ || drag_->layout == state.layout) return;
  drag_.reset();
  state.dragged.reset();
}

void PaperPanel::empty_page(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  const PaperState& state = context.editor.paper;
  context.marks.rect("paper.view", rect.min, rect.max);
  const float width = std::min(rect.width() - m.px(48), m.px(380));
  ImGui::SetCursorScreenPos({rect.min.x + (rect.width() - width) / 2, rect.min.y + 0.3F * rect.height()});
  ImGui::BeginChild("message", {width, 0.6F * rect.height()});
  if (state.fault) {
    for (const Message& message : state.fault->messages)
      coloured_lines(palette().error, context.tr.text_of(message));
    coloured_lines(palette().dim_text, context.tr.remedy_of(state.fault->messages.front()));
  } else if (state.pending || search_job(context.editor)) {
    coloured_lines(palette().dim_text, context.tr("The facets are being laid out\u2026"));
  } else {
    coloured_lines(
        palette().dim_text,
        context.tr("Press Unfold to cut the model into pieces that lie flat, with tabs to glue them. "
                   "Size, page and tolerance stand in the panel at the right."));
  }
  ImGui::EndChild();
}

void PaperPanel::frame(const PaperLayout& layout, const PanelRect& rect, const Metrics& metrics) {
  const Index count = std::max<Index>(1, layout.unfolding.page_count);
  table_.columns = PageTable::columns_for(table_.page, count, double(rect.width() / rect.height()));
  const Vector2 size = table_.size(count), room(double(rect.width()), double(rect.height()));
  const Vector2 free = room - Vector2::Constant(double(metrics.px(32)));
  table_.zoom = std::clamp(std::min(free.x() / size.x(), free.y() / size.y()), least_zoom, greatest_zoom);
  table_.corner = Vector2(double(rect.min.x), double(rect.min.y)) + 0.5 * (room - table_.zoom * size);
}

void PaperPanel::pages(PanelContext& context, const PanelRect& rect) {
  Editor& editor = context.editor;
  PaperState& state = editor.paper;
  table_.page = state.visible()->unfolding.settings.page;
  follow_room(state, rect, context.metrics);
  const bool hovered = pointer_area(context.marks, "paper.view", rect, all_buttons);
  const Vector2 pixel = mouse();
  const double reach = double(context.metrics.px(edge_reach));
  if (hovered && !drag_) {
    state.hovered = under(*state.visible(), pixel, reach);
    pointer_here_ = true;
  } else if (!hovered && std::exchange(pointer_here_, false)) {
    state.hovered = {};
  }
  if (hovered && ImGui::GetIO().MouseWheel != 0) zoom(pixel, ImGui::GetIO().MouseWheel);
  for (const ImGuiMouseButton button : {ImGuiMouseButton_Middle, ImGuiMouseButton_Right})
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(button, drag_pixels)) {
      const ImVec2 by = ImGui::GetIO().MouseDelta;
      table_.corner += Vector2(double(by.x), double(by.y));
      framed_ = false;
    }
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) press(editor, context.metrics, pixel);
  if (drag_) drag(editor, context.metrics, pixel);
  if (drag_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) release(editor);
  if (hovered && ImGui::IsMouseReleased(ImGuiMouseButton_Right) &&
      !ImGui::IsMouseDragPastThreshold(ImGuiMouseButton_Right, drag_pixels)) {
    menu_on_ = state.hovered;
    if (menu_on_.facet != no_index) {
      state.selected = menu_on_.facet;
      ImGui::OpenPopup("##paper_menu");
    }
  }
  const PaperLayout& layout = *state.visible();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(rect.min, rect.max, true);
  draw_paper(list, context.metrics, layout, state, table_, layout.unfolding.page_count + (dragging() ? 1 : 0),
             rect);
  if (const auto at = handle(state, context.metrics)) {
    const ImVec2 centre(static_cast<float>(at->x()), static_cast<float>(at->y()));
    list.AddCircleFilled(centre, context.metrics.px(handle_radius), palette().accent);
    list.AddCircle(centre, context.metrics.px(handle_radius), palette().on_accent, 0,
                   context.metrics.px(1.5F));
    context.marks.rect("paper.handle", {centre.x - 2, centre.y - 2}, {centre.x + 2, centre.y + 2});
  }
  say(context, layout, rect);
  list.PopClipRect();
  mark(context.marks, layout, rect);
  if (dragging())
    hint_ = context.tr("Release to put the piece here   Esc puts it back");
  else if (hovered)
    hint_ = context.tr(hint_over(layout.unfolding, state.hovered));
  menu(context);
}

void PaperPanel::follow_room(PaperState& state, const PanelRect& rect, const Metrics& metrics) {
  const auto middle = [](const PanelRect& place) {
    return Vector2(double(place.min.x + place.max.x) / 2, double(place.min.y + place.max.y) / 2);
  };
  const bool moved = room_.width() != rect.width() || room_.height() != rect.height() ||
                     room_.min.x != rect.min.x || room_.min.y != rect.min.y;
  const bool asked = std::exchange(state.wants_framing, false);
  if (!asked && !moved) return;
  framed_ = framed_ || asked;
  if (framed_)
    frame(*state.visible(), rect, metrics);
  else
    table_.corner += middle(rect) - middle(room_);
  room_ = rect;
}

PaperHover PaperPanel::under(const PaperLayout& layout, const Vector2& pixel, double reach) const {
  PaperHover out;
  const Unfolding& u = layout.unfolding;
  const Index page = table_.page_near(pixel, std::max<Index>(1, u.page_count));
  const Vector2 p = table_.to_page(page, pixel);
  // On a tab or a strip an edge must be met more closely.
  Index joint = no_index;
  for (Index j = 0; j < u.joints.size() && joint == no_index; ++j)
    if (joint_page(layout, j) == page && holds(joint_corners(layout, j), p)) joint = j;
  double nearest = (joint == no_index ? 1 : 0.3) * reach / table_.zoom;
  for (const DrawnFacet& facet : layout.drawing.facets) {
    if (facet.page != page) continue;
    const bool inside = holds(facet.corners, p);
    if (inside) out.facet = facet.facet;
    for (Index side = 0; side < 3; ++side) {
      const Index edge = u.graph->edge_at(facet.facet, side);
      if (u.graph->edge(edge).border() || u.graph->edge(edge).inner) continue;
      const double distance = foot_on_segment(facet.corners[side], facet.corners[(side + 1) % 3], p).distance;
      if (distance >= nearest) continue;
      nearest = distance;
      out.edge = edge;
      if (!inside && out.facet == no_index) out.facet = facet.facet;
    }
  }
  if (out.edge != no_index && out.facet == no_index) out.facet = u.graph->edge(out.edge).facets[0];
  if (out.edge != no_index || joint == no_index) return out;
  out.joint = joint;
  const auto& tab = u.joints[joint].tab;
  out.facet = tab ? tab->facet : u.graph->edge(u.joints[joint].edge).facets[0];
  return out;
}

std::optional<Vector2> PaperPanel::handle(const PaperState& state, const Metrics& metrics) const {
  const Index piece = state.selected_piece();
  if (piece == no_index) return {};
  const PieceBox box = box_of(*state.visible(), piece);
  const ImVec2 top = table_.to_screen(box.page, {0.5 * (box.low.x() + box.high.x()), box.high.y()});
  return Vector2(double(top.x), double(top.y - metrics.px(18)));
}

void PaperPanel::zoom(const Vector2& pixel, float steps) {
  const double next = std::clamp(table_.zoom * std::pow(1.15, double(steps)), least_zoom, greatest_zoom);
  table_.corner = pixel + next / table_.zoom * (table_.corner - pixel);
  table_.zoom = next;
  framed_ = false;
}

void PaperPanel::press(Editor& editor, const Metrics& metrics, const Vector2& pixel) {
  PaperState& state = editor.paper;
  Drag next;
  next.from = pixel;
  next.corner = table_.corner;
  next.under = state.hovered;
  next.layout = state.layout;
  const auto grip = handle(state, metrics);
  const PaperLayout& layout = *state.layout;
  if (grip && (*grip - pixel).norm() <= double(metrics.px(handle_radius + 4))) {
    next.grip = Grip::handle;
    next.piece = state.selected_piece();
  } else if (state.hovered.facet != no_index &&
             !(state.hovered.joint != no_index && !layout.unfolding.joints[state.hovered.joint].tab)) {
    next.grip = Grip::piece;
    next.piece = layout.unfolding.piece_of[state.hovered.facet];
  }
  if (next.piece != no_index) next.page = layout.unfolding.pieces[next.piece].placement.page;
  drag_ = next;
}

void PaperPanel::drag(Editor& editor, const Metrics& metrics, const Vector2& pixel) {
  PaperState& state = editor.paper;
  Drag& held = *drag_;
  if (!held.moved && (pixel - held.from).norm() <= double(metrics.px(drag_pixels))) return;
  const bool news = !held.moved || pixel != dragged_to_;
  held.moved = true;
  dragged_to_ = pixel;
  if (!news) return;
  if (held.grip == Grip::paper) {
    table_.corner = held.corner + pixel - held.from;
    framed_ = false;
    return;
  }
  const PaperLayout& layout = *state.layout;
  const double side = layout.unfolding.settings.inside ? -1 : 1;
  Unfolding next = layout.unfolding;
  if (held.grip == Grip::piece) {
    const Index page = table_.page_near(pixel, layout.unfolding.page_count + 1);
    Vector2 shift = table_.to_page(page, pixel) - table_.to_page(held.page, held.from);
    shift.x() *= side;
    next = move_piece(layout.unfolding, held.piece, page, shift);
    state.selected = layout.unfolding.pieces[held.piece].facets.front();
  } else {
    const PieceBox box = box_of(layout, held.piece);
    const ImVec2 centre = table_.to_screen(box.page, 0.5 * (box.low + box.high));
    const Vector2 middle(double(centre.x), double(centre.y));
    const Vector2 a = held.from - middle, b = pixel - middle;
    double angle = -side * std::atan2(cross(a, b), a.dot(b));
    constexpr double notch = std::numbers::pi / 12;
    if (ImGui::GetIO().KeyCtrl) angle = notch * std::round(angle / notch);
    next = turn_piece(layout.unfolding, held.piece, angle);
  }
  state.hovered = {};
  state.dragged = lay_out_paper(layout.model, layout.mesh, std::move(next));
}

void PaperPanel::release(Editor& editor) {
  const Drag held = *std::exchange(drag_, std::nullopt);
  PaperState& state = editor.paper;
  const auto dragged = std::exchange(state.dragged, nullptr);
  if (!held.moved) return click(editor, held.under);
  if (!dragged) return;
  commit_paper(editor, dragged->unfolding,
               held.grip == Grip::piece ? translatable("Move a piece") : translatable("Turn a piece"));
}

bool PaperPanel::cancel_drag(Editor& editor) {
  if (!drag_) return false;
  const bool moved = drag_->moved;
  drag_.reset();
  editor.paper.dragged.reset();
  return moved;
}

void PaperPanel::click(Editor& editor, const PaperHover& on) {
  if (on.joint != no_index)
    ImGui::GetIO().KeyShift ? use_strip(editor, on.joint) : flip_tab(editor, on.joint);
  else if (on.edge != no_index)
    toggle_edge(editor, on.edge);
  else
    editor.paper.selected = on.facet;
  editor.paper.hovered = {};
}

void PaperPanel::menu(PanelContext& context) {
  const OpenScope opened = popup_scope("##paper_menu");
  if (!opened) return;
  const auto& joints = context.editor.paper.layout->unfolding.joints;
  if (menu_on_.joint < joints.size()) {
    if (menu_row(context.marks, "paper.menu.flip", context.tr("Tab on the other side")))
      flip_tab(context.editor, menu_on_.joint);
    if (menu_row(context.marks, "paper.menu.strip", context.tr("Strip instead of a tab")))
      use_strip(context.editor, menu_on_.joint);
    ImGui::Separator();
  }
  draw_menu_items(context, {"paper.straighten", "paper.turn", "paper.split_to_fit"}, "paper.menu.");
}

void PaperPanel::say(PanelContext& context, const PaperLayout& layout, const PanelRect& rect) const {
  const Language& tr = context.tr;
  std::vector<std::pair<std::string, bool>> lines;
  if (layout.overlaps > 0)
    lines.emplace_back(fill(tr("overlaps: {0}"), {std::to_string(layout.overlaps)}), true);
  if (!layout.off_page.empty())
    lines.emplace_back(fill(tr("pieces beyond the margins: {0}"), {std::to_string(layout.off_page.size())}),
                       true);
  if (context.editor.paper.pending)
    lines.emplace_back(tr("The model has changed: the pages follow\u2026"), false);
  const Metrics& m = context.metrics;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImVec2 at(rect.min.x + m.px(10), rect.min.y + m.px(8));
  for (const auto& [text, wrong] : lines) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list.AddRectFilled({at.x - m.px(6), at.y - m.px(3)}, {at.x + size.x + m.px(6), at.y + size.y + m.px(3)},
                       palette().popup, m.px(4));
    list.AddText(at, wrong ? palette().error : palette().dim_text, text.c_str());
    at.y += size.y + m.px(10);
  }
}

void PaperPanel::fold_bar(PanelContext& context) {
  PaperState& state = context.editor.paper;
  const Metrics& m = context.metrics;
  const ImGuiStyle& style = ImGui::GetStyle();
  constexpr const char *flat = translatable("Flat"), *solid = translatable("Solid"),
                       *shown = translatable("paper in the view");
  const auto width_of = [&](const char* words) { return ImGui::CalcTextSize(context.tr(words)).x; };
  const float words = style.ItemInnerSpacing.x + width_of(shown);
  float track = ImGui::GetContentRegionAvail().x - width_of(flat) - width_of(solid) -
                ImGui::GetFrameHeight() - 3 * style.ItemSpacing.x;
  // The words of the box, which has a tip, give way where there is no room for them.
  const bool named = track - words >= m.px(80);
  if (named) track -= words;
  aligned_text(context.tr(flat));
  ImGui::SameLine();
  track_slider(context.marks, "paper.fold", std::max(m.px(40), track), 1.0F, state.folded);
  if (ImGui::IsItemActive()) state.in_space = true;
  if (ImGui::IsItemHovered())
    show_tip(context.tr("Folds the pages up to the solid, in the view of the model"));
  ImGui::SameLine();
  plain_text(context.tr(solid));
  ImGui::SameLine();
  option_check(context, "paper.in_space", named ? shown : "",
               "The view of the model shows the paper instead of the objects", state.in_space);
}

/// Places for tests and guides: middles of folds, cuts, tabs and pieces, on models that are small enough.
void PaperPanel::mark(Marks& marks, const PaperLayout& layout, const PanelRect& rect) const {
  const Unfolding& u = layout.unfolding;
  constexpr std::size_t most_edges = 1200;
  const auto point = [&](const std::string& name, Index page, const Vector2& p) {
    const ImVec2 at = table_.to_screen(page, p);
    if (at.x > rect.min.x && at.x < rect.max.x && at.y > rect.min.y && at.y < rect.max.y)
      marks.rect(name, {at.x - 1, at.y - 1}, {at.x + 1, at.y + 1});
  };
  for (Index page = 0; page < u.page_count; ++page)
    marks.rect("paper.page." + std::to_string(page), table_.to_screen(page, {0, u.settings.page.height}),
               table_.to_screen(page, {u.settings.page.width, 0}));
  if (u.graph->edge_count() > most_edges) return;
  for (Index e = 0; e < u.graph->edge_count(); ++e) {
    const FacetEdge& edge = u.graph->edge(e);
    if (edge.border() || edge.inner) continue;
    const FacetCorners& corners = u.corners[edge.facets[0]];
    const Vector2 middle = 0.5 * (corners[edge.sides[0]] + corners[(edge.sides[0] + 1) % 3]);
    point((u.folds[e] ? "paper.folded." : "paper.cut.") + std::to_string(e), u.page_of(edge.facets[0]),
          as_drawn(layout, middle));
  }
  for (Index j = 0; j < u.joints.size(); ++j) {
    const auto corners = joint_corners(layout, j);
    const Vector2 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    point((u.joints[j].tab ? "paper.tab." : "paper.strip.") + std::to_string(u.joints[j].edge),
          joint_page(layout, j), middle);
  }
  for (Index p = 0; p < u.pieces.size(); ++p) {
    Index largest = u.pieces[p].facets.front();
    for (const Index facet : u.pieces[p].facets)
      if (u.graph->area(facet) > u.graph->area(largest)) largest = facet;
    const FacetCorners& c = u.corners[largest];
    point("paper.piece." + std::to_string(p), u.page_of(largest), as_drawn(layout, (c[0] + c[1] + c[2]) / 3));
  }
}

}  // namespace hariko
