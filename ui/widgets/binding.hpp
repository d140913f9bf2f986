#pragma once

// Bindings: rows of a panel on values of the document, of one object or of many, each edit of which is one
// step. What a row shows and sets is given as data (`property.hpp`).

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ui/editor/selected_items.hpp"
#include "ui/widgets/property.hpp"

namespace hariko {

/// Draws a row. A number is changed by `edit`; the new value of a check or of a list is returned. `value` is
/// nothing when the values differ.
std::optional<double> draw_property(PanelContext& context, const PropertyRow& row, const Quantity& quantity,
                                    std::optional<double> value, const EditValues& edit);

/// Values that rows show, and the edit that changes each of them in a document.
template <class Value>
class Binding {
 public:
  using Change = std::function<void(Value&)>;
  using Edit = std::function<Result<Document>(const Document&, const Change&)>;

  /// The values must stay until the rows are drawn. `size`: a length like those that are shown.
  Binding(PanelContext& context, std::vector<const Value*> shown, Edit edit, double size = 1)
      : context_(context), shown_(std::move(shown)), edit_(std::move(edit)), size_(size) {}

  /// Value that all have in common; nothing where they differ.
  template <class Get>
  auto common_value(const Get& get) const {
    using Own = std::decay_t<std::invoke_result_t<const Get&, const Value&>>;
    return common<Own>(shown_, [&](const Value* value) -> Own { return std::invoke(get, *value); });
  }

  /// The document in which all of them are changed.
  Result<Document> changed(const Change& change) const {
    return edit_(context_.editor.history.current(), change);
  }
  /// The same as one step.
  void commit(const std::string& step, const Change& change) const {
    context_.editor.commit(changed(change), step);
  }

  /// Edit of a number that `get` reads and `set` changes.
  template <class Get, class Set>
  EditValues edit_of(const Quantity& quantity, const Get& get, const Set& set) const {
    return [edit = edit_, quantity, get, set](const Document& document, const ValueChange& change) {
      return edit(document, [&](Value& value) { set(value, change.apply(quantity, get(value))); });
    };
  }

  /// A row whose value `get` reads as a double and `set` changes.
  template <class Get, class Set>
  void row(const PropertyRow& texts, const Get& get, const Set& set) const {
    const Quantity quantity = quantity_in(texts.range, context_.editor.document().unit, size_);
    const auto now = common_value([&](const Value& value) -> double { return get(value); });
    const auto chosen = draw_property(context_, texts, quantity, now, edit_of(quantity, get, set));
    if (chosen)
      commit(*chosen == 0 && texts.off_step ? texts.off_step : texts.step,
             [&](Value& value) { set(value, *chosen); });
  }

  /// The row of a property; nothing where there are no values, or one of them does not show it.
  void row(const Property<Value>& property) const {
    const bool shows =
        std::ranges::all_of(shown_, [&](const Value* value) { return property.shown_for(*value); });
    if (shows && !shown_.empty()) row(property.row, property.get, property.set);
  }
  void rows(std::span<const Property<Value>> properties) const {
    for (const Property<Value>& property : properties) row(property);
  }

  /// Three numbers: `get` gives the vector, `set` changes its coordinate on an axis.
  template <class Get, class Set>
  void vector(const VectorSpec& spec, const Get& get, const Set& set) const {
    const auto now = common_axes(shown_, [&](const Value* value) -> Vector3 { return get(*value); });
    vector_row(context_, spec, now, [&](const Document& document, int axis, const ValueChange& change) {
      return edit_(document,
                   [&](Value& value) { set(value, axis, change.apply(spec.quantity, get(value)[axis])); });
    });
  }
  void vector(const VectorSpec& spec, Vector3 Value::*member) const {
    vector(
        spec, [member](const Value& value) -> const Vector3& { return value.*member; },
        [member](Value& value, int axis, double wanted) { (value.*member)[axis] = wanted; });
  }

 private:
  PanelContext& context_;
  std::vector<const Value*> shown_;
  Edit edit_;
  double size_;
};

/// Rows on a part of one object, which has it.
template <class Value>
Binding<Value> bind_part(PanelContext& context, const Object& object, const ObjectPart<Value>& part,
                         double size = 1) {
  return Binding<Value>(
      context, {part.of(object)},
      [id = object.id, edit = part.edit](const Document& document,
                                         const std::function<void(Value&)>& change) {
        return edit(document, id, change);
      },
      size);
}

/// Rows on a part of those objects that have it.
template <class Value>
Binding<Value> bind_part(PanelContext& context, const Objects& objects, const ObjectPart<Value>& part,
                         double size = 1) {
  std::vector<const Value*> shown;
  std::vector<ObjectId> ids;
  for (const auto& object : objects)
    if (const Value* value = part.of(*object)) {
      shown.push_back(value);
      ids.push_back(object->id);
    }
  // Objects that are gone by the time of the edit are left out.
  return Binding<Value>(
      context, std::move(shown),
      [ids, edit = part.edit](const Document& document, const std::function<void(Value&)>& change) {
        Result<Document> result = document;
        for (const ObjectId id : ids)
          if (result.ok() && result->find(id)) result = edit(*result, id, change);
        return result;
      },
      size);
}

}  // namespace hariko
