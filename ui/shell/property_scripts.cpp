
#include <array>
#include <limits>
#include <tuple>

#include "core/document/angles.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/words.hpp"
#include "ui/editor/object_size.hpp"
#include "ui/polyhedron/polyhedron_rows.hpp"
#include "ui/shell/property_tables.hpp"
#include "ui/widgets/script_edits.hpp"

namespace hariko {

namespace {

constexpr double least_length = 1e-9;
constexpr double endless = std::numeric_limits<double>::infinity();

ArgumentSpec real(std::optional<double> standard, double low, double high) {
  return number_argument("value", "", standard, low, high);
}
ArgumentSpec axis_value(const char* axis, ArgumentUnit unit) {
  ArgumentSpec spec = optional(number_argument(axis, "stays where it is missing", {}, -endless, endless));
  spec.unit = unit;
  return spec;
}

WrittenArguments value_now(double value) {
  return {written("value", value)};
}

Similarity placed(Similarity transform, const Arguments& given, ArgumentUnit unit) {
  constexpr std::array axes{"x", "y", "z"};
  const bool turns = unit == ArgumentUnit::degrees;
  Vector3 values = turns ? angles_of(transform.rotation) : transform.translation;
  for (int axis = 0; axis < 3; ++axis)
    if (const char* name = axes[static_cast<std::size_t>(axis)]; given.has(name))
      values[axis] = given.number(name);
  if (turns)
    transform.rotation = rotation_of(values);
  else
    transform.translation = values;
  return transform;
}

WrittenArguments placed_now(const Similarity& transform, ArgumentUnit unit) {
  // A turn is kept as a quaternion: its angles are those that were typed but for rounding errors.
  constexpr double steps_a_degree = 1e9;
  Vector3 values = transform.translation;
  if (unit == ArgumentUnit::degrees)
    values = (angles_of(transform.rotation) * steps_a_degree).array().round() / steps_a_degree;
  return {written("x", values.x()), written("y", values.y()), written("z", values.z())};
}

void add_placement(PropertyScripts& scripts, Editor& editor) {
  scripts.add(
      "size.x",
      {word_argument("axis", "of the object", enum_word_list<Axis>(), "x"),
       length_argument("value", "of the surface along it", {}, least_length),
       on_off_argument("proportional", "scales the object along all its axes", false)},
      "Size of object",
      [&editor](const Document& document, const Object& object, const Arguments& given) {
        const int axis = given.text("axis").front() - 'x';
        return with_size(document, object.id, own_box(editor, object), shown_density(editor, object), axis,
                         given.number("value"), given.on("proportional"));
      },
      {}, true);
  for (const auto& [id, step, unit] : {std::tuple("location.x", "Place object", ArgumentUnit::length),
                                       std::tuple("rotation.x", "Rotate object", ArgumentUnit::degrees)})
    scripts.add(
        id, {axis_value("x", unit), axis_value("y", unit), axis_value("z", unit)}, step,
        [unit = unit](const Document& document, const Object& object, const Arguments& given) {
          return set_transform(document, object.id, placed(object.transform, given, unit));
        },
        [unit = unit](const Object& object) { return placed_now(object.transform, unit); });
  scripts.add(
      "scale", {real({}, Similarity::min_scale, Similarity::max_scale)}, "Scale object",
      [](const Document& document, const Object& object, const Arguments& given) {
        Similarity transform = object.transform;
        transform.scale = given.number("value");
        return set_transform(document, object.id, transform);
      },
      [](const Object& object) { return value_now(object.transform.scale); });
}

void add_frames(PropertyScripts& scripts) {
  scripts.add(
      "frames", {on_or_off()}, "Surface by measure",
      [](const Document& document, const Object& object, const Arguments& given) -> Result<Document> {
        if (!stored_frames(object.source)) return document;
        return set_frames(document, object.id, given.on("on") ? Frames::metric : Frames::equal);
      },
      [](const Object& object) {
        const auto now = stored_frames(object.source);
        return now ? on_now(*now == Frames::metric) : WrittenArguments();
      });
}

}  // namespace

void use_properties_in_scripts(CommandHost& host) {
  PropertyScripts scripts(host.table, host.editor);
  add_placement(scripts, host.editor);
  add_frames(scripts);
  add_polyhedron_scripts(scripts, host.table, host.editor);
  add_skin_scripts(scripts);
  visit_properties([&](const char*, const auto& known) { scripts.add_table(known); });
}

}  // namespace hariko
