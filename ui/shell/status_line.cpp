// The status line: the tool and its keys, counts, the state of the surface.

#include <algorithm>
#include <cmath>

#include "core/document/object_shape.hpp"
#include "ui/base/icons.hpp"
#include "ui/base/job.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/overlay_window.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

/// Work in progress, or to be done: a text, how far it is, and a button.
struct WorkRow {
  std::string text;
  ImU32 colour;
  bool bar = false;
  double fraction = -1;  ///< negative: not known
  const char* button = nullptr;
  const char* mark = nullptr;
};

/// In seconds where milliseconds would need a power of ten.
std::string duration_text(double milliseconds) {
  return milliseconds < 999.5 ? format_number(milliseconds, 3) + " ms"
                              : format_number(milliseconds / 1000, 3) + " s";
}

/// Goes on in the line at `x`, which no button beside moves up or down.
void continue_line(float x) {
  ImGui::SameLine(x);
  ImGui::SetCursorPosY(ImGui::GetCursorStartPos().y);
}

/// Draws a row that ends at `right`, which becomes its left end. True when the button was pressed.
bool draw_work(PanelContext& context, const WorkRow& row, float& right) {
  const Metrics& m = context.metrics;
  const float padding = m.px(8), bar = row.bar ? m.px(72) : 0;
  const float words = ImGui::CalcTextSize(row.text.c_str()).x;
  const float box = row.button ? ImGui::CalcTextSize(row.button).x + 2 * padding : 0;
  const float width = words + bar + box + 3 * padding;
  right -= width;
  continue_line(right + 2 * padding);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(at, row.colour, row.text.c_str());
  if (row.bar) {
    const ImVec2 low(at.x + words + padding, at.y + height / 2 - m.px(2));
    const ImVec2 high(low.x + bar - padding, low.y + m.px(4));
    list.AddRectFilled(low, high, palette().field, m.px(2));
    // A part wanders where it is not known how long the work will take.
    const float whole = high.x - low.x, length = row.fraction < 0 ? 0.3F : static_cast<float>(row.fraction);
    const float phase = row.fraction < 0
                            ? static_cast<float>(0.5 - 0.5 * std::cos(3 * context.editor.now)) * whole * 0.7F
                            : 0;
    list.AddRectFilled({low.x + phase, low.y}, {low.x + phase + whole * length, high.y}, palette().accent,
                       m.px(2));
  }
  if (!row.button) return false;
  ImGui::SetCursorScreenPos({at.x + words + bar + padding, at.y - m.px(2)});
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + box, low.y + height + m.px(4));
  const bool pressed = area_button(context.marks, row.mark, {high.x - low.x, high.y - low.y});
  list.AddRectFilled(low, high, ImGui::IsItemHovered() ? palette().field_hover : palette().field, m.px(4));
  list.AddText({low.x + padding, low.y + m.px(2)}, palette().text, row.button);
  return pressed;
}

bool placing_columns(const Editor& editor) {
  return std::ranges::any_of(editor.jobs,
                             [](const auto& job) { return job->kind == Job::Kind::placing_columns; });
}

/// Computing that takes long enough to notice, with a button that stops it, or surfaces that are not up to
/// date, with one that brings them there.
void draw_recompute(PanelContext& context, float& right) {
  const Editor& editor = context.editor;
  if (placing_columns(editor)) return;  // says how far it is, and can be cancelled
  constexpr double noticeable = 0.3;    // seconds
  const bool computes = std::ranges::any_of(
      editor.stale_since, [&](const auto& entry) { return editor.now - entry.second > noticeable; });
  if (!computes && editor.recompute.outdated.empty()) return;
  WorkRow row;
  row.text = context.tr(computes ? "computing\u2026" : "not up to date");
  row.colour = computes ? palette().text : palette().warning;
  row.bar = computes;
  row.button = context.tr(computes ? "Cancel" : "Recompute");
  row.mark = computes ? "status.cancel" : "status.recompute";
  if (draw_work(context, row, right)) context.run(computes ? "surface.cancel" : "surface.recompute");
}

/// Notice that everything is written down, with a button that ends it.
void draw_recording(PanelContext& context, float& right) {
  if (!context.editor.recording) return;
  WorkRow row;
  row.text = std::string(icon::record) + " " + context.tr("Recording");
  row.colour = palette().error;
  row.button = context.tr("Stop");
  row.mark = "status.stop_recording";
  if (draw_work(context, row, right)) context.run("help.stop_recording");
}

