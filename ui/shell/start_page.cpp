#include "ui/shell/start_page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/cad/kernel/cad_file.hpp"
#include "ui/base/fonts.hpp"
#include "ui/base/icons.hpp"
#include "ui/shell/offers_panel.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/sample_cards.hpp"

namespace hariko {

namespace {

/// A way to begin.
struct Way {
  const char* mark;
  const char* title;
  const char* text;
  const char* command;
  std::string_view sample;  ///< id of the sample whose picture it has; empty for none
};

constexpr std::array<Way, 5> ways{{
    {"start.polyhedron", translatable("Polyhedron"),
     translatable("Pull a coarse cage; a smooth surface follows."), "file.new_from_box", "fig2"},
    {"start.solids", translatable("Solids"),
     translatable("Place boxes and balls; a surface goes round them."), "solid.box", "solids_dryer"},
    {"start.sections", translatable("Sections"),
     translatable("Draw a path and curves across it; a skin joins them."), "skin.draw", "skin_car_smooth"},
    {"start.outline", translatable("Outline"),
     translatable("Draw a closed curve; a smooth surface fills it."), "add.outline", "shell"},
    {"start.open", translatable("Open or import"),
     translatable("A document, a mesh or a CAD file. Or drop one here."), "file.open", ""},
}};

constexpr const char* endings =
    translatable("Hariko documents, .obj, .off, .ply, .stl, .glb, .gltf, .3mf, .bpt, .json");
constexpr const char* endings_with_cad =
    translatable("Hariko documents, .obj, .off, .ply, .stl, .glb, .gltf, .3mf, .bpt, .json, .step, .iges");

void dashed_line(ImVec2 from, ImVec2 to, ImU32 colour, float width, float dash) {
  const float x = to.x - from.x, y = to.y - from.y, length = std::max(std::abs(x), std::abs(y));
  const int pieces = 2 * std::max(1, static_cast<int>(length / (2 * dash))) + 1;
  for (int i = 0; i < pieces; i += 2) {
    const float a = static_cast<float>(i) / static_cast<float>(pieces),
                b = static_cast<float>(i + 1) / static_cast<float>(pieces);
    ImGui::GetWindowDrawList()->AddLine({from.x + a * x, from.y + a * y}, {from.x + b * x, from.y + b * y},
                                        colour, width);
  }
}

/// A place to drop files on: a dashed frame, and an arrow into a tray.
void paint_drop_place(const Metrics& m, ImVec2 low, ImVec2 high) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 colour = with_alpha(palette().dim_text, 0.75F);
  const float inset = m.px(14), line = m.px(1.5F), dash = m.px(5);
  const ImVec2 a(low.x + inset, low.y + inset), b(high.x - inset, high.y - inset);
  dashed_line(a, {b.x, a.y}, colour, line, dash);
  dashed_line({a.x, b.y}, b, colour, line, dash);
  dashed_line(a, {a.x, b.y}, colour, line, dash);
  dashed_line({b.x, a.y}, b, colour, line, dash);
  const ImVec2 c((low.x + high.x) / 2, (low.y + high.y) / 2);
  const float u = std::min(m.px(6), (b.y - a.y) / 8), thick = m.px(2.5F);
  const std::array<ImVec2, 4> tray{{{c.x - 3 * u, c.y + u},
                                    {c.x - 3 * u, c.y + 2.6F * u},
                                    {c.x + 3 * u, c.y + 2.6F * u},
                                    {c.x + 3 * u, c.y + u}}};
  draw.AddPolyline(tray.data(), static_cast<int>(tray.size()), palette().text, 0, thick);
  draw.AddLine({c.x, c.y - 2.8F * u}, {c.x, c.y + 0.9F * u}, palette().text, thick);
  const std::array<ImVec2, 3> head{
      {{c.x - 1.5F * u, c.y - 0.5F * u}, {c.x, c.y + u}, {c.x + 1.5F * u, c.y - 0.5F * u}}};
  draw.AddPolyline(head.data(), static_cast<int>(head.size()), palette().text, 0, thick);
}

Sample* find_sample(PanelContext& context, std::string_view stem) {
  const auto found = std::ranges::find_if(
      context.samples, [&](const Sample& sample) { return sample.path.stem().string() == stem; });
  return found == context.samples.end() ? nullptr : &*found;
}

void section(PanelContext& context, float left, const char* title) {
  ImGui::Dummy({0, context.metrics.px(12)});
  ImGui::SetCursorPosX(left);
  plain_text(context.tr(title));
}

void title(PanelContext& context, CardFocus& focus, float left, float width) {
  const Metrics& m = context.metrics;
  const float top = m.px(24);
  ImGui::SetCursorPos({left, top});
  ImGui::BeginGroup();
  ImGui::PushFont(title_font());
  plain_text("Hariko");
  ImGui::PopFont();
  dim_text(context.tr("Stretch a smooth surface over a rough structure."));
  ImGui::EndGroup();
  const ImVec2 below = ImGui::GetCursorPos();
  const char* text = context.editor.guide.paused() ? context.tr("Go on with your first model")
                                                   : context.tr("Your first model in two minutes");
  const std::string label = std::string(icon::info) + "  " + text;
  const float button = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetCursorPos({left + width - button, top + m.px(8)});
  const bool pressed = main_button(context.marks, "start.guide", label);
  if (focus.item("start.guide", m.px(4)) || pressed) context.run("help.guide");
  ImGui::SetCursorPos({below.x, below.y + m.px(14)});
}

void draw_ways(PanelContext& context, float left, float width) {
  CardGrid grid(context, left, width, static_cast<int>(ways.size()));
  for (const Way& way : ways) {
    Card card{way.mark, context.tr(way.title), context.tr(way.text), {}, find_sample(context, way.sample)};
    if (way.sample.empty()) {
      card.help = context.tr(why_no_cad_files() ? endings : endings_with_cad);
      card.paint = [&context](ImVec2 low, ImVec2 high) { paint_drop_place(context.metrics, low, high); };
    }
    grid.add(std::move(card));
  }
  constexpr std::size_t lines = 4;
  if (const int chosen = grid.draw(lines); chosen >= 0)
    context.run(ways[static_cast<std::size_t>(chosen)].command);
}

void earlier_work(PanelContext& context, float left, float width) {
  const auto indented = [&](const char* heading, const auto& draw) {
    section(context, left, heading);
    ImGui::SetCursorPosX(left);
    ImGui::BeginGroup();
    draw();
    ImGui::EndGroup();
  };
  if (context.offers.crash) indented("Report of a crash", [&] { draw_crash_offer(context, width); });
  if (!context.offers.recoveries.empty() || context.offers.recovery_places > 0)
    indented("Unsaved work of an earlier session", [&] { draw_recovery_offers(context, width); });
  if (!context.offers.recent.empty())
    indented("Recent files",
             [&] { draw_recent_files(context, width, width > context.metrics.px(820) ? 6 : 4); });
}

}  // namespace

void StartPage::draw(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  const float width = std::min(rect.width() - m.px(64), m.px(1080));
  const float left = (rect.width() - width) / 2;
  const int columns = width > m.px(820) ? 5 : 4;
  if (begin_panel("Start", rect, palette().window, {0, 0})) {
    focus_.begin();
    context.focus = &focus_;
    title(context, focus_, left, width);
    draw_ways(context, left, width);
    earlier_work(context, left, width);
    section(context, left, context.samples.empty() ? "The samples are not installed." : "Samples");
    draw_samples(context, left, width, columns);
    ImGui::Dummy({1, m.px(24)});
    context.focus = nullptr;
    focus_.end();
  }
  ImGui::End();
}

}  // namespace hariko
