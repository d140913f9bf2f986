#pragma once

// Properties as data: what can be set on values of the document. Rows of panels show them (`binding.hpp`),
// commands name them, and scripts set them.

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "core/document/words.hpp"
#include "ui/editor/command_arguments.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

enum class PropertyKind { number, check, list };
/// Unit of a number: none, the document's own, or always the same one.
enum class PropertyUnit { none, length, millimetres, degrees };

/// Range of a number, and how its field shows and changes it.
struct PropertyRange {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  std::optional<double> standard = {};  ///< default; 0 or nothing for lengths in the document's unit
  SliderKind slider = SliderKind::none;
  bool multiplies = false;  ///< steps are factors
  bool whole = false;
  PropertyUnit unit = PropertyUnit::none;
  int decimals = 3;   ///< digits of numbers without a unit
  double step = 0.1;  ///< likewise; of whole numbers at least 1
};

/// Numbers without a unit, with a slider.
constexpr PropertyRange linear_range(double low, double high, double standard, int decimals, double step) {
  return {low, high, standard, SliderKind::linear, false, false, PropertyUnit::none, decimals, step};
}
constexpr PropertyRange logarithmic_range(double low, double high, double standard, int decimals,
                                          double step) {
  return {low, high, standard, SliderKind::logarithmic, true, false, PropertyUnit::none, decimals, step};
}
constexpr PropertyRange whole_range(double low, double high, double standard,
                                    SliderKind slider = SliderKind::none) {
  return {low, high, standard, slider, false, true};
}
/// Lengths in the document's unit.
constexpr PropertyRange lengths_from(double low, std::optional<double> standard = {}) {
  return {.low = low, .standard = standard, .unit = PropertyUnit::length};
}

/// Row of a property; all texts in English.
struct PropertyRow {
  const char *id, *label, *help;
  const char* step;          ///< label of the step in the history
  PropertyRange range = {};  ///< range of a number
  PropertyKind kind = PropertyKind::number;
  std::span<const Choice> choices = {};  ///< choices of a list
  Words words = {};                      ///< words of a list, for scripts, in the order of the choices
  const char* off_step = nullptr;        ///< instead of `step` where a check is taken away; null for `step`
};

constexpr PropertyRow switch_row(const char* id, const char* label, const char* help, const char* step,
                                 const char* off_step = nullptr) {
  return {id, label, help, step, {}, PropertyKind::check, {}, {}, off_step};
}
constexpr PropertyRow list_row(const char* id, const char* label, const char* help, const char* step,
                               std::span<const Choice> choices, Words words = {}) {
  return {id, label, help, step, {}, PropertyKind::list, choices, words};
}

/// Property of values of a type. Every property is a double here: a check is 0 or 1, and a choice of a list
/// its number.
template <class Value>
struct Property {
  PropertyRow row;
  double (*get)(const Value&);  ///< NaN where a value keeps nothing for it
  void (*set)(Value&, double);
  bool (*has)(const Value&) = nullptr;    ///< whether a value has it; null where all have
  bool (*shows)(const Value&) = nullptr;  ///< whether it has a row where a value has it; null for always

  bool held_by(const Value& value) const { return !has || has(value); }
  bool shown_for(const Value& value) const { return held_by(value) && (!shows || shows(value)); }
};

/// Part of objects that has properties.
template <class Value>
struct ObjectPart {
  const Value* (*of)(const Object&);  ///< null where an object has no such part
  /// The document in which the part is changed; the document itself where the object has none.
  Result<Document> (*edit)(const Document&, ObjectId, const std::function<void(Value&)>&);
};

/// Edit of a part that is set as a whole.
template <class Value, const Value* (*of)(const Object&),
          Result<Document> (*set)(const Document&, ObjectId, const Value&)>
Result<Document> edit_part(const Document& document, ObjectId id, const std::function<void(Value&)>& change) {
  const Object* object = document.find(id);
  const Value* now = object ? of(*object) : nullptr;
  if (!now) return document;
  Value value = *now;
  change(value);
  return set(document, id, value);
}
template <class Value, const Value* (*of)(const Object&),
          Result<Document> (*set)(const Document&, ObjectId, const Value&)>
constexpr ObjectPart<Value> whole_part() {
  return {of, &edit_part<Value, of, set>};
}

template <class Value>
struct ObjectProperties {
  ObjectPart<Value> part;
  std::span<const Property<Value>> all;
};

/// Quantity of a number. `unit`: of the document; `size`: a length like those that are shown.
Quantity quantity_in(const PropertyRange& range, Unit unit, double size);

// In scripts: what a property is called, and its value as written and read there.
ArgumentSpec property_argument(const PropertyRow& row);
double given_property(const PropertyRow& row, const Arguments& given);
WrittenArgument written_property(const PropertyRow& row, double value);

namespace detail {

template <class Pointer>
struct MemberPointer;
template <class Class, class Type>
struct MemberPointer<Type Class::*> {
  using Value = Class;
};
template <auto member>
using ClassOf = typename MemberPointer<decltype(member)>::Value;

/// Member of a member ... of a value.
template <auto first, auto... rest, class Value>
constexpr auto& member_at(Value& value) {
  if constexpr (sizeof...(rest) == 0)
    return value.*first;
  else
    return member_at<rest...>(value.*first);
}

template <auto first, auto... rest>
double get_member(const ClassOf<first>& value) {
  return static_cast<double>(member_at<first, rest...>(value));
}

template <auto first, auto... rest>
void set_member(ClassOf<first>& value, double wanted) {
  auto& member = member_at<first, rest...>(value);
  using Member = std::remove_reference_t<decltype(member)>;
  if constexpr (std::is_same_v<Member, double>)
    member = wanted;
  else
    member = static_cast<Member>(std::lround(wanted));
}

}  // namespace detail

/// Property that is a member of a value, or a member of such a member. Its type says what the row is: a check
/// of a bool, the list of an enumeration, else a number.
template <auto first, auto... rest>
constexpr Property<detail::ClassOf<first>> member_property(
    PropertyRow row, bool (*has)(const detail::ClassOf<first>&) = nullptr,
    bool (*shows)(const detail::ClassOf<first>&) = nullptr) {
  using Value = detail::ClassOf<first>;
  using Member = std::remove_cvref_t<decltype(detail::member_at<first, rest...>(std::declval<Value&>()))>;
  if constexpr (std::is_same_v<Member, bool>) {
    row.kind = PropertyKind::check;
  } else if constexpr (std::is_enum_v<Member>) {
    row.kind = PropertyKind::list;
    row.choices = enum_choices<Member>;
    row.words = enum_words<Member>;
  } else {
    row.range.whole = std::is_integral_v<Member>;
  }
  return {row, &detail::get_member<first, rest...>, &detail::set_member<first, rest...>, has, shows};
}

}  // namespace hariko
