#include "ui/shell/property_scripts.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>

#include "core/document/angles.hpp"
#include "core/document/edits/edit_skin.hpp"
#include "core/document/edits/edit_solids.hpp"
#include "core/document/edits/edits.hpp"
#include "core/document/format/format_names.hpp"
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

std::vector<std::string> words_of(detail::Names names) {
  return {names.begin(), names.end()};
}

/// Place of the word in its list: the number of the enumerator.
std::size_t chosen_of(const Arguments& given, detail::Names names) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), given.text("value")) - names.begin());
}

ArgumentSpec one_of(detail::Names names) {
  return word_argument("value", "", words_of(names), {});
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

/// Edits that are told to the table, by the ids of the rows of the properties.
class PropertyScripts {
 public:
  PropertyScripts(CommandTable& table, Editor& editor) : table_(table), editor_(editor) {}

  void add(const std::string& id, std::vector<ArgumentSpec> arguments, const char* step, EditObject edit,
           bool looks_at_surfaces = false) {
    ScriptUse use;
    use.arguments = std::move(arguments);
    use.looks_at_surfaces = looks_at_surfaces;
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
               void (*change)(DisplaySettings&, const Arguments&)) {
    add(id, {std::move(argument)}, step,
        [change](const Document& document, const Object& object, const Arguments& given) {
          DisplaySettings display = object.display;
          change(display, given);
          return set_display(document, object.id, display);
        });
  }

  /// Adds an edit of polyhedra; other objects stay as they are.
  void polyhedra(const char* id, ArgumentSpec argument, const char* step, EditObject edit) {
    add(id, {std::move(argument)}, step,
        [edit = std::move(edit)](const Document& document, const Object& object, const Arguments& given)
            -> Result<Document> { return object.polyhedron() ? edit(document, object, given) : document; });
  }

  /// Adds an edit of the settings of solids.
  void envelope(const char* id, ArgumentSpec argument, const char* step,
                void (*change)(EnvelopeInput&, const Arguments&)) {
    add(id, {std::move(argument)}, step,
        [change](const Document& document, const Object& object, const Arguments& given) -> Result<Document> {
          if (!object.solids()) return document;
          return change_envelope(document, object.id, [&](EnvelopeInput& input) { change(input, given); });
        });
  }

  /// Adds a change of skins.
  void skin(const char* id, ArgumentSpec argument, const char* step,
            void (*change)(Skin&, const Arguments&)) {
    add(id, {std::move(argument)}, step,
        [change](const Document& document, const Object& object, const Arguments& given) -> Result<Document> {
          if (!object.skin()) return document;
          Skin skin = *object.skin()->skin;
          change(skin, given);
          return set_skin(document, object.id, skin);
        });
  }
  void edited_skin(const char* id, ArgumentSpec argument, const char* step,
                   Result<SkinEdit> (*edit)(const Skin&, const Arguments&)) {
    add(id, {std::move(argument)}, step,
        [edit](const Document& document, const Object& object, const Arguments& given) -> Result<Document> {
          if (!object.skin()) return document;
          return with_skin(document, object.id, edit(*object.skin()->skin, given));
        });
  }

 private:
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

void add_placement(PropertyScripts& scripts, Editor& editor) {
  scripts.add(
      "size.x",
      {word_argument("axis", "of the object", words_of(detail::axis_names), "x"),
       length_argument("value", "of the surface along it", {}, least_length),
       on_off_argument("proportional", "scales the object along all its axes", false)},
      "Size of object",
      [&editor](const Document& document, const Object& object, const Arguments& given) {
        const int axis = given.text("axis").front() - 'x';
        return with_size(document, object.id, own_box(editor, object), shown_density(editor, object), axis,
                         given.number("value"), given.on("proportional"));
      },
      true);
  for (const auto& [id, step, unit] : {std::tuple("location.x", "Place object", ArgumentUnit::length),
                                       std::tuple("rotation.x", "Rotate object", ArgumentUnit::degrees)})
    scripts.add(id, {axis_value("x", unit), axis_value("y", unit), axis_value("z", unit)}, step,
                [unit = unit](const Document& document, const Object& object, const Arguments& given) {
                  return set_transform(document, object.id, placed(object.transform, given, unit));
                });
  scripts.add("scale", {real({}, Similarity::min_scale, Similarity::max_scale)}, "Scale object",
              [](const Document& document, const Object& object, const Arguments& given) {
                Similarity transform = object.transform;
                transform.scale = given.number("value");
                return set_transform(document, object.id, transform);
              });
}

void add_display(PropertyScripts& scripts) {
  scripts.display("map", one_of(detail::map_names), "Map",
                  [](DisplaySettings& display, const Arguments& given) {
                    display.map = SurfaceMap(chosen_of(given, detail::map_names));
                  });
  scripts.display("material", one_of(detail::material_names), "Material",
                  [](DisplaySettings& display, const Arguments& given) {
                    display = with_material(display, Material(chosen_of(given, detail::material_names)));
                  });
  scripts.display("wire", one_of(detail::wire_names), "Lines over the surface",
                  [](DisplaySettings& display, const Arguments& given) {
                    display.wire = PatchWire(chosen_of(given, detail::wire_names));
                  });
  scripts.display("density",
                  whole_argument("value", "intervals a patch side", DisplaySettings().density,
                                 DisplaySettings::min_density, DisplaySettings::max_density),
                  "Density of the surface", [](DisplaySettings& display, const Arguments& given) {
                    display.density = given.whole("value");
                  });
}

EditObject preparing(void (*change)(Preparation&, const Arguments&)) {
  return [change](const Document& document, const Object& object, const Arguments& given) {
    Preparation preparation = object.polyhedron()->preparation;
    change(preparation, given);
    return set_preparation(document, object.id, preparation);
  };
}

void add_polyhedra(PropertyScripts& scripts) {
  scripts.polyhedra("mode", one_of(detail::mode_names), "Surface",
                    [](const Document& document, const Object& object, const Arguments& given) {
                      return set_mode(document, object.id, Mode(chosen_of(given, detail::mode_names)));
                    });
  scripts.polyhedra("frames", on_or_off(), "Surface by measure",
                    [](const Document& document, const Object& object, const Arguments& given) {
                      return set_frames(document, object.id, given.on("on") ? Frames::metric : Frames::equal);
                    });
  scripts.polyhedra("split_concave", on_or_off(), "Split concave faces",
                    preparing([](Preparation& preparation, const Arguments& given) {
                      preparation.split_concave = given.on("on");
                    }));
  scripts.polyhedra("automatic_tension", real({}, 0, 1), "Automatic tension",
                    preparing([](Preparation& preparation, const Arguments& given) {
                      preparation.automatic_tension = given.number("value");
                    }));
}

void change_method(EnvelopeInput& input, const Arguments& given) {
  if (given.text("value") == "network")
    input.settings.method = EnvelopeMethod::network;
  else if (input.settings.rounding > 0)
    input.settings.method = EnvelopeMethod::ball;
  else
    choose_ball(input);
}

void add_solids_properties(PropertyScripts& scripts) {
  scripts.envelope("envelope_method", word_argument("value", "", {"ball", "network"}, {}),
                   "Method of the surface", change_method);
  scripts.envelope("tightness", real({}, 0, 1), "Tightness of the surface",
                   [](EnvelopeInput& input, const Arguments& given) {
                     input.settings.ball_radius = ball_radius_at(
                         given.number("value"), input.settings.rounding, solids_size(input.solids));
                   });
  scripts.envelope(
      "rounding", length_argument("value", "", {}, least_length), "Rounding of the surface",
      [](EnvelopeInput& input, const Arguments& given) { input.settings.rounding = given.number("value"); });
  scripts.envelope(
      "roundness", real(EnvelopeSettings().roundness, 0.01, 1), "Roundness of the surface",
      [](EnvelopeInput& input, const Arguments& given) { input.settings.roundness = given.number("value"); });
  scripts.envelope(
      "clearance", length_argument("value", "", 0, 0), "Clearance of the surface",
      [](EnvelopeInput& input, const Arguments& given) { input.settings.clearance = given.number("value"); });
  scripts.envelope(
      "on_faces", on_or_off(), "Surface on the faces",
      [](EnvelopeInput& input, const Arguments& given) { input.settings.on_faces = given.on("on"); });
  scripts.envelope(
      "finer_patches", on_or_off(), "Finer patches of the surface",
      [](EnvelopeInput& input, const Arguments& given) { input.settings.finer_patches = given.on("on"); });
  scripts.envelope("envelope_symmetry", one_of(detail::symmetry_names), "Symmetry of the surface",
                   [](EnvelopeInput& input, const Arguments& given) {
                     input.settings.symmetry = SymmetryPlane(chosen_of(given, detail::symmetry_names));
                   });
}

void mirror_skin(Skin& skin, const Arguments& given) {
  const std::size_t chosen = chosen_of(given, detail::symmetry_names);
  skin.mirror.reset();
  if (chosen > 0) skin.mirror = mirror_plane(skin, static_cast<int>(chosen) - 1);
}

Result<SkinEdit> frame_skin(const Skin& skin, const Arguments& given) {
  SkinEdit plain{skin, 0, {}, {}, {}};
  plain.skin.frame = FrameMode(chosen_of(given, detail::frame_names));
  return plain.skin.frame == FrameMode::two_rail ? make_rails(skin) : plain;
}

void add_skin_properties(PropertyScripts& scripts) {
  scripts.skin("skin_method", one_of(detail::skin_method_names), "Method of the skin",
               [](Skin& skin, const Arguments& given) {
                 skin.method = SkinMethod(chosen_of(given, detail::skin_method_names));
               });
  scripts.edited_skin("skin_frame", one_of(detail::frame_names), "Frames of the skin", frame_skin);
  scripts.edited_skin(
      "skin_closed", on_or_off(), "Close or open sections",
      [](const Skin& skin, const Arguments& given) { return set_closed(skin, given.on("on")); });
  scripts.skin(
      "skin_caps", one_of(detail::caps_names), "Ends of the skin",
      [](Skin& skin, const Arguments& given) { skin.caps = Caps(chosen_of(given, detail::caps_names)); });
  scripts.skin("skin_mirror", one_of(detail::symmetry_names), "Mirror of the skin", mirror_skin);
  scripts.edited_skin(
      "skin_closed_path", on_or_off(), "Close or open path",
      [](const Skin& skin, const Arguments& given) { return set_path_closed(skin, given.on("on")); });
  scripts.skin("skin_creases", on_or_off(), "Creases of the skin",
               [](Skin& skin, const Arguments& given) { skin.creases = given.on("on"); });
  scripts.skin("skin_flip", on_or_off(), "Turn the skin inside out",
               [](Skin& skin, const Arguments& given) { skin.flip_normals = given.on("on"); });
}

/// Adds the properties of pleated skins.
void add_pleat_properties(PropertyScripts& scripts) {
  scripts.skin("skin_density", real(PleatOptions().density, 0.25, 8), "Density",
               [](Skin& skin, const Arguments& given) { skin.pleat.density = given.number("value"); });
  scripts.skin("skin_fit", one_of(detail::fit_names), "Fit of the skin",
               [](Skin& skin, const Arguments& given) {
                 skin.pleat.fit = SectionFit(chosen_of(given, detail::fit_names));
               });
  scripts.skin("skin_tension", real(PleatOptions().tension, 5, 1e4), "Tension",
               [](Skin& skin, const Arguments& given) { skin.pleat.tension = given.number("value"); });
  scripts.skin("skin_match", one_of(detail::cost_names), "Matching of the skin",
               [](Skin& skin, const Arguments& given) {
                 skin.pleat.cost = MatchCost(chosen_of(given, detail::cost_names));
               });
  scripts.skin("skin_quads", on_or_off(), "Quads in fans",
               [](Skin& skin, const Arguments& given) { skin.pleat.quad_fans = given.on("on"); });
  scripts.skin("skin_collars", on_or_off(), "Collars",
               [](Skin& skin, const Arguments& given) { skin.pleat.collars = given.on("on"); });
}

/// Adds the properties of skins that are regular grids.
void add_grid_properties(PropertyScripts& scripts) {
  const ArgumentSpec lines =
      whole_argument("value", "0: as many as the curves suggest", 0, 0, most_grid_lines);
  scripts.skin("skin_columns", lines, "Columns",
               [](Skin& skin, const Arguments& given) { skin.smooth.columns = given.whole("value"); });
  scripts.skin("skin_rows", lines, "Rows",
               [](Skin& skin, const Arguments& given) { skin.smooth.rows = given.whole("value"); });
  scripts.skin("skin_blend", one_of(detail::blend_names), "Blend of the skin",
               [](Skin& skin, const Arguments& given) {
                 skin.smooth.blend = Blend(chosen_of(given, detail::blend_names));
               });
}

/// The mirror of the active polyhedron is a matter of commands, which cut it in half.
void add_mirror(CommandTable& table, Editor& editor) {
  ScriptUse use;
  use.arguments = {one_of(detail::symmetry_names)};
  use.run = [&table, &editor](const Arguments& given) {
    const auto& mirror = editor.active_object()->polyhedron()->mirror;
    const std::size_t now = mirror ? static_cast<std::size_t>(mirror->axis) + 1 : 0,
                      wanted = chosen_of(given, detail::symmetry_names);
    // The command of the present axis ends the mirror.
    if (wanted != now)
      table.run("mirror.live_" + std::string(detail::symmetry_names[wanted == 0 ? now : wanted]));
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
