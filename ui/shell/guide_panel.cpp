// The guided first model: what to do next, in a column beside the viewport.

#include "ui/base/fonts.hpp"
#include "ui/base/icons.hpp"
#include "ui/base/text_lines.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

/// The steps before and after the present one, by their titles.
void other_step(PanelContext& context, GuideStep step, bool past) {
  const TextColour colour(past ? palette().good : palette().dim_text);
  ImGui::TextUnformatted(past ? icon::check : icon::vertex);
  ImGui::SameLine(context.metrics.px(36));
  const TextColour text(palette().dim_text);
  ImGui::TextUnformatted(context.tr(text_of(step).title));
}

void present_step(PanelContext& context, GuideStep step) {
  const GuideText& text = text_of(step);
  const Metrics& m = context.metrics;
  ImGui::Dummy({0, m.px(2)});
  {
    const TextColour colour(palette().accent);
    ImGui::TextUnformatted(icon::current);
    ImGui::SameLine(m.px(36));
    ImGui::TextUnformatted(context.tr(text.title));
  }
  const Command* command = *text.command ? context.commands.find(text.command) : nullptr;
  const std::string keys = command ? command->keys.substr(0, command->keys.find(" / ")) : std::string();
  text_in_lines(fill(context.tr(text.text), {keys}));
  if (step == GuideStep::box) {
    if (ImGui::Button(context.tr("New from box"), {-1, 0})) context.run("file.new_from_box");
    context.marks.item("guide.box");
  }
  ImGui::Dummy({0, m.px(2)});
}

}  // namespace

void draw_guide(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  Guide& guide = context.editor.guide;
  if (begin_panel("Guide", rect, palette().panel, {m.px(16), m.px(14)})) {
    heading(context, "Your first model");
    ImGui::Dummy({0, m.px(4)});
    const auto step = static_cast<int>(guide.step());
    for (int i = 0; i < guide_step_count; ++i) {
      const auto each = static_cast<GuideStep>(i);
      i == step ? present_step(context, each) : other_step(context, each, i < step);
    }
    if (guide.step() == GuideStep::done) present_step(context, GuideStep::done);
    ImGui::Dummy({0, m.px(8)});
    const bool done = guide.step() == GuideStep::done;
    if (ImGui::Button(done ? context.tr("Close") : context.tr("Leave the guide"), {-1, 0})) guide.leave();
    context.marks.item("guide.leave");
    if (!done && ImGui::IsItemHovered())
      show_tip(context.tr("It goes on here later: Help, Your first model."));
    context.marks.item("guide.leave");
  }
  ImGui::End();
  context.marks.rect("guide.step." + std::to_string(static_cast<int>(guide.step())), rect.min, rect.max);
}

}  // namespace hariko
