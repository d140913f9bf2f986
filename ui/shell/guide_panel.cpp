// The guided first model: what to do next, in a column beside the viewport.

#include "ui/base/fonts.hpp"
#include "ui/base/icons.hpp"
#include "ui/widgets/command_menu.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

/// The steps before and after the present one, by their titles.
void other_step(PanelContext& context, GuideStep step, bool past) {
  coloured_text(past ? palette().good : palette().dim_text, past ? icon::check : icon::vertex);
  ImGui::SameLine(context.metrics.px(36));
  coloured_text(palette().dim_text, context.tr(text_of(step).title));
}

void present_step(PanelContext& context, GuideStep step) {
  const GuideText& text = text_of(step);
  const Metrics& m = context.metrics;
  ImGui::Dummy({0, m.px(2)});
  coloured_text(palette().accent, icon::current);
  ImGui::SameLine(m.px(36));
  coloured_text(palette().accent, context.tr(text.title));
  const Command* command = *text.command ? context.commands.find(text.command) : nullptr;
  text_in_lines(fill(context.tr(text.text), {command ? first_key(*command) : std::string()}));
  if (step == GuideStep::box && text_button(context.marks, "guide.box", context.tr("New from box"), -1))
    context.run("file.new_from_box");
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
    if (text_button(context.marks, "guide.leave", done ? context.tr("Close") : context.tr("Leave the guide"),
                    -1))
      guide.leave();
    if (!done && ImGui::IsItemHovered())
      show_tip(context.tr("It goes on here later: Help, Your first model."));
  }
  ImGui::End();
  context.marks.rect("guide.step." + std::to_string(static_cast<int>(guide.step())), rect.min, rect.max);
}

}  // namespace hariko
