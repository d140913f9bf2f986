#include "ui/shell/property_scripts.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>

#include "core/document/angles.hpp"
#include "core/document/edits/edit_skin.hpp"
#include "core/document/edits/edit_solids.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/words.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/skinning/edit/edit_path.hpp"
#include "core/skinning/edit/edit_section.hpp"
#include "core/skinning/edit/symmetric_edit.hpp"
#include "core/skinning/sections/make_rails.hpp"
#include "ui/editor/object_size.hpp"
#include "ui/editor/selected_items.hpp"
#include "ui/editor/skin_edits.hpp"

namespace hariko {

namespace {

constexpr double least_length = 1e-9;
constexpr double endless = std::numeric_limits<double>::infinity();
constexpr int most_grid_lines = 500;

/// Enumerator of the word, which the table has found among those of the argument.
template <class Enum>
Enum chosen_of(const Arguments& given) {
  const auto value = enum_value<Enum>(given.text("value"));
  HARIKO_ASSERT(value.has_value(), "words of arguments are checked");
  return *value;
}

template <class Enum>
ArgumentSpec one_of() {
  return word_argument("value", "", enum_word_list<Enum>(), {});
}
ArgumentSpec on_or_off() {
  return on_off_argument("on", "", true);
}
ArgumentSpec real(std::optional<double> standard, double low, double high) {
  return number_argument("value", "", standard, low, high);
}
ArgumentSpec axis_value(const char* axis, ArgumentUnit unit) {
  ArgumentSpec spec = optional(number_argument(axis, "stays where it is missing", {}, -endless, endless));
  spec.unit = unit;
  return spec;
}

using EditObject = std::function<Result<Document>(const Document&, const Object&, const Arguments&)>;
using WrittenArguments = std::vector<WrittenArgument>;
using ReadObject = std::function<WrittenArguments(const Object&)>;

template <class Enum>
WrittenArguments word_now(Enum value) {
  return {written("value", std::string(enum_word(value)))};
}
/// Symmetry plane across an axis, 0 .. 2.
SymmetryPlane plane_across(int axis) {
  return static_cast<SymmetryPlane>(axis + 1);
}
WrittenArguments value_now(double value) {
  return {written("value", value)};
}
WrittenArguments on_now(bool on) {
  return {written_switch("on", on)};
}

/// Edits that are told to the table, by the ids of the rows of the properties.
class PropertyScripts {
 public:
  PropertyScripts(CommandTable& table, Editor& editor) : table_(table), editor_(editor) {}

  void add(const std::string& id, std::vector<ArgumentSpec> arguments, const char* step, EditObject edit,
           ReadObject read, bool looks_at_surfaces = false) {
    ScriptUse use;
    use.arguments = std::move(arguments);
    use.looks_at_surfaces = looks_at_surfaces;
    use.read = std::move(read);
    use.run = [&editor = editor_, step, edit = std::move(edit)](const Arguments& given) {
      Result<Document> result = editor.history.current();
      for (const ObjectId chosen : chosen_ids(editor)) {
        const auto object = result ? result->find_shared(chosen) : nullptr;
        if (object) result = edit(*result, *object, given);
      }
      editor.commit(result, step);
    };
    table_.use_in_scripts("property." + id, std::move(use));
  }

  void display(const char* id, ArgumentSpec argument, const char* step,
               void (*change)(DisplaySettings&, const Arguments&),
               WrittenArguments (*read)(const DisplaySettings&)) {
    add(
        id, {std::move(argument)}, step,
        [change](const Document& document, const Object& object, const Arguments& given) {
          DisplaySettings display = object.display;
          change(display, given);
          return set_display(document, object.id, display);
        },
        [read](const Object& object) { return read(object.display); });
  }

  /// Adds an edit of polyhedra; other objects stay as they are.
  void polyhedra(const char* id, ArgumentSpec argument, const char* step, EditObject edit,
                 WrittenArguments (*read)(const PolyhedronSource&)) {
    add(
        id, {std::move(argument)}, step,
        [edit = std::move(edit)](const Document& document, const Object& object, const Arguments& given)
            -> Result<Document> { return object.polyhedron() ? edit(document, object, given) : document; },
        [read](const Object& object) {
          return object.polyhedron() ? read(*object.polyhedron()) : WrittenArguments();
        });
  }

  /// Adds an edit of the settings of solids.
  void envelope(const char* id, ArgumentSpec argument, const char* step,
                void (*change)(EnvelopeInput&, const Arguments&),
                WrittenArguments (*read)(const EnvelopeInput&)) {
    add(
        id, {std::move(argument)}, step,
        [change](const Document& document, const Object& object, const Arguments& given) -> Result<Document> {
          if (!object.solids()) return document;
          return change_envelope(document, object.id, [&](EnvelopeInput& input) { change(input, given); });
        },
        [read](const Object& object) {
          return object.solids() ? read(*object.solids()->input) : WrittenArguments();
        });
  }

