#pragma once

// Fields that edit the document: a slider or a label previews while it is dragged and makes one step on
// release; a typed number makes one step when it is entered. All strings that are given are English: fields
// translate them.

#include <array>
#include <functional>
#include <optional>

#include "ui/base/quantity.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// The document in which every value that the field stands for is changed.
using EditValues = std::function<Result<Document>(const Document&, const ValueChange&)>;

/// A slider beside a number, over the range of its quantity.
enum class SliderKind { none, linear, logarithmic };

struct FieldSpec {
  const char* id;     ///< also the mark: "field.<id>", "slider.<id>", "label.<id>"
  const char* label;  ///< shown before the field; dragging it changes the value
  const char* help;
  std::string step;  ///< label of the step in the history
  Quantity quantity;
  SliderKind slider = SliderKind::none;
};

/// Three numbers with one unit, called X, Y and Z.
struct VectorSpec {
  std::array<const char*, 3> ids;
  const char *label, *help;
  std::string step;
  Quantity quantity;
};

/// The value that all have, or nothing when they differ.
template <class T, class Items, class Get>
std::optional<T> common(const Items& items, const Get& get) {
  std::optional<T> value;
  for (const auto& item : items) {
    const T own = get(item);
    if (value && !(*value == own)) return {};
    value = own;
  }
  return value;
}

/// The same of each coordinate of vectors.
template <class Items, class Get>
std::array<std::optional<double>, 3> common_axes(const Items& items, const Get& get) {
  std::array<std::optional<double>, 3> out;
  for (int axis = 0; axis < 3; ++axis)
    out[static_cast<std::size_t>(axis)] =
        common<double>(items, [&](const auto& item) -> double { return get(item)[axis]; });
  return out;
}

/// Makes a step when all rows of this frame are drawn.
void later(PanelContext& context, Result<Document> result, std::string step);

/// A label and a number over the rest of the row, or a slider and a number. `value` is nothing when the
/// values differ.
void value_row(PanelContext& context, const FieldSpec& spec, std::optional<double> value,
               const EditValues& edit);

/// The document in which a coordinate, 0 .. 2, of every vector that the fields stand for is changed.
using EditAxis = std::function<Result<Document>(const Document&, int axis, const ValueChange&)>;

/// Three numbers below each other.
void vector_row(PanelContext& context, const VectorSpec& spec,
                const std::array<std::optional<double>, 3>& values, const EditAxis& edit);

/// A number alone, of the given width in pixels.
void number_field(PanelContext& context, const FieldSpec& spec, std::optional<double> value, float width,
                  const EditValues& edit);

/// A label and a check box; the new state. Nothing stands for "mixed". Mark: "check.<id>".
std::optional<bool> check_row(PanelContext& context, const char* id, const char* label, const char* help,
                              std::optional<bool> value);

/// The left column of a row: a dim label; the next item starts at a common column.
void row_label(const PanelContext& context, const char* label, const char* help);

/// A row that is only read; the text is in the language of the interface.
void text_row(PanelContext& context, const char* mark, const char* label, const char* help,
              const std::string& text);

/// A button over the rest of the row. True when it was pressed. Mark: "button.<id>".
bool row_button(PanelContext& context, const std::string& id, const char* label, const char* help);
/// The same that runs a command, whose help it shows.
void run_button(PanelContext& context, const char* label, const char* command);

/// After the last item of a row that a command may ask for: brings it into sight, with a ring round it for a
/// moment.
void point_out(PanelContext& context, const char* id);

/// A dim sentence that wraps.
void hint_text(const PanelContext& context, const char* english);

}  // namespace hariko