/// Mark of a script that is being recorded: the number of its steps, and of edits that have none.
void draw_script_recording(PanelContext& context, float& right) {
  const auto& progress = context.editor.script_recording;
  if (!progress) return;
  WorkRow row;
  row.text =
      std::string(icon::record) + " " + fill(context.tr("Script: {0}"), {std::to_string(progress->steps)});
  if (progress->left_out > 0)
    row.text += "  " + fill(context.tr("(left out: {0})"), {std::to_string(progress->left_out)});
  row.colour = progress->left_out > 0 ? palette().warning : palette().error;
  row.button = context.tr("Stop");
  row.mark = "status.stop_script";
  if (draw_work(context, row, right)) context.run("edit.stop_script");
}

/// Work on files: what runs, and how many wait behind it.
void draw_job(PanelContext& context, float& right) {
  const auto& jobs = context.editor.jobs;
  if (jobs.empty()) return;
  const Job& job = *jobs.front();
  WorkRow row;
  row.text = context.tr(job.text) + "\u2026";
  context.editor.show_text(row.text);
  row.fraction = job.progress.fraction();
  if (row.fraction >= 0) row.text += "  " + std::to_string(percent_of(job)) + " %";
  if (jobs.size() > 1) row.text += "  (+" + std::to_string(jobs.size() - 1) + ")";
  row.colour = palette().text;
  row.bar = job.can_be_cancelled;
  if (job.can_be_cancelled) row.button = context.tr("Cancel");
  row.mark = "status.cancel_job";
  if (draw_work(context, row, right)) context.run("file.cancel_job");
}

/// Continuity that the surface reaches; empty until that is measured, and for facets.
std::string continuity_of(PanelContext& context, const Object& object, const SurfaceView& view) {
  if (is_faceted(object) || !view.continuity || view.continuity->seams.size() != view.surface.seams().size())
    return {};
  PanelState& state = context.state;
  const ContinuityTolerance& tolerance = context.editor.view.tolerance;
  if (state.reached_from != view.continuity || !(state.reached_tolerance == tolerance)) {
    state.reached = reached_continuity(view.surface, *view.continuity, tolerance);
    state.reached_from = view.continuity;
    state.reached_tolerance = tolerance;
  }
  return text_of(state.reached, context.tr);
}

}  // namespace

void draw_status_line(PanelContext& context, const PanelRect& rect) {
  const Editor& editor = context.editor;
  const Metrics& m = context.metrics;
  if (begin_panel("Status", rect, palette().window, {m.px(12), m.px(5)}, ImGuiWindowFlags_NoScrollbar)) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette().dim_text);
    std::string right;
    ImU32 colour = palette().dim_text;
    if (const Object* object = editor.active_object(); object && editor.has_document) {
      right = object_kind(*object).size_text(*object, context.tr);
      const SurfaceView* view = editor.view_of(object->id);
      if (view && view->error) {
        right = context.tr.text_of(*view->error);
        colour = palette().error;
      } else if (view) {
        right += (right.empty() ? "" : "   \u00b7   ") + duration_text(view->milliseconds);
        if (const std::string reached = continuity_of(context, *object, *view); !reached.empty())
          right += "   \u00b7   " + reached;
      }
    }
    // Work stands at the edge, what lasts longest first: a text beside it that grows must not move a button
    // away from the pointer.
    float edge = rect.width() - m.px(12);
    draw_recording(context, edge);
    draw_script_recording(context, edge);
    draw_job(context, edge);
    draw_recompute(context, edge);
    // Each text has half of the line, and what the other does not need.
    constexpr float least_hint = 120;  // points
    const float start = m.px(12), gap = m.px(16), room = edge - start - gap;
    const std::string hint = context.tr.phrase(context.tool_hint);
    const float wanted = std::min(ImGui::CalcTextSize(hint.c_str()).x, room / 2);
    const std::string state = elided(right, room - std::max(wanted, m.px(least_hint)));
    const float left = edge - ImGui::CalcTextSize(state.c_str()).x;
    const std::string shown = elided(hint, std::max(left - gap - start, m.px(least_hint)));
    continue_line(start);
    plain_text(shown);
    context.marks.item("status.left");
    if (shown != hint && ImGui::IsItemHovered()) show_tip(hint);
    continue_line(std::max(left, start + ImGui::CalcTextSize(shown.c_str()).x + gap));
    const TextColour text(colour);
    plain_text(state);
    context.marks.item("status.right");
    if (state != right && ImGui::IsItemHovered()) show_tip(right);
    ImGui::PopStyleColor();
  }
  ImGui::End();
}

}  // namespace hariko
