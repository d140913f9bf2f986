#include "ui/shell/offers_panel.hpp"

#include <algorithm>
#include <ctime>

#include "ui/base/icons.hpp"
#include "ui/base/text_lines.hpp"
#include "ui/base/texture.hpp"
#include "ui/widgets/application_services.hpp"
#include "ui/widgets/card_focus.hpp"
#include "ui/widgets/command_services.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/sample_cards.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

constexpr float card_height = 108;  ///< design pixels, of work to recover

/// Text that is cut with an ellipsis where it is wider than `width`.
void fitted_text(ImVec2 at, float width, ImU32 colour, const std::string& text) {
  std::string shown = text;
  while (!shown.empty() && ImGui::CalcTextSize((shown == text ? text : shown + "\u2026").c_str()).x > width) {
    do shown.pop_back();
    while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xC0U) == 0x80U);
    if (!shown.empty() && static_cast<unsigned char>(shown.back()) >= 0xC0U) shown.pop_back();
  }
  if (shown != text) shown += "\u2026";
  ImGui::GetWindowDrawList()->AddText(at, colour, shown.c_str());
}

void picture(unsigned texture, ImVec2 low, ImVec2 high, float radius, ImDrawFlags corners) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (texture != 0)
    draw.AddImageRounded(imgui_texture(texture), low, high, {0, 0}, {1, 1}, IM_COL32_WHITE, radius, corners);
  else
    draw.AddRectFilled(low, high, palette().field, radius, corners);
}

std::string title_of(const Language& tr, const RecoveryOffer& offer) {
  return offer.path.empty() ? tr(std::string(translatable("Untitled"))) : offer.path.filename().string();
}

/// Whether keys choose the last item.
bool by_key(PanelContext& context, const std::string& id) {
  return context.focus && context.focus->item(id, context.metrics.px(4));
}

void recovery_card(PanelContext& context, const RecoveryOffer& offer, float width) {
  const Metrics& m = context.metrics;
  const Language& tr = context.tr;
  const float height = m.px(card_height), radius = m.px(6), gap = ImGui::GetStyle().ItemSpacing.x;
  // In a narrow window the buttons need the room of the picture.
  const float wide = height * offer.aspect, both = 2 * m.px(110) + gap + m.px(32);
  const float picture_width = wide + both <= width ? wide : 0;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(at, {at.x + width, at.y + height}, palette().panel, radius);
  if (picture_width > 0)
    picture(offer.picture, at, {at.x + picture_width, at.y + height}, radius, ImDrawFlags_RoundCornersLeft);

  const float left = at.x + picture_width + m.px(16), line = ImGui::GetTextLineHeight() + m.px(4);
  const float text_width = at.x + width - left - m.px(16),
              button = std::min(m.px(110), (text_width - gap) / 2);
  float y = at.y + m.px(10);
  fitted_text({left, y}, text_width, palette().text, title_of(tr, offer));
  y += line;
  std::string details = fill(tr("Unsaved work of {0}"), {local_time_text(offer.written_at)});
  if (!offer.path.empty()) details += "   " + offer.path.parent_path().string();
  fitted_text({left, y}, text_width, palette().dim_text, details);
  y += line;
  if (offer.damaged)
    fitted_text({left, y}, text_width, palette().error, tr("The copy is damaged and cannot be opened."));
  else if (offer.file_changed)
    fitted_text({left, y}, text_width, palette().warning,
                tr("The file on disk was changed after this copy."));

  ImGui::PushID(offer.id.c_str());
  ImGui::SetCursorScreenPos({left, at.y + height - ImGui::GetFrameHeight() - m.px(10)});
  if (!offer.damaged) {
    ImGui::PushStyleColor(ImGuiCol_Button, with_alpha(palette().accent, 0.35F));
    const bool pressed = text_button(context.marks, "recovery.recover", tr("Recover"), button);
    if (by_key(context, "recover." + offer.id) || pressed) context.application.recover(offer.id);
    ImGui::PopStyleColor();
    ImGui::SameLine();
  }
  const bool discarded = text_button(context.marks, "recovery.discard", tr("Discard"), button);
  if (by_key(context, "discard." + offer.id) || discarded) context.application.discard_recovery(offer.id);
  ImGui::PopID();
  ImGui::SetCursorScreenPos({at.x, at.y + height + m.px(8)});
  ImGui::Dummy({width, 1});
}

bool recent_card(PanelContext& context, const RecentFile& file, ImVec2 size) {
  const Metrics& m = context.metrics;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(file.path.c_str());  // several may have the same name
  bool clicked = area_button(context.marks, "recent." + file.path.filename().string(), size);
  ImGui::PopID();
  if (by_key(context, file.path.string())) clicked = true;
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) show_tip(file.path.string() + "\n" + local_time_text(file.used_at));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float caption = m.px(34), radius = m.px(6);
  const ImVec2 end(at.x + size.x, at.y + size.y), picture_end(end.x, end.y - caption);
  draw.AddRectFilled(at, end, hovered ? palette().field_hover : palette().panel, radius);
  picture(file.picture, at, picture_end, radius, ImDrawFlags_RoundCornersTop);
  fitted_text({at.x + m.px(12), picture_end.y + m.px(8)}, size.x - m.px(24), palette().text,
              file.path.filename().string());
  if (hovered) draw.AddRect(at, end, palette().secondary, radius, 0, m.px(1.5F));
  return clicked;
}

}  // namespace

