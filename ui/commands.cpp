// The commands of a workbench: what menus, shortcuts and buttons can do.

#include <algorithm>

#include "ui/icons.hpp"
#include "ui/workbench.hpp"

namespace hariko {

namespace {

constexpr const char* no_vertices = "No vertices are selected. Press 1 and click one.";
constexpr const char* no_edges = "No edges are selected. Press 2 and click one.";

std::vector<VertexId> vertices_of(const Editor& editor) {
  const auto& ids = editor.selection.of_active().vertices;
  return {ids.begin(), ids.end()};
}

std::vector<EdgeId> edges_of(const Editor& editor) {
  const auto& ids = editor.selection.of_active().edges;
  return {ids.begin(), ids.end()};
}

}  // namespace

void Workbench::add_file_commands() {
  const auto document = [this] { return needs_document(); };
  commands_.add({"file.open", "File", "Open\u2026", "Open a Hariko document or a mesh.", "Ctrl+O", icon::open,
                 false, false, [this] {
                   dialog_.open({"Open",
                                 "Open",
                                 false,
                                 {".hariko", ".obj", ".off", ".ply", ".stl"},
                                 folder_proposal(),
                                 [this](const auto& path) { open_guarded(path); }});
                 }});
  commands_.add({"file.save", "File", "Save", "Save the document.", "Ctrl+S", icon::save, false, false,
                 [this] { save({}); }, document});
  commands_.add({"file.save_as", "File", "Save as\u2026", "Save the document under another name.",
                 "Ctrl+Shift+S", "", false, false, [this] { save_as({}); }, document});
  commands_.add({"file.import", "File", "Import\u2026", "Add the polyhedron of a mesh file to the document.",
                 "Ctrl+I", icon::import_file, true, true, [this] {
                   dialog_.open({"Import a mesh",
                                 "Import",
                                 false,
                                 {".obj", ".off", ".ply", ".stl"},
                                 folder_proposal(),
                                 [this](const auto& path) { actions_.import_file(path); }});
                 }});
  commands_.add({"file.export", "File", "Export\u2026", "Write the surfaces as triangles.", "Ctrl+E",
                 icon::export_file, false, false, [this] { show_export_dialog(); }, document});
  commands_.add({"file.close", "File", "Close", "Close the document and go to the start page.", "Ctrl+W", "",
                 false, true,
                 [this] {
                   guarded([this] {
                     editor_.open({}, {});
                     editor_.has_document = false;
                   });
                 },
                 document});
  commands_.add({"file.quit", "File", "Quit", "Leave Hariko.", "Ctrl+Q", "", false, false,
                 [this] { guarded(actions_.quit); }});
}

void Workbench::save_as(std::function<void()> then) {
  const std::filesystem::path proposal =
      editor_.path ? *editor_.path : std::filesystem::path("Untitled.hariko");
  dialog_.open(
      {"Save as", "Save", true, {".hariko"}, proposal, [this, then = std::move(then)](const auto& path) {
         actions_.save(path, then);
       }});
}

void Workbench::show_export_dialog() {
  std::filesystem::path proposal = folder_proposal() / (editor_.path ? editor_.path->stem() : "Untitled");
  proposal += ".obj";
  dialog_.open({"Export the surfaces as triangles",
                "Export",
                true,
                {".obj", ".stl", ".ply"},
                proposal,
                [this](const auto& path) { actions_.export_file(path, export_density_); },
                [this] {
                  ImGui::AlignTextToFramePadding();
                  ImGui::TextUnformatted("Density");
                  ImGui::SameLine(metrics_.px(80));
                  ImGui::SetNextItemWidth(metrics_.px(220));
                  ImGui::SliderInt("intervals a patch side", &export_density_, 1, 64);
                }});
}

void Workbench::add_edit_commands() {
  commands_.add({"edit.undo", "Edit", "Undo", "Take back the last step.", "Ctrl+Z", icon::undo, true, false,
                 [this] { editor_.undo(); },
                 [this]() -> std::optional<std::string> {
                   if (editor_.history.can_undo()) return {};
                   return "There is nothing to undo.";
                 }});
  commands_.add({"edit.redo", "Edit", "Redo", "Make the step again that was taken back.",
                 "Ctrl+Shift+Z / Ctrl+Y", icon::redo, true, false, [this] { editor_.redo(); },
                 [this]() -> std::optional<std::string> {
                   if (editor_.history.can_redo()) return {};
                   return "There is nothing to redo.";
                 }});
  const auto object = [this] { return needs_object(); };
  commands_.add({"object.duplicate", "Edit", "Duplicate object", "Copy the active object in place.", "Ctrl+D",
                 "", true, true,
                 [this] {
                   const auto added = duplicate_object(editor_.history.current(), editor_.selection.active);
                   if (!added.ok()) return editor_.notify(added.error());
                   editor_.commit(added->document, "Duplicate object");
                   editor_.selection.clear_elements();
                   editor_.selection.active = added->id;
                 },
                 object});
  commands_.add({"object.delete", "Edit", "Delete object", "Delete the active object.", "Del", icon::trash,
                 true, false,
                 [this] {
                   const ObjectId id = editor_.selection.active;
                   editor_.commit(delete_objects(editor_.history.current(), {&id, 1}), "Delete object");
                 },
                 object});
}

void Workbench::add_select_commands() {
  const auto mode = [this](const char* id, const char* label, const char* keys, const char* symbol,
                           ElementMode value) {
    commands_.add({id,
                   "Select",
                   label,
                   "What a click takes.",
                   keys,
                   symbol,
                   false,
                   false,
                   [this, value] { editor_.mode = value; },
                   {},
                   [this, value] { return editor_.mode == value; }});
  };
  mode("select.vertices", "Vertices", "1", icon::vertex, ElementMode::vertex);
  mode("select.edges", "Edges", "2", icon::edge, ElementMode::edge);
  mode("select.faces", "Faces", "3", icon::face, ElementMode::face);
  commands_.add({"select.all", "Select", "All", "Select every element of the active object.", "Ctrl+A", "",
                 false, true,
                 [this] { editor_.selection.select_all(*editor_.active_object(), editor_.mode); },
                 [this] { return needs_object(); }});
  commands_.add({"select.none", "Select", "None", "Select nothing.", "Ctrl+Shift+A", "", false, false,
                 [this] { editor_.selection.clear_elements(); }});
}

void Workbench::add_shape_commands() {
  const auto with_vertices = [this]() -> std::optional<std::string> {
    if (vertices_of(editor_).empty()) return no_vertices;
    return {};
  };
  const auto with_edges = [this]() -> std::optional<std::string> {
    if (edges_of(editor_).empty()) return no_edges;
    return {};
  };
  commands_.add({"shape.crease", "Shape", "Crease edges", "Make the selected edges sharp, or smooth again.",
                 "C", "", true, false,
                 [this] {
                   const auto ids = edges_of(editor_);
                   const auto& crease = editor_.active_object()->polyhedron()->shaping->crease;
                   const bool all =
                       std::all_of(ids.begin(), ids.end(), [&](EdgeId id) { return crease.contains(id); });
                   editor_.commit(set_crease(editor_.history.current(), editor_.selection.active, ids, !all),
                                  all ? "Smooth edges" : "Crease edges");
                 },
                 with_edges});
  commands_.add({"shape.corner", "Shape", "Corner vertices", "Tag the selected vertices as corners.", "K", "",
                 true, false,
                 [this] {
                   editor_.commit(set_vertex_tag(editor_.history.current(), editor_.selection.active,
                                                 vertices_of(editor_), VertexTag::corner),
                                  "Corner vertices");
                 },
                 with_vertices});
  commands_.add({"shape.reset_tension", "Shape", "Reset tension",
                 "Set \u03b1 of the selection to 0 and \u03b2 to 1.", "Shift+T", "", true, false,
                 [this] {
                   const ObjectId id = editor_.selection.active;
                   const auto first = set_alpha(editor_.history.current(), id, vertices_of(editor_), 0);
                   if (!first.ok()) return editor_.notify(first.error());
                   editor_.commit(set_beta(*first, id, edges_of(editor_), 1), "Reset tension");
                 },
                 [this]() -> std::optional<std::string> {
                   if (!vertices_of(editor_).empty() || !edges_of(editor_).empty()) return {};
                   return "Nothing is selected. Click a vertex or an edge.";
                 }});
}

void Workbench::add_view_commands() {
  const auto document = [this] { return needs_document(); };
  commands_.add({"view.frame_all", "View", "Frame all", "Show everything.", "Home", icon::frame, false, false,
                 [this] { editor_.frame_all(); }, document});
  commands_.add({"view.frame_selection", "View", "Frame selection", "Come close to what is selected.", "F",
                 "", false, false, [this] { editor_.frame_selection(); }, document});
  const auto standard = [&](const char* id, const char* label, const char* keys, StandardView view,
                            bool first) {
    commands_.add({id, "View", label, "Look from this side.", keys, "", false, first,
                   [this, view] {
                     Camera camera = editor_.camera();
                     camera.orientation = Camera::standard(view).orientation;
                     editor_.fly_to(camera);
                   },
                   document});
  };
  standard("view.front", "Front", "Num 1", StandardView::front, true);
  standard("view.back", "Back", "Ctrl+Num 1", StandardView::back, false);
  standard("view.right", "Right", "Num 3", StandardView::right, false);
  standard("view.left", "Left", "Ctrl+Num 3", StandardView::left, false);
  standard("view.top", "Top", "Num 7", StandardView::top, false);
  standard("view.bottom", "Bottom", "Ctrl+Num 7", StandardView::bottom, false);
  standard("view.iso", "Three-quarter", "Num 0", StandardView::iso, false);
  commands_.add({"view.orthographic", "View", "Orthographic", "Parallel instead of perspective projection.",
                 "Num 5", "", false, true,
                 [this] {
                   Camera camera = editor_.camera();
                   camera.orthographic = !camera.orthographic;
                   editor_.set_camera(camera);
                 },
                 document, [this] { return editor_.camera().orthographic; }});
  commands_.add({"view.x_ray",
                 "View",
                 "X-ray",
                 "See and pick through the surface.",
                 "X",
                 icon::shown,
                 false,
                 false,
                 [this] { editor_.view.x_ray = !editor_.view.x_ray; },
                 {},
                 [this] { return editor_.view.x_ray; }});
  commands_.add({"view.grid",
                 "View",
                 "Ground grid",
                 "Show the ground.",
                 "G",
                 "",
                 false,
                 false,
                 [this] { editor_.view.grid = !editor_.view.grid; },
                 {},
                 [this] { return editor_.view.grid; }});
}

}  // namespace hariko