  /// Adds a change of skins.
  void skin(const char* id, ArgumentSpec argument, const char* step, void (*change)(Skin&, const Arguments&),
            WrittenArguments (*read)(const Skin&)) {
    add(
        id, {std::move(argument)}, step,
        [change](const Document& document, const Object& object, const Arguments& given) -> Result<Document> {
          if (!object.skin()) return document;
          Skin skin = *object.skin()->skin;
          change(skin, given);
          return set_skin(document, object.id, skin);
        },
        of_skin(read));
  }
  void edited_skin(const char* id, ArgumentSpec argument, const char* step,
                   Result<SkinEdit> (*edit)(const Skin&, const Arguments&),
                   WrittenArguments (*read)(const Skin&)) {
    add(
        id, {std::move(argument)}, step,
        [edit](const Document& document, const Object& object, const Arguments& given) -> Result<Document> {
          if (!object.skin()) return document;
          return with_skin(document, object.id, edit(*object.skin()->skin, given));
        },
        of_skin(read));
  }

 private:
  static ReadObject of_skin(WrittenArguments (*read)(const Skin&)) {
    return [read](const Object& object) {
      return object.skin() ? read(*object.skin()->skin) : WrittenArguments();
    };
  }

  CommandTable& table_;
  Editor& editor_;
};

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

void add_display(PropertyScripts& scripts) {
  scripts.display(
      "map", one_of<SurfaceMap>(), "Map",
      [](DisplaySettings& display, const Arguments& given) { display.map = chosen_of<SurfaceMap>(given); },
      [](const DisplaySettings& now) { return word_now(now.map); });
  scripts.display(
      "material", one_of<Material>(), "Material",
      [](DisplaySettings& display, const Arguments& given) {
        display = with_material(display, chosen_of<Material>(given));
      },
      [](const DisplaySettings& now) { return word_now(now.material); });
  scripts.display(
      "wire", one_of<PatchWire>(), "Lines over the surface",
      [](DisplaySettings& display, const Arguments& given) { display.wire = chosen_of<PatchWire>(given); },
      [](const DisplaySettings& now) { return word_now(now.wire); });
  scripts.display(
      "density",
      whole_argument("value", "intervals a patch side", DisplaySettings().density,
                     DisplaySettings::min_density, DisplaySettings::max_density),
      "Density of the surface",
      [](DisplaySettings& display, const Arguments& given) { display.density = given.whole("value"); },
      [](const DisplaySettings& now) { return value_now(now.density); });
}

EditObject preparing(void (*change)(Preparation&, const Arguments&)) {
  return [change](const Document& document, const Object& object, const Arguments& given) {
    Preparation preparation = object.polyhedron()->preparation;
    change(preparation, given);
    return set_preparation(document, object.id, preparation);
  };
}

void add_polyhedra(PropertyScripts& scripts) {
  scripts.polyhedra(
      "mode", one_of<Mode>(), "Surface",
      [](const Document& document, const Object& object, const Arguments& given) {
        return set_mode(document, object.id, chosen_of<Mode>(given));
      },
      [](const PolyhedronSource& now) { return word_now(now.mode); });
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
  scripts.polyhedra("split_concave", on_or_off(), "Split concave faces",
                    preparing([](Preparation& preparation, const Arguments& given) {
                      preparation.split_concave = given.on("on");
                    }),
                    [](const PolyhedronSource& now) { return on_now(now.preparation.split_concave); });
  scripts.polyhedra("automatic_tension", real({}, 0, 1), "Automatic tension",
                    preparing([](Preparation& preparation, const Arguments& given) {
                      preparation.automatic_tension = given.number("value");
                    }),
                    [](const PolyhedronSource& now) { return value_now(now.preparation.automatic_tension); });
}

void change_method(EnvelopeInput& input, const Arguments& given) {
  if (given.text("value") == "network")
    input.settings.method = EnvelopeMethod::network;
  else if (input.settings.rounding > 0)
    input.settings.method = EnvelopeMethod::ball;
  else
    choose_ball(input);
}

WrittenArguments method_now(const EnvelopeInput& now) {
  return {written("value", std::string(now.settings.method == EnvelopeMethod::network ? "network" : "ball"))};
}

/// Rounded: the radius of the ball is what is kept.
WrittenArguments tightness_now(const EnvelopeInput& now) {
  constexpr double steps = 1e9;
  if (now.settings.method != EnvelopeMethod::ball) return {};
  const double tightness =
      tightness_of(now.settings.ball_radius, now.settings.rounding, solids_size(now.solids));
  return value_now(std::round(steps * tightness) / steps);
}

void add_solids_properties(PropertyScripts& scripts) {
  scripts.envelope("envelope_method", word_argument("value", "", {"ball", "network"}, {}),
                   "Method of the surface", change_method, method_now);
  scripts.envelope(
      "tightness", real({}, 0, 1), "Tightness of the surface",
      [](EnvelopeInput& input, const Arguments& given) {
        input.settings.ball_radius =
            ball_radius_at(given.number("value"), input.settings.rounding, solids_size(input.solids));
      },
      tightness_now);
  scripts.envelope(
      "rounding", length_argument("value", "", {}, least_length), "Rounding of the surface",
      [](EnvelopeInput& input, const Arguments& given) { input.settings.rounding = given.number("value"); },
      [](const EnvelopeInput& now) { return value_now(now.settings.rounding); });
  scripts.envelope(
      "roundness", real(EnvelopeSettings().roundness, 0.01, 1), "Roundness of the surface",
      [](EnvelopeInput& input, const Arguments& given) { input.settings.roundness = given.number("value"); },
      [](const EnvelopeInput& now) { return value_now(now.settings.roundness); });
  scripts.envelope(
      "clearance", length_argument("value", "", 0, 0), "Clearance of the surface",
      [](EnvelopeInput& input, const Arguments& given) { input.settings.clearance = given.number("value"); },
      [](const EnvelopeInput& now) { return value_now(now.settings.clearance); });
  scripts.envelope(
      "on_faces", on_or_off(), "Surface on the faces",
      [](EnvelopeInput& input, const Arguments& given) { input.settings.on_faces = given.on("on"); },
      [](const EnvelopeInput& now) { return on_now(now.settings.on_faces); });
  scripts.envelope(
      "finer_patches", on_or_off(), "Finer patches of the surface",
      [](EnvelopeInput& input, const Arguments& given) { input.settings.finer_patches = given.on("on"); },
      [](const EnvelopeInput& now) { return on_now(now.settings.finer_patches); });
  scripts.envelope(
      "envelope_symmetry", one_of<SymmetryPlane>(), "Symmetry of the surface",
      [](EnvelopeInput& input, const Arguments& given) {
        input.settings.symmetry = chosen_of<SymmetryPlane>(given);
      },
      [](const EnvelopeInput& now) { return word_now(now.settings.symmetry); });
}

void mirror_skin(Skin& skin, const Arguments& given) {
  const auto plane = chosen_of<SymmetryPlane>(given);
  skin.mirror.reset();
  if (plane != SymmetryPlane::none) skin.mirror = mirror_plane(skin, static_cast<int>(plane) - 1);
}

Result<SkinEdit> frame_skin(const Skin& skin, const Arguments& given) {
  SkinEdit plain{skin, 0, {}, {}, {}};
  plain.skin.frame = chosen_of<FrameMode>(given);
  return plain.skin.frame == FrameMode::two_rail ? make_rails(skin) : plain;
}

void add_skin_properties(PropertyScripts& scripts) {
  scripts.skin(
      "skin_method", one_of<SkinMethod>(), "Method of the skin",
      [](Skin& skin, const Arguments& given) { skin.method = chosen_of<SkinMethod>(given); },
      [](const Skin& now) { return word_now(now.method); });
  scripts.edited_skin("skin_frame", one_of<FrameMode>(), "Frames of the skin", frame_skin,
                      [](const Skin& now) { return word_now(now.frame); });
  scripts.edited_skin(
      "skin_closed", on_or_off(), "Close or open sections",
      [](const Skin& skin, const Arguments& given) { return set_closed(skin, given.on("on")); },
      [](const Skin& now) { return on_now(has_closed_sections(now)); });
  scripts.skin(
      "skin_caps", one_of<Caps>(), "Ends of the skin",
      [](Skin& skin, const Arguments& given) { skin.caps = chosen_of<Caps>(given); },
      [](const Skin& now) { return word_now(now.caps); });
  scripts.skin("skin_mirror", one_of<SymmetryPlane>(), "Mirror of the skin", mirror_skin,
               [](const Skin& now) {
                 return word_now(now.mirror ? plane_across(now.mirror->axis) : SymmetryPlane::none);
               });
  scripts.edited_skin(
      "skin_closed_path", on_or_off(), "Close or open path",
      [](const Skin& skin, const Arguments& given) { return set_path_closed(skin, given.on("on")); },
      [](const Skin& now) { return on_now(now.path.closed); });
  scripts.skin(
      "skin_creases", on_or_off(), "Creases of the skin",
      [](Skin& skin, const Arguments& given) { skin.creases = given.on("on"); },
      [](const Skin& now) { return on_now(now.creases); });
  scripts.skin(
      "skin_flip", on_or_off(), "Turn the skin inside out",
      [](Skin& skin, const Arguments& given) { skin.flip_normals = given.on("on"); },
      [](const Skin& now) { return on_now(now.flip_normals); });
}

/// Adds the properties of pleated skins.
void add_pleat_properties(PropertyScripts& scripts) {
  scripts.skin(
      "skin_density", real(PleatOptions().density, 0.25, 8), "Density",
      [](Skin& skin, const Arguments& given) { skin.pleat.density = given.number("value"); },
      [](const Skin& now) { return value_now(now.pleat.density); });
  scripts.skin(
      "skin_fit", one_of<SectionFit>(), "Fit of the skin",
      [](Skin& skin, const Arguments& given) { skin.pleat.fit = chosen_of<SectionFit>(given); },
      [](const Skin& now) { return word_now(now.pleat.fit); });
  scripts.skin(
      "skin_tension", real(PleatOptions().tension, 5, 1e4), "Tension",
      [](Skin& skin, const Arguments& given) { skin.pleat.tension = given.number("value"); },
      [](const Skin& now) { return value_now(now.pleat.tension); });
  scripts.skin(
      "skin_match", one_of<MatchCost>(), "Matching of the skin",
      [](Skin& skin, const Arguments& given) { skin.pleat.cost = chosen_of<MatchCost>(given); },
      [](const Skin& now) { return word_now(now.pleat.cost); });
  scripts.skin(
      "skin_quads", on_or_off(), "Quads in fans",
      [](Skin& skin, const Arguments& given) { skin.pleat.quad_fans = given.on("on"); },
      [](const Skin& now) { return on_now(now.pleat.quad_fans); });
  scripts.skin(
      "skin_collars", on_or_off(), "Collars",
      [](Skin& skin, const Arguments& given) { skin.pleat.collars = given.on("on"); },
      [](const Skin& now) { return on_now(now.pleat.collars); });
}

/// Adds the properties of skins that are regular grids.
void add_grid_properties(PropertyScripts& scripts) {
  const ArgumentSpec lines =
      whole_argument("value", "0: as many as the curves suggest", 0, 0, most_grid_lines);
  scripts.skin(
      "skin_columns", lines, "Columns",
      [](Skin& skin, const Arguments& given) { skin.smooth.columns = given.whole("value"); },
      [](const Skin& now) { return value_now(now.smooth.columns); });
  scripts.skin(
      "skin_rows", lines, "Rows",
      [](Skin& skin, const Arguments& given) { skin.smooth.rows = given.whole("value"); },
      [](const Skin& now) { return value_now(now.smooth.rows); });
  scripts.skin(
      "skin_blend", one_of<Blend>(), "Blend of the skin",
      [](Skin& skin, const Arguments& given) { skin.smooth.blend = chosen_of<Blend>(given); },
      [](const Skin& now) { return word_now(now.smooth.blend); });
}

SymmetryPlane plane_of(const std::optional<Mirror>& mirror) {
  return mirror ? plane_across(static_cast<int>(mirror->axis)) : SymmetryPlane::none;
}

/// The mirror of the active polyhedron is a matter of commands, which cut it in half.
void add_mirror(CommandTable& table, Editor& editor) {
  ScriptUse use;
  use.arguments = {one_of<SymmetryPlane>()};
  use.read = [](const Object& object) {
    if (!object.polyhedron()) return WrittenArguments();
    const auto& mirror = object.polyhedron()->mirror;
    return word_now(plane_of(mirror));
  };
  use.run = [&table, &editor](const Arguments& given) {
    const auto& mirror = editor.active_object()->polyhedron()->mirror;
    const SymmetryPlane now = plane_of(mirror), wanted = chosen_of<SymmetryPlane>(given);
    // The command of the present axis ends the mirror.
    if (wanted != now)
      table.run("mirror.live_" + std::string(enum_word(wanted == SymmetryPlane::none ? now : wanted)));
  };
  table.use_in_scripts("property.mirror", std::move(use));
}

}  // namespace

void use_properties_in_scripts(CommandHost& host) {
  PropertyScripts scripts(host.table, host.editor);
  add_placement(scripts, host.editor);
  add_display(scripts);
  add_polyhedra(scripts);
  add_mirror(host.table, host.editor);
  add_solids_properties(scripts);
  add_skin_properties(scripts);
  add_pleat_properties(scripts);
  add_grid_properties(scripts);
}

}  // namespace hariko
