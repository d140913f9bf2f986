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

void add_plane_row(CommandHost& host, Command row, WorkingPlane::Kind kind) {
  Editor& editor = host.editor;
  row.menu = plane_folder;
  row.checked = [&editor, kind] { return editor.working_plane.kind == kind; };
  host.table.add(std::move(row));
}

/// A row that takes the plane from what is selected; `otherwise` says what has to be.
void add_selected_plane(CommandHost& host, Command row, WorkingPlane::Kind kind, FindPlane find,
                        const char* otherwise) {
  Editor& editor = host.editor;
  row.run = [&editor, find] {
    if (const auto plane = find(editor)) editor.working_plane = *plane;
  };
  row.why_not = only_if(
      needs_document(editor), [&editor, find] { return find(editor).has_value(); }, otherwise);
  add_plane_row(host, std::move(row), kind);
}

}  // namespace

void add_snap_commands(CommandHost& host) {
  SnapSettings& snaps = host.editor.settings.snaps;
  const auto add = [&](const char* id, const char* label, const char* help, bool& on) {
    host.table.add(switching(
        {.id = id, .menu = snap_folder, .label = label, .help = help, .while_tool_runs = true}, on));
  };
  add("snap.vertices", "Snap: vertices",
      "Catch vertices of polyhedra and patches, and points of sections, paths and outlines.", snaps.vertices);
  add("snap.midpoints", "Snap: middles",
      "Catch middles of edges, on their curves or on straight lines, as they are shown.", snaps.midpoints);
  add("snap.centres", "Snap: centres",
      "Catch centres of faces, of closed sections and outlines, and of solids.", snaps.centres);
  add("snap.intersections", "Snap: intersections",
      "Catch places where curves cross in the view, on the one in front.", snaps.crossings);
  add("snap.perpendicular", "Snap: perpendicular",
      "Catch the point of a curve that the gesture reaches at right angles from where it began.",
      snaps.perpendicular);
  add("snap.tangent", "Snap: tangent",
      "Catch the point of a curve that a line from where the gesture began touches, seen across the working "
      "plane.",
      snaps.tangent);
  add("snap.curves", "Snap: curves", "Catch the nearest point of a curve.", snaps.curves);
  add("snap.surfaces", "Snap: surfaces", "Catch the point of a surface under the pointer.", snaps.surfaces);
  add("snap.grid", "Snap: grid", "Go by the steps of the working plane's grid where nothing else is caught.",
      snaps.grid);
  host.table.add(switching({.id = "snap.always",
                            .menu = snap_folder,
                            .label = "Snap without Ctrl",
                            .help = "Drawings and drags snap all the time; Ctrl then lets go.",
                            .keys = "F9",
                            .separator_before = true,
                            .while_tool_runs = true},
                           snaps.always));
}

void add_plane_commands(CommandHost& host) {
  Editor& editor = host.editor;
  using Kind = WorkingPlane::Kind;
  const WhyNot document = needs_document(editor);
  add_plane_row(host,
                {.id = "plane.ground",
                 .label = "Plane: ground",
                 .help = "Draw and place on the ground again.",
                 .run = [&editor] { editor.working_plane = {}; },
                 .why_not = document},
                Kind::ground);
  add_plane_row(
      host,
      {.id = "plane.view",
       .label = "Plane: view",
       .help = "Draw in the plane that faces you, through what is selected or the middle of the view.",
       .run = [&editor] { editor.working_plane = plane_of_view(editor); },
       .why_not = document},
      Kind::view);
  add_selected_plane(host,
                     {.id = "plane.face",
                      .label = "Plane: face",
                      .help = "Draw in the plane of the selected face; its centre is zero."},
                     Kind::face, plane_of_selected_face,
                     translatable("Select one face of a polyhedron or of a net of patches."));
  add_selected_plane(
      host,
      {.id = "plane.points",
       .label = "Plane: three points",
       .help = "Draw in the plane of three selected points: zero, a point of the x axis, a point aside."},
      Kind::points, plane_of_selected_points, translatable("Select three points that do not lie in a line."));
  add_selected_plane(host,
                     {.id = "plane.section",
                      .label = "Plane: section",
                      .help = "Draw in the plane of the section of which points are selected."},
                     Kind::section, plane_of_selected_section,
                     translatable("Select points of one section of a skin."));
  host.table.add({.id = "plane.look",
                  .menu = plane_folder,
                  .label = "Look at the plane",
                  .help = "Turn the view so that the working plane faces you, with its y axis up.",
                  .separator_before = true,
                  .while_tool_runs = true,
                  .run = [&editor] { editor.fly_to(plan_of(editor.camera(), editor.working_plane.frame)); },
                  .why_not = document});
}

}  // namespace hariko