/// The place of a card whose offer is still being read, or was none.
void empty_card(PanelContext& context, std::size_t number, float width) {
  const Metrics& m = context.metrics;
  const ImVec2 at = ImGui::GetCursorScreenPos(), size(width, m.px(card_height));
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y}, palette().panel, m.px(6));
  ImGui::Dummy({size.x, size.y + m.px(8) + 1});  // as much room as a card takes
  context.marks.item("recovery.place." + std::to_string(number));
  fitted_text({at.x + m.px(16), at.y + m.px(10)}, width - m.px(32), palette().dim_text,
              context.offers.recoveries_known
                  ? context.tr("What was left here is what its file holds: nothing is lost.")
                  : context.tr("Looking for unsaved work\u2026"));
}

void draw_recovery_offers(PanelContext& context, float width) {
  const std::vector<RecoveryOffer> offers = context.offers.recoveries;  // a button may change the list
  for (const RecoveryOffer& offer : offers) recovery_card(context, offer, width);
  for (std::size_t i = offers.size(); i < context.offers.recovery_places; ++i) empty_card(context, i, width);
}

bool draw_recent_files(PanelContext& context, float width, std::size_t most) {
  const Metrics& m = context.metrics;
  const std::size_t columns = width > m.px(820) ? 6 : 4;
  const float spacing = m.px(12);
  const float card = (width - spacing * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  const ImVec2 size(card, card * 0.75F + m.px(34));
  const ImVec2 first = ImGui::GetCursorScreenPos();
  const std::vector<RecentFile> files = context.offers.recent;
  const std::size_t count = std::min(most, files.size());
  bool chosen = false;
  for (std::size_t i = 0; i < count; ++i) {
    const auto column = static_cast<float>(i % columns), row = static_cast<float>(i / columns);
    ImGui::SetCursorScreenPos({first.x + column * (card + spacing), first.y + row * (size.y + spacing)});
    if (!recent_card(context, files[i], size)) continue;
    chosen = true;
    context.services.open_guarded(files[i].path);
  }
  return chosen;
}

void OffersDialog::draw(PanelContext& context) {
  constexpr const char* id = "###offers";
  const bool shown = ImGui::IsPopupOpen(id);
  if (!open_ && !shown) return;
  const Language& tr = context.tr;
  const Metrics& m = context.metrics;
  if (open_ && !shown) {
    ImGui::OpenPopup(id);
    show_keyboard_focus();  // Enter takes the first offer until the keys go to another one
  }
  const bool recovery = kind_ == Kind::recovery;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = std::min(m.px(recovery                ? 620
                                    : kind_ == Kind::recent ? 760
                                                            : 1000),
                               screen.x - m.px(40));
  ImGui::SetNextWindowSize({width, 0});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, screen.y - m.px(80)});
  const bool crash_alone = context.offers.crash && context.offers.recoveries.empty();
  const std::string title = std::string(recovery && crash_alone ? tr("Report of a crash")
                                        : recovery              ? tr("Unsaved work of an earlier session")
                                        : kind_ == Kind::recent ? tr("Recent files")
                                                                : tr("Samples")) +
                            id;
  const OpenScope dialog = dialog_scope(title, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
  if (!dialog) return;
  const float inner = ImGui::GetContentRegionAvail().x;
  if (recovery) {
    draw_crash_offer(context, inner);
    draw_recovery_offers(context, inner);
    if (!context.offers.crash && context.offers.recoveries.empty()) open_ = false;
  } else if (kind_ == Kind::recent ? draw_recent_files(context, inner, 12)
                                   : draw_samples(context, ImGui::GetCursorPosX(), inner, 4)) {
    open_ = false;
  }
  ImGui::Dummy({0, m.px(4)});
  if (text_button(context.marks, "offers.close", recovery ? tr("Later") : tr("Cancel"), m.px(110)))
    open_ = false;
  if (!open_) ImGui::CloseCurrentPopup();
}

void draw_crash_offer(PanelContext& context, float width) {
  if (!context.offers.crash) return;
  const CrashOffer offer = *context.offers.crash;  // a button may take it away
  const Metrics& m = context.metrics;
  const Language& tr = context.tr;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float margin = m.px(16), left = at.x + margin;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.ChannelsSplit(2);  // the card's height is that of its text
  draw.ChannelsSetCurrent(1);

  ImGui::SetCursorScreenPos({left, at.y + m.px(10)});
  ImGui::BeginGroup();
  const float right = ImGui::GetCursorPosX() + width - 2 * margin;
  text_in_lines(fill(tr("Hariko closed unexpectedly on {0}."), {local_time_text(offer.at)}), right);
  coloured_lines(palette().dim_text,
                 tr("The report helps to find the mistake. It holds what the program was doing, "
                    "the graphics driver and names of files, nothing of their contents."),
                 right);
  ImGui::Dummy({0, m.px(2)});
  if (text_button(context.marks, "crash.copy", tr("Copy report"))) {
    ImGui::SetClipboardText(offer.report.c_str());
    context.editor.inform("The report is in the clipboard.");
  }
  ImGui::SameLine();
  if (text_button(context.marks, "crash.folder", tr("Open folder"))) context.application.show_log_folder();
  ImGui::SameLine();
  if (text_button(context.marks, "crash.dismiss", tr("Dismiss"))) context.application.dismiss_crash();
  ImGui::EndGroup();

  const float bottom = ImGui::GetItemRectMax().y + m.px(10), radius = m.px(6);
  draw.ChannelsSetCurrent(0);
  draw.AddRectFilled(at, {at.x + width, bottom}, palette().panel, radius);
  draw.AddRectFilled(at, {at.x + m.px(4), bottom}, palette().warning, radius, ImDrawFlags_RoundCornersLeft);
  draw.ChannelsMerge();
  ImGui::SetCursorScreenPos({at.x, bottom + m.px(8)});
  ImGui::Dummy({width, 1});
}

}  // namespace hariko
