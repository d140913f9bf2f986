// Commands that show how good a surface is, and how it is shown.

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/edits/edits.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/object_size.hpp"
#include "ui/widgets/command_services.hpp"
#include "ui/widgets/enum_labels.hpp"

namespace hariko {

namespace {

using Change = std::function<void(DisplaySettings&)>;

/// The chosen objects in object mode, else the active one.
std::vector<ObjectId> objects_to_analyse(const Editor& editor) {
  const auto& chosen = editor.selection.objects();
  if (editor.mode != ElementMode::object || chosen.empty()) return {editor.selection.active};
  return {chosen.begin(), chosen.end()};
}

/// One step for all chosen objects. What the active one has changes; the others become like it.
void change_display(Editor& editor, const std::string& step, const Change& change,
                    const std::function<void(const DisplaySettings& from, DisplaySettings& to)>& copy) {
  const Object* active = editor.active_object();
  if (!active) return;
  DisplaySettings model = active->display;
  change(model);
  Result<Document> result = editor.history.current();
  for (const ObjectId id : objects_to_analyse(editor)) {
    const Object* object = result->find(id);
    if (!object) continue;
    DisplaySettings display = object->display;
    if (id == active->id)
      display = model;
    else
      copy(model, display);
    result = set_display(*result, id, display);
    if (!result) break;
  }
  editor.commit(result, step);
}

template <class Get>
std::function<bool()> shows(const Editor& editor, Get get) {
  return [&editor, get] {
    const Object* object = editor.active_object();
    return object && get(object->display);
  };
}

/// Reason why no surface could show a map.
Reason nothing_shows(const Editor& editor, SurfaceMap map) {
  const auto& objects = editor.document().objects;
  const auto able = std::ranges::count_if(
      objects, [&](const auto& object) { return object->visible && can_show(*object, map); });
  if (map == SurfaceMap::deviation && able == 1)
    return translatable("A deviation needs two visible objects with a surface or facets.");
  if (able > 0) return {};
  return translatable("No visible object has a surface with this map.");
}

/// Colours all surfaces; the map that is on goes off again.
void show_map(Editor& editor, SurfaceMap map) {
  std::optional<SurfaceMap>& shown = editor.view.map.map;
  if (map == SurfaceMap::shaded) editor.view.environment = false;
  if (map == SurfaceMap::shaded || shown == map)
    shown.reset();
  else
    shown = map;
  const Object* reference = editor.document().find(editor.document().making.reference);
  if (shown == SurfaceMap::deviation && !(reference && reference->visible))
    editor.inform("Choose the reference of the deviation in the properties.");
  std::size_t own = 0;
  for (const auto& object : editor.document().objects)
    own += object->visible && object->has_surface() && object->display.map != SurfaceMap::shaded ? 1 : 0;
  const Language& tr = editor.language;
  if (own > 0)
    editor.notify(Notice::Kind::info,
                  tr.counted(own, "1 object keeps the map that its properties give it.",
                             "{0} objects keep the maps that their properties give them."));
}

/// Submenu of the maps of making. Menus show its folders one by one, each by its own name.
constexpr const char* making_menu = "Analyse/Making";
static_assert(std::string_view(making_menu).ends_with(translatable("Making")));

void add_maps(CommandHost& host) {
  struct Entry {
    const char *id, *label, *help, *keys;
    SurfaceMap map;
    const char* menu = "Analyse";
  };
  static const std::array<Entry, surface_map_count> entries{{
      {"analyse.shaded", "Shaded", "Show surfaces in their materials.", "", SurfaceMap::shaded},
      {"analyse.zebra", "Zebra", "Reflect stripes in all surfaces: kinks in them show jumps of curvature.",
       "Alt+Z", SurfaceMap::zebra},
      {"analyse.isophotes", "Isophotes", "Show bands of equal angle to a direction on all surfaces.", "Alt+1",
       SurfaceMap::isophotes},
      {"analyse.gauss", "Gaussian curvature", "Colour all surfaces by their Gaussian curvature.", "Alt+2",
       SurfaceMap::gaussian},
      {"analyse.mean", "Mean curvature", "Colour all surfaces by their mean curvature.", "Alt+3",
       SurfaceMap::mean},
      {"analyse.k1", "Greatest curvature", "Colour all surfaces by their greatest curvature.", "Alt+4",
       SurfaceMap::principal_max},
      {"analyse.k2", "Least curvature", "Colour all surfaces by their least curvature.", "Alt+5",
       SurfaceMap::principal_min},
      {"analyse.continuity", "Continuity", "Colour all edges by how much curvature jumps across them.",
       "Alt+6", SurfaceMap::continuity},
      {"analyse.patches", "Patches", "Give each patch a colour, on all surfaces.", "Alt+7",
       SurfaceMap::patches},
      {"analyse.draft", "Draft angle", "Mark walls that are too steep to leave a mould, and undercuts.", "",
       SurfaceMap::draft, making_menu},
      {"analyse.radius", "Smallest radius", "Mark where all surfaces are bent too tightly for a tool.", "",
       SurfaceMap::radius, making_menu},
      {"analyse.thickness", "Wall thickness", "Mark thin walls of all closed surfaces.", "",
       SurfaceMap::thickness, making_menu},
      {"analyse.deviation", "Deviation", "Colour all surfaces by their distance from a reference object.", "",
       SurfaceMap::deviation, making_menu},
  }};
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  for (const Entry& entry : entries) {
    const SurfaceMap map = entry.map;
    MenuRows(host.table, entry.menu)
        .add(
            entry.id, entry.label, entry.help, [&editor, map] { show_map(editor, map); },
            [&editor, document, map]() -> Reason {
              if (auto reason = document()) return reason;
              return nothing_shows(editor, map);
            },
            {.keys = entry.keys, .checked = [&editor, map] {
               const bool mirrors = map == SurfaceMap::shaded && editor.view.environment;
               return editor.view.map.map.value_or(SurfaceMap::shaded) == map && !mirrors;
             }});
  }
}

/// Turns the environment off where it is seen, else on; a map that hides it goes off.
void switch_environment(Editor& editor) {
  if (editor.view.environment && !editor.view.map.map)
    editor.view.environment = false;
  else
    editor.show_environment(editor.settings.environment.kind);
}

void add_environment_switch(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  MenuRows(host.table, "Analyse")
      .add(
          "analyse.environment", "Environment",
          "Let shaded surfaces reflect a studio, light tubes, a horizon, a sky or a panorama.",
          [&editor] { switch_environment(editor); },
          [&editor, document]() -> Reason {
            if (auto reason = document()) return reason;
            return nothing_shows(editor, SurfaceMap::shaded);
          },
          {.keys = "Alt+8",
           .checked = [&editor] { return editor.view.environment && !editor.view.map.map; }});
}

void add_switches(CommandHost& host) {
  Editor& editor = host.editor;
  using Flag = bool& (*)(DisplaySettings&);
  const auto flag = [&](const char* menu, const char* id, const char* label, const char* help,
                        const WhyNot& why_not, const char* step, Flag get, Command more) {
    more.checked = shows(editor, [get](DisplaySettings d) { return get(d); });
    const auto turn = [&editor, get, step] {
      change_display(
          editor, step, [get](DisplaySettings& d) { get(d) = !get(d); },
          [get](DisplaySettings from, DisplaySettings& to) { get(to) = get(from); });
    };
    MenuRows(host.table, menu).add_edit(id, label, help, turn, why_not, std::move(more));
  };
  const auto show = [&](const char* id, const char* label, const char* help, const WhyNot& why_not,
                        const char* step, Flag get) {
    flag("View/Show", id, label, help, why_not, step, get, {.while_tool_runs = true});
  };
  const WhyNot surface = needs_shown_surface(editor), curves = needs_shown_surface(editor, true),
               polyhedron = needs_polyhedron(editor);
  flag("Analyse", "analyse.combs", "Curvature combs",
       "Show teeth as long as the network's curves are curved.", curves, "Curvature combs",
       [](DisplaySettings& d) -> bool& { return d.combs.shown; },
       {.keys = "Alt+C", .separator_before = true});
  flag("Analyse", "analyse.marks", "Edge continuity", "Mark the edges by their continuity: G0, G1, G2.",
       curves, "Edge continuity", [](DisplaySettings& d) -> bool& { return d.marks; }, {.keys = "Alt+E"});
  flag("Analyse", "analyse.tensions", "Tensions", "Show tensions as colours and numbers.", polyhedron,
       "Show tensions", [](DisplaySettings& d) -> bool& { return d.tensions; }, {.keys = "Alt+T"});
  show("show.surface", "Surface", "Show the surface.", surface, "Show surface",
       [](DisplaySettings& d) -> bool& { return d.surface; });
  show("show.polyhedron", "Polyhedron", "Show the polyhedron, or what else the surface is made from.",
       surface, "Show polyhedron", [](DisplaySettings& d) -> bool& { return d.polyhedron; });
  show("show.network", "Network", "Show the curves over the edges.", curves, "Show network",
       [](DisplaySettings& d) -> bool& { return d.network; });
  show("show.points", "Points", "Show the vertices.", polyhedron, "Show points",
       [](DisplaySettings& d) -> bool& { return d.points; });
}

/// Makes the teeth longer by a factor; twice or half as many where `density` is positive or negative.
void change_combs(Editor& editor, double scale, int density) {
  change_display(
      editor, "Curvature combs",
      [scale, density](DisplaySettings& d) {
        d.combs.scale = std::clamp(d.combs.scale * scale, CombSettings::min_scale, CombSettings::max_scale);
        const int wanted = density > 0 ? d.combs.density * 2 : d.combs.density / 2;
        if (density != 0)
          d.combs.density = std::clamp(wanted, CombSettings::min_density, CombSettings::max_density);
      },
      [](const DisplaySettings& from, DisplaySettings& to) { to.combs = from.combs; });
}

void add_combs(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot why_not = only_if(
      needs_shown_surface(editor, true), [&editor] { return editor.active_object()->display.combs.shown; },
      translatable("The curvature combs are not shown."));
  const auto add = [&](const char* id, const char* label, const char* help, double scale, int density) {
    MenuRows(host.table, "Analyse/Combs")
        .add_edit(
            id, label, help, [&editor, scale, density] { change_combs(editor, scale, density); }, why_not);
  };
  add("analyse.combs_longer", "Longer teeth", "Double the length of the teeth.", 2, 0);
  add("analyse.combs_shorter", "Shorter teeth", "Halve the length of the teeth.", 0.5, 0);
  add("analyse.combs_denser", "More teeth", "Double the number of teeth.", 1, 1);
  add("analyse.combs_sparser", "Fewer teeth", "Halve the number of teeth.", 1, -1);
}

void wear(Editor& editor, Material material) {
  const auto dress = [material](DisplaySettings& d) {
    d = with_material(d, material);
    d.map = SurfaceMap::shaded;
  };
  editor.view.environment = false;  // it would hide the material
  change_display(editor, "Material", dress,
                 [dress](const DisplaySettings&, DisplaySettings& to) { dress(to); });
}

void add_materials(CommandHost& host) {
  const WhyNot why_not = needs_shown_surface(host.editor);
  for (const Material material : enum_values<Material>()) {
    MenuRows(host.table, "View/Material")
        .add_edit(
            "material." + std::string(enum_word(material)), enum_choice(material).label,
            "Show the surface in this material.",
            [&editor = host.editor, material] { wear(editor, material); }, why_not,
            {.while_tool_runs = true, .checked = shows(host.editor, [material](const DisplaySettings& d) {
                                        return d.material == material;
                                      })});
  }
}

/// The plane goes to the middle of what is visible where it lies outside.
void show_section(Editor& editor) {
  ViewSettings::Section& section = editor.view.section;
  section.shown = !section.shown;
  const Box3 box = box_of_visible(editor.document());
  const bool outside = !box.isEmpty() && !(section.offset >= box.min()[section.axis] &&
                                           section.offset <= box.max()[section.axis]);
  if (section.shown && outside) section.offset = box.center()[section.axis];
}

void add_view_switches(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  MenuRows rows(host.table, "Analyse");
  rows.add("analyse.section", "Section plane", "Cut surfaces away beyond a plane.",
           [&editor] { show_section(editor); }, document,
           {.keys = "Alt+S", .separator_before = true, .checked = [&editor] {
              return editor.view.section.shown;
            }});
  rows.add_switch(
      "analyse.section_flip", "Other side of the section", "Keep the half that the section plane cuts away.",
      editor.view.section.flipped,
      {.why_not = only_if([&editor] { return editor.view.section.shown; },
                          translatable("There is no section plane. Choose Section plane first."))});
  rows.add_switch("analyse.colour_blind", "Colour-blind-safe maps",
                  "Colour maps so that all kinds of colour vision can read them.",
                  editor.settings.colour_blind_maps, {.separator_before = true});
}

/// Four views for four pictures; the views from before come back after it.
void compare_meshes(Editor& editor, bool on) {
  Meshing& meshing = editor.meshing;
  meshing.settings.compare = on;
  meshing.stopped = false;
  if (on) {
    meshing.kept_layout = editor.layout;
    editor.layout.arrange(Arrangement::four);
  } else if (meshing.kept_layout) {
    const View now = editor.layout.active_view();
    editor.layout = *meshing.kept_layout;
    editor.layout.active_view() = now;
    meshing.kept_layout.reset();
  }
}

void show_triangles(Editor& editor) {
  if (editor.meshing.comparing()) compare_meshes(editor, false);
  editor.meshing.open = !editor.meshing.open;
}

void show_four_meshes(Editor& editor) {
  editor.meshing.open = true;
  compare_meshes(editor, !editor.meshing.settings.compare);
}

void add_meshing(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  MenuRows(host.table, "Analyse")
      .add("analyse.mesh", "Triangles",
           "Show the surface as triangles within a tolerance, and maps of their errors.",
           [&editor] { show_triangles(editor); }, document,
           {.keys = "Ctrl+Alt+T", .separator_before = true, .checked = [&editor] {
              return editor.meshing.open;
            }});
  MenuRows(host.table, "Analyse")
      .add("analyse.mesh_compare", "Compare four pictures",
           "Show meshes made by distance and by normal angle, each with both of its errors.",
           [&editor] { show_four_meshes(editor); }, document,
           {.checked = [&editor] { return editor.meshing.comparing(); }});
}

}  // namespace

void add_analyse_commands(CommandHost& host) {
  add_maps(host);
  add_environment_switch(host);
  add_switches(host);
  add_combs(host);
  add_view_switches(host);
  add_materials(host);
  add_environment_commands(host);
  add_meshing(host);
}

// Commands that choose the environment which shaded surfaces reflect.

namespace {

std::string environment_menu() {
  return submenu("View", translatable("Environment"));
}

bool shows_environment(const Editor& editor, EnvironmentKind kind) {
  return editor.view.environment && !editor.view.map.map && editor.settings.environment.kind == kind;
}

void add_made_environments(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  for (const EnvironmentKind kind : enum_values<EnvironmentKind>()) {
    if (kind == EnvironmentKind::file) continue;
    MenuRows(host.table, environment_menu())
        .add("environment." + std::string(enum_word(kind)), enum_choice(kind).label,
             "Let shaded surfaces reflect this environment.",
             [&editor, kind] { editor.show_environment(kind); }, document,
             {.while_tool_runs = true,
              .checked = [&editor, kind] { return shows_environment(editor, kind); }});
  }
}

/// Turns by a step; whole turns come back to the same number.
void turn_environment(Editor& editor, double degrees) {
  double& turn = editor.settings.environment.turn;
  turn += degrees;
  if (turn >= 360) turn -= 360;
  if (turn < 0) turn += 360;
}

void add_environment_turns(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot shown =
      only_if([&editor] { return editor.view.environment; },
              translatable("No environment is shown. Choose Environment in the menu Analyse first."));
  MenuRows rows(host.table, environment_menu());
  rows.next_group();
  const auto add = [&](const char* id, const char* label, const char* help, double degrees) {
    rows.add(id, label, help, [&editor, degrees] { turn_environment(editor, degrees); }, shown,
             {.while_tool_runs = true});
  };
  constexpr double step = 15;
  add("environment.turn_left", "Turn to the left",
      "Turn the environment by 15 degrees, clockwise from above.", -step);
  add("environment.turn_right", "Turn to the right",
      "Turn the environment by 15 degrees, anticlockwise from above.", step);
}

}  // namespace

void add_environment_commands(CommandHost& host) {
  Editor& editor = host.editor;
  CommandServices& services = host.services;
  add_made_environments(host);
  MenuRows(host.table, environment_menu())
      .add("environment.file", "Picture file\u2026",
           "Let shaded surfaces reflect a panorama: a Radiance, PNG or JPEG picture twice as wide as high.",
           [&services] { services.choose_environment(); }, needs_document(editor),
           {.while_tool_runs = true, .needs_window = true, .checked = [&editor] {
              return shows_environment(editor, EnvironmentKind::file);
            }});
  add_environment_turns(host);
}

}  // namespace hariko
