// Commands of what drawings and drags snap to, and of the plane in which they draw.

#include <Eigen/Geometry>
#include <optional>
#include <utility>

#include "ui/editor/command_host.hpp"
#include "ui/view/viewport.hpp"

namespace hariko {

namespace {

const std::string snap_folder = submenu("Transform", translatable("Snapping"));
const std::string plane_folder = submenu("View", translatable("Working plane"));

/// The camera that looks at a plane from the tip of its normal, with its y axis up.
Camera plan_of(Camera camera, const PlaneFrame& plane) {
  camera.orientation = Eigen::Quaterniond(plane.axes).normalized();
  camera.target = plane.foot(camera.target);
  return camera;
}

using FindPlane = std::optional<WorkingPlane> (*)(const Editor&);

void add_plane_row(CommandHost& host, const char* id, const char* label, const char* help,
                   WorkingPlane::Kind kind, std::function<void()> run, WhyNot why_not) {
  MenuRows(host.table, plane_folder)
      .add(id, label, help, std::move(run), std::move(why_not),
           {.checked = [&editor = host.editor, kind] { return editor.working_plane.kind == kind; }});
}

/// A row that takes the plane from what is selected; `otherwise` says what has to be.
void add_selected_plane(CommandHost& host, const char* id, const char* label, const char* help,
                        WorkingPlane::Kind kind, FindPlane find, const char* otherwise) {
  Editor& editor = host.editor;
  const auto take = [&editor, find] {
    if (const auto plane = find(editor)) editor.working_plane = *plane;
  };
  add_plane_row(host, id, label, help, kind, take,
                only_if(
                    needs_document(editor), [&editor, find] { return find(editor).has_value(); }, otherwise));
}

}  // namespace

void add_snap_commands(CommandHost& host) {
  SnapSettings& snaps = host.editor.settings.snaps;
  MenuRows rows(host.table, snap_folder, true);
  rows.add_switch("snap.vertices", "Snap: vertices",
                  "Catch vertices of polyhedra and patches, and points of sections, paths and outlines.",
                  snaps.vertices);
  rows.add_switch("snap.midpoints", "Snap: middles",
                  "Catch middles of edges, on their curves or on straight lines, as they are shown.",
                  snaps.midpoints);
  rows.add_switch("snap.centres", "Snap: centres",
                  "Catch centres of faces, of closed sections and outlines, and of solids.", snaps.centres);
  rows.add_switch("snap.intersections", "Snap: intersections",
                  "Catch places where curves cross in the view, on the one in front.", snaps.crossings);
  rows.add_switch("snap.perpendicular", "Snap: perpendicular",
                  "Catch the point of a curve that the gesture reaches at right angles from where it began.",
                  snaps.perpendicular);
  rows.add_switch(
      "snap.tangent", "Snap: tangent",
      "Catch the point of a curve that a line from where the gesture began touches, seen across the working "
      "plane.",
      snaps.tangent);
  rows.add_switch("snap.curves", "Snap: curves", "Catch the nearest point of a curve.", snaps.curves);
  rows.add_switch("snap.surfaces", "Snap: surfaces", "Catch the point of a surface under the pointer.",
                  snaps.surfaces);
  rows.add_switch("snap.grid", "Snap: grid",
                  "Go by the steps of the working plane's grid where nothing else is caught.", snaps.grid);
  rows.next_group();
  rows.add_switch("snap.always", "Snap without Ctrl",
                  "Drawings and drags snap all the time; Ctrl then lets go.", snaps.always, {.keys = "F9"});
}

void add_plane_commands(CommandHost& host) {
  Editor& editor = host.editor;
  using Kind = WorkingPlane::Kind;
  const WhyNot document = needs_document(editor);
  add_plane_row(
      host, "plane.ground", "Plane: ground", "Draw and place on the ground again.", Kind::ground,
      [&editor] { editor.working_plane = {}; }, document);
  add_plane_row(
      host, "plane.view", "Plane: view",
      "Draw in the plane that faces you, through what is selected or the middle of the view.", Kind::view,
      [&editor] { editor.working_plane = plane_of_view(editor); }, document);
  add_selected_plane(host, "plane.face", "Plane: face",
                     "Draw in the plane of the selected face; its centre is zero.", Kind::face,
                     plane_of_selected_face,
                     translatable("Select one face of a polyhedron or of a net of patches."));
  add_selected_plane(
      host, "plane.points", "Plane: three points",
      "Draw in the plane of three selected points: zero, a point of the x axis, a point aside.", Kind::points,
      plane_of_selected_points, translatable("Select three points that do not lie in a line."));
  add_selected_plane(host, "plane.section", "Plane: section",
                     "Draw in the plane of the section of which points are selected.", Kind::section,
                     plane_of_selected_section, translatable("Select points of one section of a skin."));
  MenuRows(host.table, plane_folder)
      .add("plane.look", "Look at the plane",
           "Turn the view so that the working plane faces you, with its y axis up.",
           [&editor] { editor.fly_to(plan_of(editor.camera(), editor.working_plane.frame)); }, document,
           {.separator_before = true, .while_tool_runs = true});
}

}  // namespace hariko
