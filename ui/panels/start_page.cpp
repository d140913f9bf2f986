// The start page: work to recover, ways to begin, recent files and samples.

#include <algorithm>
#include <chrono>

#include "ui/fonts.hpp"
#include "ui/icons.hpp"
#include "ui/panels/crash_offer.hpp"
#include "ui/panels/offers_panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/sample_cards.hpp"

namespace hariko {

namespace {

void section(PanelContext& context, float left, const char* title) {
  ImGui::Dummy({0, context.metrics.px(10)});
  ImGui::SetCursorPosX(left);
  ImGui::TextDisabled("%s", context.tr(title));
  ImGui::Dummy({0, context.metrics.px(2)});
}

/// Calls draw(width) under a title, in the page's column.
template <class Draw>
void section_of(PanelContext& context, float left, const char* title, const Draw& draw) {
  section(context, left, title);
  ImGui::SetCursorPosX(left);
  ImGui::BeginGroup();
  draw();
  ImGui::EndGroup();
}

void earlier_work(PanelContext& context, float left, float content) {
  if (context.offers.crash)
    section_of(context, left, "Report of a crash", [&] { draw_crash_offer(context, content); });
  if (!context.offers.recoveries.empty())
    section_of(context, left, "Unsaved work of an earlier session",
               [&] { draw_recovery_offers(context, content); });
  if (!context.offers.recent.empty())
    section_of(context, left, "Recent files",
               [&] { draw_recent_files(context, content, content > context.metrics.px(820) ? 6 : 4); });
}

void actions(PanelContext& context) {
  const Language& tr = context.tr;
  const auto label = [&](const char* symbol, const char* text) { return std::string(symbol) + "  " + text; };
  if (main_button(label(icon::object, tr("New from box")).c_str())) context.run("file.new_from_box");
  context.marks.item("start.box");
  ImGui::SameLine();
  if (ImGui::Button(label(icon::open, tr("Open\u2026")).c_str())) context.run("file.open");
  context.marks.item("start.open");
  ImGui::SameLine();
  if (ImGui::Button(label(icon::import_file, tr("Import a mesh\u2026")).c_str())) context.run("file.import");
  context.marks.item("start.import");
  ImGui::SameLine();
  const Guide& guide = context.editor.guide;
  const char* text =
      guide.paused() ? tr("Go on with your first model") : tr("Your first model in two minutes");
  if (ImGui::Button(label(icon::info, text).c_str())) context.run("help.guide");
  context.marks.item("start.guide");
  ImGui::TextDisabled(
      "%s", tr("or drop a file here: .hariko, .obj, .off, .ply, .stl, .glb, .gltf, .3mf, .bpt, .json, "
               ".step, .iges"));
}

}  // namespace

void draw_start_page(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  const int columns = rect.width() > m.px(900) ? 4 : 3;
  const float content = std::min(rect.width() - m.px(64), m.px(1080));
  const float left = (rect.width() - content) / 2;
  if (begin_panel("Start", rect, palette().window, {0, 0})) {
    ImGui::SetCursorPos({left, m.px(28)});
    ImGui::BeginGroup();
    ImGui::PushFont(title_font());
    ImGui::TextUnformatted("Hariko");
    ImGui::PopFont();
    ImGui::TextDisabled("%s", context.tr("Stretch a smooth surface over a rough structure."));
    ImGui::Dummy({0, m.px(8)});
    actions(context);
    ImGui::EndGroup();
    earlier_work(context, left, content);
    section(context, left, context.samples.empty() ? "The samples are not installed." : "Samples");
    draw_samples(context, left, content, columns);
    ImGui::Dummy({1, m.px(24)});
  }
  ImGui::End();
}

}  // namespace hariko
