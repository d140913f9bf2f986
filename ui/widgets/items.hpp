#pragma once

// Texts, buttons and areas of panels, dialogs and bars. Texts are in the language of the interface already. A
// mark is also the name of its item for ImGui, so that no two items of a window have the same one.

#include <string>
#include <string_view>

#include "ui/base/job.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// A text in one line, as it is.
void plain_text(std::string_view text);
/// A text in a colour.
void coloured_text(ImU32 colour, std::string_view text);
/// A text in the colour of what matters less.
void dim_text(std::string_view text);
/// A text beside fields, at the height of the words in them.
void aligned_text(std::string_view text);
/// A text in as many lines as it needs (`in_lines`). They end at `right` at the latest, in the coordinates of
/// the window; 0 is the edge of its content.
void text_in_lines(std::string_view text, float right = 0);
/// The same in a colour.
void coloured_lines(ImU32 colour, std::string_view text, float right = 0);

/// A button, so many pixels wide: 0 for as many as its text needs, -1 for the rest of the row. True when it
/// was pressed.
bool text_button(Marks& marks, const std::string& mark, const std::string& text, float width = 0);
/// One of several choices side by side. True when it was pressed.
bool radio_button(Marks& marks, const std::string& mark, const std::string& text, bool on);
/// A button that goes a step back or forward. True when it was pressed.
bool arrow_button(Marks& marks, const std::string& mark, ImGuiDir direction, const char* tip);

/// Progress of a job as a bar, so many pixels wide, and a button behind it. True when that was pressed, which
/// is to stop the job. `width`: of the button, as for `text_button`.
bool job_bar(Marks& marks, const std::string& mark, const Job& job, float bar, const std::string& stop,
             float width = 0);

/// The buttons of a pointer that an area can take.
inline constexpr ImGuiButtonFlags all_buttons =
    ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle;
/// A rectangle of a window that the pointer presses or drags, for what is drawn there. True where the pointer
/// is on it.
bool pointer_area(Marks& marks, const std::string& mark, const PanelRect& rect,
                  ImGuiButtonFlags buttons = ImGuiButtonFlags_MouseButtonLeft);
/// A border that is dragged, over which the pointer looks so. True while it is held.
bool border_area(Marks& marks, const std::string& mark, ImVec2 size, ImGuiMouseCursor cursor);

}  // namespace hariko
