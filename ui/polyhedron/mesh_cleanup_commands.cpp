// Commands of the Mesh menu that tidy, connect, take apart and mirror what is there.

#include <array>
#include <utility>

#include "core/document/edits/edit_solids.hpp"
#include "core/document/edits/edits.hpp"
#include "core/modeling/cuts/bisect.hpp"
#include "core/modeling/cuts/cut_faces.hpp"
#include "core/modeling/operations/bridge.hpp"
#include "core/modeling/operations/delete_elements.hpp"
#include "core/modeling/operations/dissolve.hpp"
#include "core/modeling/operations/fill_hole.hpp"
#include "core/modeling/operations/flip.hpp"
#include "core/modeling/operations/join.hpp"
#include "core/modeling/operations/merge_vertices.hpp"
#include "core/modeling/operations/separate.hpp"
#include "core/modeling/selection/select_convert.hpp"
#include "core/modeling/selection/select_region.hpp"
#include "core/modeling/surfacing/mirrored.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/operations.hpp"
#include "ui/editor/outlines.hpp"
#include "ui/editor/skin_edits.hpp"
#include "ui/editor/skin_view.hpp"
#include "ui/view/transform_target.hpp"

namespace hariko {

namespace {

const std::string merge_menu = std::string("Mesh") + "/" + translatable("Merge");
const std::string mirror_menu = std::string("Mesh") + "/" + translatable("Mirror");

/// Welding distance of the live mirror's seam, and for merging: this share of the object's size.
constexpr double weld_share = 1e-3;

/// The kind of elements that a command works on: the one that clicks take, if some of it are selected.
ElementKind kind_at_hand(const Editor& editor) {
  const ElementSet& set = editor.selection.of_active();
  if (editor.mode == ElementMode::face && !set.faces.empty()) return ElementKind::face;
  if (editor.mode == ElementMode::edge && !set.edges.empty()) return ElementKind::edge;
  if (editor.mode == ElementMode::vertex && !set.vertices.empty()) return ElementKind::vertex;
  return !set.faces.empty()   ? ElementKind::face
         : !set.edges.empty() ? ElementKind::edge
                              : ElementKind::vertex;
}

double size_of(const PolyhedronSource& source) {
  Box3 box;
  for (Index v = 0; v < source.polyhedron.vertex_count(); ++v) box.extend(source.polyhedron.position(v));
  return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

Result<EditResult> deleted(const PolyhedronSource& source, const ElementSet& set, ElementKind kind) {
  if (kind == ElementKind::face) return delete_faces(source, list_of(set.faces));
  if (kind == ElementKind::edge) return delete_edges(source, list_of(set.edges));
  return delete_vertices(source, list_of(set.vertices));
}

Result<EditResult> dissolved(const PolyhedronSource& source, const ElementSet& set, ElementKind kind) {
  if (kind == ElementKind::face) return dissolve_faces(source, list_of(set.faces));
  if (kind == ElementKind::edge) return dissolve_edges(source, list_of(set.edges));
  return dissolve_vertices(source, list_of(set.vertices));
}

void delete_points(Editor& editor, const Object& object) {
  const std::set<Index> points = selected_points(editor, object);
  const bool done = change_outline(
      editor, [&](const Outline& outline) { return without_points(outline, points); },
      translatable("Delete points"));
  if (done) editor.selection.clear_elements();
}

/// A chosen dimension, else elements when some are selected, else the objects that are chosen, else the
/// active one.
void delete_selection(Editor& editor) {
  if (const auto dimension = editor.dimensions.chosen(editor)) {
    editor.commit(remove_dimensions(editor.history.current(), std::array{*dimension}),
                  translatable("Delete dimension"));
    return;
  }
  if (editor.mode != ElementMode::object && !editor.selection.of_active().empty()) {
    if (shown_skin(editor)) return delete_selected_points(editor);
    if (const Object* outline = active_outline(editor)) return delete_points(editor, *outline);
    const ElementSet set = editor.selection.of_active();
    if (editor.active_object()->solids()) {
      std::vector<std::uint32_t> ids;
      for (const VertexId id : set.vertices) ids.push_back(id.value);
      editor.commit(remove_solids(editor.history.current(), editor.selection.active, ids),
                    ids.size() == 1 ? translatable("Delete solid") : translatable("Delete solids"));
      return;
    }
    const ElementKind kind = kind_at_hand(editor);
    const char* label = kind == ElementKind::face   ? translatable("Delete faces")
                        : kind == ElementKind::edge ? translatable("Delete edges")
                                                    : translatable("Delete vertices");
    run_operation(
        editor, [&](const PolyhedronSource& source) { return deleted(source, set, kind); }, label);
    return;
  }
  std::vector<ObjectId> objects = list_of(editor.selection.objects());
  if (objects.empty() || editor.mode != ElementMode::object) objects = {editor.selection.active};
  editor.commit(delete_objects(editor.history.current(), objects),
                objects.size() == 1 ? translatable("Delete object") : translatable("Delete objects"));
}

/// The vertex that was clicked first or last, while it is selected.
std::optional<VertexId> clicked_vertex(const Editor& editor, MergeAt at) {
  const auto& clicked = at == MergeAt::first ? editor.selection.first : editor.selection.last;
  if (!clicked || clicked->element.kind != Element::Kind::vertex) return {};
  if (clicked->object != editor.selection.active || !editor.selection.contains(*clicked)) return {};
  return VertexId{static_cast<std::uint32_t>(clicked->element.id)};
}

void merge_at(Editor& editor, MergeAt at, const char* label) {
  std::vector<VertexId> ids = list_of(editor.selection.of_active().vertices);
  if (at != MergeAt::centre) {
    const VertexId target = *clicked_vertex(editor, at);
    std::erase(ids, target);
    ids.insert(at == MergeAt::first ? ids.begin() : ids.end(), target);
  }
  run_operation(
      editor, [&](const PolyhedronSource& source) { return merge_vertices(source, ids, at); }, label);
}

MakeOperation merging_near(const Editor& editor) {
  const ObjectId object = editor.selection.active;
  const auto ids =
      touched_vertices(editor.selection.of_active(), editor.active_object()->polyhedron()->polyhedron);
  return [object, ids](const Document& document,
                       std::span<const OperationNumber> n) -> Result<OperationResult> {
    auto done = edit_polyhedron(
        document, object, [&](const PolyhedronSource& s) { return merge_by_distance(s, ids, n[0].value); });
    if (!done) return done.error();
    return OperationResult{std::move(done->document), object, std::move(done->selection)};
  };
}

std::vector<WrittenCommand> written_merging(std::span<const OperationNumber> numbers) {
  return {WrittenCommand{"mesh.merge_distance", {written("distance", numbers[0].value)}}};
}

void merge_near(Editor& editor, std::optional<double> distance = {}) {
  const double size = size_of(*editor.active_object()->polyhedron());
  OperationStep step;
  step.label = translatable("Merge by distance");
  step.numbers = {
      {"distance", translatable("Distance"), distance.value_or(weld_share * size), 0, size, false}};
  step.make = merging_near(editor);
  step.begin = [](const Editor& now) -> Result<BegunOperation> {
    if (const Reason reason = needs_elements(now, {.vertices = true, .edges = true, .faces = true})())
      return make_error(e_wrong_selection, *reason);
    return BegunOperation{merging_near(now), {}, written_merging};
  };
  step.written = written_merging;
  editor.last_operation.run(editor, std::move(step));
}

Result<EditResult> bridged(const PolyhedronSource& source, const ElementSet& set) {
  if (set.faces.size() == 2) return bridge_faces(source, *set.faces.begin(), *set.faces.rbegin());
  if (!set.faces.empty())
    return make_error(e_wrong_selection, "A bridge needs two faces, or the edges of two borders.",
                      "Select two faces.");
  return bridge_borders(source, list_of(to_edges(source.polyhedron, set).edges));
}

/// All faces of an object, for commands that work on the selection or else on everything.
std::vector<FaceId> faces_or_all(const PolyhedronSource& source, const ElementSet& set) {
  if (!set.faces.empty()) return list_of(set.faces);
  return list_of(select_all(source.polyhedron, ElementKind::face).faces);
}

void toggle_mirror(Editor& editor, Axis axis) {
  const PolyhedronSource& source = *editor.active_object()->polyhedron();
  const ObjectId object = editor.selection.active;
  if (source.mirror && source.mirror->axis == axis) {
    editor.commit(set_mirror(editor.history.current(), object, std::nullopt),
                  translatable("End live mirror"));
    return;
  }
  // Faces behind the plane go, so that the image takes their place. Another mirror's image stays.
  const Mirror mirror{axis, weld_share * size_of(source)};
  std::optional<Message> lost;
  const auto half =
      edit_polyhedron(editor.history.current(), object, [&](const PolyhedronSource& s) -> Result<EditResult> {
        const auto whole = baked(s);
        if (!whole) return whole.error();
        const FormToKeep kept = form_for_refinement(editor, *whole);
        lost = kept.lost;
        return halved(*whole, mirror, kept.pointer());
      });
  if (!half) return editor.notify(half.error());
  if (editor.commit(set_mirror(half->document, object, mirror), translatable("Live mirror")))
    say_form_lost(editor, lost);
}

/// Runs one operation on the active polyhedron and what is selected of it, as a step called `label`.
template <class Operate>
std::function<void()> operation(Editor& editor, const char* label, Operate operate) {
  return [&editor, label, operate] {
    const ElementSet set = editor.selection.of_active();
    run_operation(
        editor, [&](const PolyhedronSource& source) { return operate(source, set); }, label);
  };
}

/// One row of the table; what all of these commands have in common is left out.
class MeshMenu {
 public:
  explicit MeshMenu(CommandHost& host) : host_(host), editor_(host.editor) {}

  void next_group() { separator_ = true; }

  void add(const char* id, const char* label, const char* help, const char* keys, NeededElements needed,
           Context contexts, std::function<void()> run) {
    add(id, "Mesh", label, help, keys, needs_elements(editor_, needed), contexts, std::move(run));
  }
  void add(const char* id, const std::string& menu, const char* label, const char* help, const char* keys,
           WhyNot why_not, Context contexts, std::function<void()> run, std::function<bool()> checked = {}) {
    MenuRows(host_.table, menu)
        .add_edit(id, label, help, std::move(run), std::move(why_not),
                  {.keys = keys,
                   .separator_before = std::exchange(separator_, false),
                   .checked = std::move(checked),
                   .contexts = contexts});
  }
  /// A command that is one operation on the active polyhedron and what is selected of it.
  template <class Operate>
  void add_operation(const char* id, const char* label, const char* help, const char* keys,
                     NeededElements needed, Context contexts, Operate operate) {
    add(id, label, help, keys, needed, contexts, operation(editor_, label, std::move(operate)));
  }

 private:
  CommandHost& host_;
  Editor& editor_;
  bool separator_ = true;
};

void add_merging(MeshMenu& menu, Editor& editor) {
  const auto merge = [&](const char* id, const char* label, const char* help, const char* keys, MergeAt at) {
    menu.add(id, merge_menu, label, help, keys,
             only_if(
                 needs_elements(editor, {.vertices = true}),
                 [&editor, at] { return at == MergeAt::centre || clicked_vertex(editor, at); },
                 translatable("Which vertex came first or last is not known. Click them one by one.")),
             Context::vertex, [&editor, at, label] { merge_at(editor, at, label); });
  };
  merge("mesh.merge_centre", "Merge at centre", "Make one vertex of the selected ones, between them.", "M",
        MergeAt::centre);
  merge("mesh.merge_first", "Merge at first", "Make one vertex of the selected ones, where the first one is.",
        "", MergeAt::first);
  merge("mesh.merge_last", "Merge at last", "Make one vertex of the selected ones, where the last one is.",
        "Alt+M", MergeAt::last);
  menu.add("mesh.merge_distance", merge_menu, "Merge by distance",
           "Merge selected vertices that are near each other.", "",
           needs_elements(editor, {.vertices = true, .edges = true, .faces = true}), any_element,
           [&editor] { merge_near(editor); });
  menu.add("mesh.collapse", merge_menu, "Collapse edges", "Shrink the selected edges to points.", "",
           needs_elements(editor, {.edges = true}), Context::edge,
           operation(editor, "Collapse edges", [](const PolyhedronSource& source, const ElementSet& set) {
             return collapse_edges(source, list_of(set.edges));
           }));
}

WhyNot needs_deletable(const Editor& editor) {
  return [&editor, object = needs_object(editor)]() -> Reason {
    return editor.dimensions.chosen(editor) ? Reason() : object();
  };
}

void add_tidying(MeshMenu& menu, Editor& editor) {
  menu.add("mesh.delete", "Edit", "Delete",
           "Delete the selected elements, or the object when none are selected.", "Del",
           needs_deletable(editor), any_element | Context::object, [&editor] { delete_selection(editor); });
  menu.next_group();
  menu.add_operation("mesh.dissolve", "Dissolve", "Take the selected elements away without leaving a hole.",
                     "Ctrl+Del", {.vertices = true, .edges = true, .faces = true}, any_element,
                     [&editor](const PolyhedronSource& source, const ElementSet& set) {
                       return dissolved(source, set, kind_at_hand(editor));
                     });
  menu.add_operation("mesh.triangulate", "Triangulate", "Cut the selected faces into triangles.", "Ctrl+T",
                     {.faces = true}, Context::face,
                     [](const PolyhedronSource& source, const ElementSet& set) {
                       return triangulate_faces(source, list_of(set.faces));
                     });
  menu.add(
      "mesh.decompose", "Mesh", "Decompose concave faces",
      "Cut concave faces into convex ones, of the selection or of the whole object.", "",
      needs_polyhedron(editor), Context::face,
      operation(editor, "Decompose concave faces", [](const PolyhedronSource& source, const ElementSet& set) {
        return decompose_concave_faces(source, faces_or_all(source, set));
      }));
  menu.next_group();
  add_merging(menu, editor);
}

void add_connecting(MeshMenu& menu, Editor& editor) {
  menu.next_group();
  menu.add_operation(
      "mesh.bridge", "Bridge", "Connect two faces, or two borders, by a strip of faces.", "Ctrl+Shift+E",
      {.edges = true, .faces = true}, Context::edge | Context::face,
      [](const PolyhedronSource& source, const ElementSet& set) { return bridged(source, set); });
  menu.add_operation("mesh.fill_hole", "Fill hole", "Close the hole that a selected edge lies on by a face.",
                     "Shift+F", {.vertices = true, .edges = true}, Context::edge,
                     [](const PolyhedronSource& source, const ElementSet& set) {
                       return fill_holes(source, list_of(to_edges(source.polyhedron, set).edges));
                     });
  menu.add("mesh.flip", "Mesh", "Flip", "Turn the selected parts, or the whole object, inside out.", "",
           needs_polyhedron(editor), Context::face,
           operation(editor, "Flip", [](const PolyhedronSource& source, const ElementSet& set) {
             return flip_faces(source, faces_or_all(source, set));
           }));
  menu.next_group();
  menu.add_operation("mesh.duplicate_faces", "Duplicate faces",
                     "Copy the selected faces as a part of their own.", "Ctrl+Shift+D", {.faces = true},
                     Context::face, [](const PolyhedronSource& source, const ElementSet& set) {
                       return duplicate_faces(source, list_of(set.faces));
                     });
  menu.add_operation("mesh.separate", "Separate faces", "Cut the selected faces loose from their neighbours.",
                     "", {.faces = true}, Context::face,
                     [](const PolyhedronSource& source, const ElementSet& set) {
                       return separate_faces(source, list_of(set.faces));
                     });
  menu.add("mesh.detach", "Detach faces", "Move the selected faces to an object of their own.", "P",
           {.faces = true}, Context::face, [&editor] {
             const auto done = detach_faces(editor.history.current(), editor.selection.active,
                                            list_of(editor.selection.of_active().faces));
             if (!done) return editor.notify(done.error());
             if (!editor.commit(Result<Document>(done->document), translatable("Detach faces"))) return;
             editor.selection.clear_elements();
             editor.selection.active = done->object;
           });
  menu.add("mesh.join", "Mesh", "Join objects", "Make one object of those that are chosen.", "Ctrl+J",
           only_if(
               needs_polyhedron(editor), [&editor] { return selected_objects(editor).size() > 1; },
               translatable("Choose two or more objects. Press 4 and click them with Shift.")),
           Context::object, [&editor] {
             editor.commit(join_objects(editor.history.current(), active_and_selected(editor)),
                           translatable("Join objects"));
           });
}

void add_mirrors(MeshMenu& menu, Editor& editor) {
  menu.next_group();
  const auto live = [&](const char* id, const char* label, Axis axis) {
    menu.add(
        id, mirror_menu, label, "Model one half; its image completes the object at once.", "",
        needs_polyhedron(editor), Context::none, [&editor, axis] { toggle_mirror(editor, axis); },
        [&editor, axis] {
          const Object* object = editor.active_object();
          const PolyhedronSource* source = object ? object->polyhedron() : nullptr;
          return source && source->mirror && source->mirror->axis == axis;
        });
  };
  live("mirror.live_x", "Live mirror X", Axis::x);
  live("mirror.live_y", "Live mirror Y", Axis::y);
  live("mirror.live_z", "Live mirror Z", Axis::z);
  menu.add("mirror.apply", mirror_menu, "Apply live mirror", "Make both halves the object's own.", "",
           only_if(
               needs_polyhedron(editor),
               [&editor] { return editor.active_object()->polyhedron()->mirror.has_value(); },
               translatable("The object has no live mirror.")),
           Context::none,
           [&editor] { run_operation(editor, apply_mirror, translatable("Apply live mirror")); });
  menu.next_group();
  const auto flip = [&](const char* id, const char* label, Axis axis) {
    menu.add(id, mirror_menu, label, "Turn the object into its mirror image.", "", needs_polyhedron(editor),
             Context::none,
             operation(editor, label, [axis](const PolyhedronSource& source, const ElementSet&) {
               return mirror_object(source, axis);
             }));
  };
  flip("mirror.object_x", "Mirror object X", Axis::x);
  flip("mirror.object_y", "Mirror object Y", Axis::y);
  flip("mirror.object_z", "Mirror object Z", Axis::z);
}

}  // namespace

void add_mesh_cleanup_commands(CommandHost& host) {
  MeshMenu menu(host);
  add_tidying(menu, host.editor);
  add_connecting(menu, host.editor);
  add_mirrors(menu, host.editor);
  host.table.use_in_scripts("mesh.merge_distance",
                            {.arguments = {length_argument("distance", translatable("Distance"), {}, 0)},
                             .run = [&editor = host.editor](const Arguments& given) {
                               merge_near(editor, given.number("distance"));
                             }});
}

}  // namespace hariko
