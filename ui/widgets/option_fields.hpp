#pragma once

// Fields of what is no part of the document and so makes no steps: choices of file dialogs, and of the view.

#include <optional>
#include <span>
#include <string>

#include "ui/base/quantity.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// The left column of a row; the next item starts at a common column.
void option_label(const PanelContext& context, const char* text);

/// Puts the next item, so many pixels wide, beside the last one where there is room, else in the next row,
/// where fields begin. `gap`: design pixels.
void beside_or_below(const PanelContext& context, float width, float gap = 8);
/// Width of a box with its words, and of words with a field of so many pixels behind them.
float check_width(const char* words);
float labelled_width(const char* words, float field);

/// A box with its words, in English; the help, too, may be empty. True when it was pressed. Mark: "<id>".
bool option_check(const PanelContext& context, const char* id, const char* text, const char* help,
                  bool& value);
/// A box that stands for many values, with words in the language of the interface; nothing for `value` shows
/// that they differ. The new state when it was pressed.
std::optional<bool> mixed_check(Marks& marks, const std::string& mark, const std::string& text,
                                std::optional<bool> value);
/// A box `beside_or_below` the last item.
void check_beside(const PanelContext& context, const char* id, const char* text, const char* help,
                  bool& value, float gap = 8);
/// English words `beside_or_below` the last item, with the next one behind them, so many design pixels wide.
void words_beside(const PanelContext& context, const char* text, float field, float gap = 8);

/// A number with its unit that may be typed, of the given width in design pixels; mark: "<id>". `text` is
/// what stands in the field, empty for the value's own; the help is in English. True when the value changed.
bool option_field(const PanelContext& context, const char* id, const char* help, float width,
                  const Quantity& quantity, std::string& text, double& value);

/// A list to choose one of some labels from, of the given width in design pixels where there is room for it;
/// marks: "<mark>", and "<mark>.<id>" of each of `ids`, or of their numbers where there are none. Labels are
/// in the language of the interface, the help in English. Returns the new choice.
std::optional<std::size_t> option_list(const PanelContext& context, const std::string& mark, float width,
                                       std::span<const std::string> labels, std::size_t current,
                                       std::span<const std::string> ids = {}, const char* help = "");
/// Likewise the units of files, by their symbols.
std::optional<Unit> option_unit(const PanelContext& context, const std::string& mark, float width,
                                Unit current, const char* help = "");

/// Quantity of the factor that all lengths are multiplied by.
Quantity scale_quantity();

/// One leading digit: 0.0347 becomes 0.03; 1 for what is not above 0.
double one_digit(double value);

}  // namespace hariko
