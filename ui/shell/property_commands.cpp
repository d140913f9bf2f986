// Commands for what stands in the properties: the palette finds them by name. A number is asked for, a list
// or a check box brought into sight, and a choice of a list made at once.

#include <array>

#include "core/document/edits/edit_skin.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/shell/preference_rows.hpp"
#include "ui/shell/property_scripts.hpp"
#include "ui/shell/shell_commands.hpp"
#include "ui/shell/workbench.hpp"
#include "ui/skin/skin_properties.hpp"

namespace hariko {

namespace {

using Has = bool (*)(const Object&);

bool any_object(const Object&) {
  return true;
}
bool is_polyhedron(const Object& object) {
  return object.polyhedron() != nullptr;
}
bool has_frames(const Object& object) {
  return surface_frames(object.source).has_value();
}
bool is_solids(const Object& object) {
  return object.solids() != nullptr;
}
bool is_ball(const Object& object) {
  return object.solids() && object.solids()->input->settings.method == EnvelopeMethod::ball;
}
bool is_network(const Object& object) {
  return object.solids() && object.solids()->input->settings.method == EnvelopeMethod::network;
}
bool is_skin(const Object& object) {
  return object.skin() != nullptr;
}
bool is_pleated(const Object& object) {
  return object.skin() && object.skin()->skin->method == SkinMethod::pleat;
}
bool is_grid(const Object& object) {
  return object.skin() && object.skin()->skin->method != SkinMethod::pleat;
}

/// A row of the properties: its id, its label and help, and which objects have it.
struct Row {
  const char *id, *label, *help;
  Has has;
};

constexpr std::array rows{
    Row{"size.x", translatable("Size"), translatable("Of the surface, along the object's own axes"),
        any_object},
    Row{"location.x", translatable("Location"),
        translatable("Where the object's own zero stands in the document"), any_object},
    Row{"rotation.x", translatable("Rotation"), translatable("About the x axis first, then y, then z"),
        any_object},
    Row{"scale", translatable("Scale"), translatable("The same along all axes: surfaces keep their shape"),
        any_object},
    Row{"map", translatable("Map"), translatable("What colours the surface"), any_object},
    Row{"material", translatable("Material"), translatable("How the surface takes the light"), any_object},
    Row{"wire", translatable("Lines"), translatable("Lines over the surface"), any_object},
    Row{"mode", translatable("Surface"), translatable("How the surface spans the curves"), is_polyhedron},
    Row{"frames", translatable("By measure"),
        translatable("Angles and lengths of the polyhedron count: uneven cages give even surfaces"),
        has_frames},
    Row{"mirror", translatable("Mirror"),
        translatable("Model one half; its image completes the object at once."), is_polyhedron},
    Row{"split_concave", translatable("Convex faces"),
        translatable("The surface is made as if concave faces were cut into convex ones"), is_polyhedron},
    Row{"automatic_tension", translatable("Auto tension"),
        translatable("Stretches short edges and relaxes long ones; at rest while you drag"), is_polyhedron},
    Row{"density", translatable("Density"),
        translatable("Least intervals a patch side on the screen; small models are drawn finer"),
        is_polyhedron},
    Row{"envelope_method", translatable("Method"), translatable("What decides the surface's shape"),
        is_solids},
    Row{"tightness", translatable("Tightness"),
        translatable("0 is the rounded hull, 1 rolls the smallest ball into the notches"), is_ball},
    Row{"rounding", translatable("Rounding"),
        translatable("Edges are rounded by one and a half times this length; faces lie about as far "
                     "outside of the solids as it is long"),
        is_ball},
    Row{"roundness", translatable("Roundness"), translatable("Of the parts round single solids"), is_network},
    Row{"clearance", translatable("Clearance"), translatable("Distance that is kept from every solid"),
        is_solids},
    Row{"on_faces", translatable("On the faces"),
        translatable("Flat faces of the surface lie on those of the solids, and edges stick out; off, the "
                     "surface contains the solids"),
        is_ball},
    Row{"finer_patches", translatable("Finer patches"),
        translatable("About twice as many patches, which are nearer to the shape"), is_ball},
    Row{"envelope_symmetry", translatable("Symmetry"),
        translatable("A plane through the object's zero, across an axis of the object"), is_solids},
    Row{"skin_method", translatable("Method"), translatable("How the surface spans the sections"), is_skin},
    Row{"skin_frame", translatable("Rails"), translatable("How sections turn along the path"), is_skin},
    Row{"skin_closed", translatable("Tube"),
        translatable("Sections are closed curves and the skin is a tube"), is_skin},
    Row{"skin_caps", translatable("Ends"), translatable("What closes a tube"), is_skin},
    Row{"skin_mirror", translatable("Mirror"), translatable("Edits of sections change both halves"), is_skin},
    Row{"skin_closed_path", translatable("Closed path"), translatable("The path runs back to its beginning"),
        is_skin},
    Row{"skin_density", translatable("Density"), translatable("Rows for each span of the path"), is_pleated},
    Row{"skin_fit", translatable("Fit sections"),
        translatable("Whether the surface goes through the sections between the ends"), is_pleated},
    Row{"skin_tension", translatable("Tension"),
        translatable("Low flows like a spline, high runs straight from section to section"), is_pleated},
    Row{"skin_match", translatable("Match by"),
        translatable("How points find those of the next section where no line is drawn"), is_pleated},
    Row{"skin_quads", translatable("Quads in fans"),
        translatable("Pairs of triangles become quads: rounder where lines merge"), is_pleated},
    Row{"skin_collars", translatable("Collars"),
        translatable("Rows of their own beside sections, so that these can be exact"), is_pleated},
    Row{"skin_columns", translatable("Columns"),
        translatable("Control points across; 0: as many as the sections suggest"), is_grid},
    Row{"skin_rows", translatable("Rows"),
        translatable("Control points along; 0: as many as the path suggests"), is_grid},
    Row{"skin_blend", translatable("Blend"), translatable("How one section becomes the next"), is_grid},
    Row{"skin_creases", translatable("Creases"),
        translatable("Corners of sections become sharp edges of the surface"), is_skin},
    Row{"skin_flip", translatable("Inside out"), translatable("Swaps the outside and the inside"), is_skin},
};

WhyNot needs(const Editor& editor, Has has) {
  return [&editor, has]() -> Reason {
    const Object* object = editor.has_document ? editor.active_object() : nullptr;
    if (!object) return translatable("No object is active. Click one in the list of objects.");
    if (object->locked) return translatable("The object is locked. Unlock it in the list of objects.");
    if (has(*object)) return {};
    return translatable("The active object does not have this property.");
  };
}

Command property(std::string id, std::string menu, const char* label, const char* help,
                 std::function<void()> run, WhyNot why_not) {
  return {.id = "property." + std::move(id),
          .menu = std::move(menu),
          .label = label,
          .help = help,
          .needs_window = true,
          .run = std::move(run),
          .why_not = std::move(why_not),
          .in_menu = false};
}

constexpr const char* properties = translatable("Properties");

std::string menu_of(Has has) {
  if (has == any_object) return properties;
  const bool shaped = has == is_polyhedron || has == has_frames;
  const char* kind = shaped             ? translatable("Polyhedron")
                     : has == is_solids ? translatable("Solids")
                                        : translatable("Skin");
  return std::string(properties) + "/" + kind;
}

constexpr const char* in_preferences = translatable("A choice for the program, in the preferences.");

/// Choices of the first rows of skins, made without a look for their list.
void add_skin_choices(CommandHost& host) {
  Editor& editor = host.editor;
  for (const SkinChoice& choice : skin_choices()) {
    Command command = property(
        choice.id, menu_of(is_skin) + "/" + choice.list, choice.label, choice.help,
        [&editor, choose = choice.choose] { choose(editor, *shown_skin(editor)); },
        only_if(
            needs(editor, is_skin), [&editor] { return shown_skin(editor) != nullptr; },
            translatable("No skin is active. Click one in the list of objects.")));
    command.changes_document = true;
    command.needs_window = false;
    host.table.add(std::move(command));
  }
}

}  // namespace

void add_property_commands(CommandHost& host, Workbench& workbench) {
  for (const Row& row : rows)
    host.table.add(property(
        row.id, menu_of(row.has), row.label, row.help,
        [&workbench, id = row.id] { workbench.show_property(id); }, needs(host.editor, row.has)));
  add_skin_choices(host);
  for (const PreferenceRow& row : preference_rows())
    host.table.add(property(std::string("preferences.") + row.member, translatable("Preferences"), row.label,
                            *row.note ? row.note : in_preferences,
                            [&workbench, page = row.page] { workbench.show_preferences(page); }, {}));
  use_properties_in_scripts(host);
}

}  // namespace hariko
