#pragma once

// Fields of the settings that file dialogs show.

#include <optional>
#include <span>
#include <string>

#include "ui/base/quantity.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// The left column of a row; the next item starts at a common column.
void option_label(const Language& tr, const Metrics& metrics, const char* text);

/// What follows, so many pixels wide, stands beside the last item where there is room, else in the next row,
/// where fields begin. `gap`: design pixels.
void beside_or_below(const Metrics& metrics, float width, float gap = 8);
/// How wide a box with its words is, and words with a field of so many pixels behind them.
float check_width(const char* words);
float labelled_width(const char* words, float field);

/// A number with its unit that may be typed, of the given width in pixels; mark: "<id>". `text` is
/// what stands in the field, empty for the value's own. True when the value changed.
bool option_field(const char* id, const char* help, Marks& marks, float width, const Quantity& quantity,
                  std::string& text, double& value);

/// A list to choose one of some labels from, of the given width in pixels; marks: "<mark>", and "<mark>.<id>"
/// of each of `ids`, or of their numbers where there are none. Labels and the help are in the language of the
/// interface. Returns the new choice.
std::optional<std::size_t> option_list(Marks& marks, const std::string& mark, float width,
                                       std::span<const std::string> labels, std::size_t current,
                                       std::span<const std::string> ids = {}, const char* help = "");
/// Likewise the units of files, by their symbols.
std::optional<Unit> option_unit(Marks& marks, const std::string& mark, float width, Unit current,
                                const char* help = "");

/// Of the factor that all lengths are multiplied by.
Quantity scale_quantity();

/// One leading digit: 0.0347 becomes 0.03; 1 for what is not above 0.
double one_digit(double value);

}  // namespace hariko
