#include "ui/shell/property_tables.hpp"

#include <array>
#include <variant>
#include <vector>

#include "render/color_map.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/object_size.hpp"
#include "ui/editor/paper_edits.hpp"
#include "ui/editor/view_map.hpp"
#include "ui/outline/outline_rows.hpp"
#include "ui/pictures/picture_rows.hpp"
#include "ui/polyhedron/polyhedron_rows.hpp"
#include "ui/skin/skin_properties.hpp"
#include "ui/solids/solids_properties.hpp"

namespace hariko {

namespace {

const Object& active_of(const Editor& editor) {
  return *editor.active_object();
}

bool row_always_there(const Editor&) {
  return true;
}
bool row_of_stretching(const Editor& editor) {
  return stretches(active_of(editor));
}

/// The outermost array of live copies is of this kind.
template <class Array>
bool row_of_copies(const Editor& editor) {
  const LiveCopies& copies = *active_of(editor).copies;
  return !copies.empty() && std::holds_alternative<Array>(copies.back());
}
bool row_of_counted_copies(const Editor& editor) {
  return row_of_copies<RowOfCopies>(editor) || row_of_copies<RingOfCopies>(editor);
}

// The display of what is no picture.

bool row_of_display(const Editor& editor) {
  return !object_kind(active_of(editor)).is_backdrop();
}
template <SurfaceMap... maps>
bool row_of_maps(const Editor& editor) {
  const SurfaceMap shown = shown_map(editor.view.map, active_of(editor));
  return row_of_display(editor) && ((shown == maps) || ...);
}
bool row_of_range(const Editor& editor) {
  return row_of_display(editor) && has_values(active_of(editor).display.map);
}
bool row_of_typed_range(const Editor& editor) {
  const DisplaySettings& display = active_of(editor).display;
  return row_of_range(editor) && range_of(display, display.map).mode == RangeMode::manual;
}
bool row_of_combs(const Editor& editor) {
  return active_of(editor).has_surface() && active_of(editor).display.combs.shown;
}
bool row_of_tolerance(const Editor& editor) {
  return active_of(editor).has_surface() && active_of(editor).display.marks;
}
bool row_of_environment(const Editor& editor) {
  return editor.view.environment && row_of_maps<SurfaceMap::shaded>(editor);
}
bool row_of_section_plane(const Editor& editor) {
  return row_of_display(editor) && editor.view.section.shown;
}
bool row_of_x_ray(const Editor& editor) {
  return row_of_display(editor) && editor.view.x_ray;
}
bool row_of_section_lines(const Editor& editor) {
  return row_of_display(editor) && editor.sections.shown;
}
bool row_of_section_spacing(const Editor& editor) {
  return row_of_section_lines(editor) && editor.sections.planes.count > 1;
}

// The rows.

constexpr const char* no_copies =
    translatable("The active object has no live copies of this kind. Make some: Edit > Array and align.");
constexpr const char* other_map =
    translatable("The surface does not show a map to which this belongs. Choose one in the menu Analyse.");
constexpr const char* no_combs =
    translatable("No curvature combs are shown. Choose Curvature combs in the menu Analyse first.");
constexpr const char* no_marks =
    translatable("No continuity is marked. Choose Edge continuity in the menu Analyse first.");
constexpr const char* no_environment =
    translatable("No environment is shown. Choose Environment in the menu Analyse first.");
constexpr const char* no_section_plane =
    translatable("There is no section plane. Choose Section plane first.");
constexpr const char* no_x_ray = translatable("X-ray is off. Choose X-ray in the menu View first.");
constexpr const char* no_section_lines =
    translatable("No section curves are shown. Choose Section curves in the menu Analyse first.");

constexpr std::array object_rows{
    PanelRow{"size.x", "Size", "Of the surface, along the object's own axes", "", row_always_there},
    PanelRow{"proportional", "Proportional", "A typed size scales the object along all its axes", "",
             row_of_stretching},
    PanelRow{"location.x", "Location", "Where the object's own zero stands in the document", "",
             row_always_there},
    PanelRow{"rotation.x", "Rotation", "About the x axis first, then y, then z", "", row_always_there},
    PanelRow{"scale", "Scale", "The same along all axes: surfaces keep their shape", "", row_always_there},
    PanelRow{"copies_count", "Total count", "How many places the array has, the object's own included",
             "Live copies", row_of_counted_copies, no_copies},
    PanelRow{"copies_step.x", "Step", "From place to place, along the object's own axes", "Live copies",
             row_of_copies<RowOfCopies>, no_copies},
    PanelRow{"copies_angle", "Angle",
             "From the first place to the last; a full turn spaces them evenly round", "Live copies",
             row_of_copies<RingOfCopies>, no_copies},
    PanelRow{"copies_plane", "Distance", "From the object's own zero to the plane of its mirror image",
             "Live copies", row_of_copies<MirrorOfCopies>, no_copies},
};

constexpr std::array display_rows{
    PanelRow{"colour", "Colour", "Of the outside; the inside stays blue", "Display",
             row_of_maps<SurfaceMap::shaded, SurfaceMap::isophotes>, other_map},
    PanelRow{"range", "Range", "Which values the colours span; kept for each map", "Display", row_of_range,
             other_map},
    PanelRow{"range_low", "From, to", "Ends of the range, in the map's unit", "Display", row_of_typed_range,
             other_map},
    PanelRow{"comb_density", "Teeth", "Intervals on each curve", "Display", row_of_combs, no_combs},
    PanelRow{"tolerance", "Tolerance",
             "Largest angle between normals, and largest jump of curvature relative to it", "Display",
             row_of_tolerance, no_marks},
    PanelRow{"stripes", "Stripes", "Number of dark stripes", "Display",
             row_of_maps<SurfaceMap::zebra, SurfaceMap::isophotes>, other_map},
    PanelRow{"lock", "Locked to", "What the stripes stand still with", "Display",
             row_of_maps<SurfaceMap::zebra, SurfaceMap::isophotes>, other_map},
    PanelRow{"stripes_direction", "Direction", "Drag the dot over the ball", "Display",
             row_of_maps<SurfaceMap::zebra, SurfaceMap::isophotes>, other_map},
    PanelRow{"environment", "Environment", "What shaded surfaces reflect", "Display", row_of_environment,
             no_environment},
    PanelRow{"environment_turn", "Turn",
             "Turns the environment about z: drag, and highlights run over the surface", "Display",
             row_of_environment, no_environment},
    PanelRow{"environment_exposure", "Exposure", "Stops: each doubles the light of the environment",
             "Display", row_of_environment, no_environment},
    PanelRow{"pull", "Pull", "Direction in which the part leaves its mould", "Display",
             row_of_maps<SurfaceMap::draft>, other_map},
    PanelRow{"draft_limit", "Least draft", "Walls with less than this angle to the pull are marked",
             "Display", row_of_maps<SurfaceMap::draft>, other_map},
    PanelRow{"radius_limit", "Least radius", "What is bent more tightly, no tool of this radius can make",
             "Display", row_of_maps<SurfaceMap::radius>, other_map},
    PanelRow{"thickness_limit", "Least wall", "Walls that are thinner than this are marked", "Display",
             row_of_maps<SurfaceMap::thickness>, other_map},
    PanelRow{"reference", "Reference", "The object that the others deviate from", "Display",
             row_of_maps<SurfaceMap::deviation>, other_map},
    PanelRow{"section_axis", "Across", "The axis that the plane is square to", "Display",
             row_of_section_plane, no_section_plane},
    PanelRow{"section_offset", "Offset", "Of the plane along its axis", "Display", row_of_section_plane,
             no_section_plane},
    PanelRow{"x_ray", "X-ray", "Strength of what lies behind the surface", "Display", row_of_x_ray, no_x_ray},
    PanelRow{"section_across", "Across", "The direction that the planes are square to", "Display",
             row_of_section_lines, no_section_lines},
    PanelRow{"section_count", "Planes", "Number of section planes", "Display", row_of_section_lines,
             no_section_lines},
    PanelRow{"section_first", "First at", "Place of the first plane along the direction", "Display",
             row_of_section_lines, no_section_lines},
    PanelRow{"section_spacing", "Spacing", "From plane to plane", "Display", row_of_section_spacing,
             no_section_lines},
};

}  // namespace

std::vector<PanelRow> panel_rows() {
  std::vector<PanelRow> out;
  const auto take = [&](const auto& rows) { out.insert(out.end(), rows.begin(), rows.end()); };
  take(object_rows);
  take(polyhedron_panel_rows());
  take(skin_panel_rows());
  take(outline_panel_rows());
  take(picture_panel_rows());
  take(solid_panel_rows());
  take(display_rows);
  take(panel_rows_of_document());
  return out;
}

// Rows of panels about what belongs to no object: the triangles, the paper model and the document.

namespace {

bool row_of_document(const Editor&) {
  return true;
}
bool row_of_triangles(const Editor& editor) {
  return editor.meshing.open && meshed_object(editor.document(), editor.selection.active);
}
bool row_of_paper(const Editor& editor) {
  return editor.paper.shown;
}
bool row_of_paper_size(const Editor& editor) {
  return editor.paper.shown && !paper_choices_of(editor.document()).objects.empty();
}
bool row_of_paper_facets(const Editor& editor) {
  return editor.paper.shown && !paper_choices_of(editor.document()).of_polyhedra;
}
bool row_of_paper_count(const Editor& editor) {
  return row_of_paper_facets(editor) && editor.paper.mesh && editor.paper.mesh->whole->mesh.face_count() > 0;
}

constexpr const char* no_triangles =
    translatable("The triangles are not shown. Choose Triangles in the menu Analyse first.");
constexpr const char* no_paper_facets =
    translatable("No surface is cut into facets. Show the paper view, and choose Surfaces for Facets.");
constexpr const char* no_paper =
    translatable("The paper view is not shown. Choose Paper view in the menu Paper first.");

constexpr PanelRow of_triangles(const char* id, const char* label, const char* help) {
  return {id, label, help, "Triangles", row_of_triangles, no_triangles, false};
}
constexpr PanelRow of_paper(const char* id, const char* label, const char* help,
                            bool (*there)(const Editor&) = row_of_paper, const char* otherwise = no_paper) {
  return {id, label, help, "Paper model", there, otherwise, false};
}

constexpr std::array triangle_rows{
    of_triangles("meshing.distance", "Distance", "The farthest that the surface may be from its triangles"),
    of_triangles("meshing.normal", "Normal angle",
                 "The largest angle between the normals of the surface and of its triangles"),
    of_triangles("meshing.fold", "Fold angle",
                 "The largest angle between neighbouring triangles, creases apart"),
    of_triangles("meshing.luminance", "Brightness",
                 "The largest difference of brightness; it does not bound the shape, so combine it"),
    of_triangles("meshing.edge", "Longest edge", "No edge is longer"),
    of_triangles("meshing.angle", "Smallest angle", "Triangles that are too sharp are cut where that helps"),
    of_triangles("meshing.start", "Start", "What is cut: for patches with four sides"),
    of_triangles("meshing.split", "Cut", "Which edge is cut, and where"),
    of_triangles("meshing.optimise", "Fewest",
                 "Looks for the smallest mesh within the tolerance. Takes many times longer."),
    of_triangles("meshing.balanced", "Balanced",
                 "Vertices may leave the surface where it is bent one way only: fewer still"),
};

constexpr std::array document_rows{
    PanelRow{"unit", "Unit", "The unit of all lengths of the document", "Document", row_of_document, "",
             false},
    of_paper("paper_width", "Width", "Of the finished model", row_of_paper_size),
    of_paper("paper_depth", "Depth", "Of the finished model", row_of_paper_size),
    of_paper("paper_height", "Height", "Of the finished model", row_of_paper_size),
    of_paper("paper_facets", "Facets", "What is cut and folded"),
    of_paper("paper_count", "How many",
             "Facets of the paper model: fewer are quicker to build, more are nearer to the surface",
             row_of_paper_count, no_paper_facets),
    of_paper("paper_distance", "Tolerance", "The farthest that the paper may be from the surface",
             row_of_paper_facets, no_paper_facets),
    of_paper("paper_page", "Page", "The paper that is printed on"),
    of_paper("page_width", "Page width", "The paper that is printed on"),
    of_paper("page_height", "Page height", "The paper that is printed on"),
    of_paper("paper_margin", "Margin", "Free of pieces, round each page"),
    of_paper("paper_tab", "Tabs", "Height of glue tabs where there is room"),
    of_paper("paper_least_tab", "Least tab",
             "Where there is no room for a tab of this height there is a strip"),
    of_paper("paper_strip", "Strips", "Width of joint strips, where a slit has no room for tabs"),
    of_paper("paper_gap", "Gap", "Between the pieces on a page"),
    of_paper("paper_goal", "Aim at", "What matters most when cuts are looked for"),
    of_paper("paper_steps", "Effort",
             "Steps of the search for cuts: more may find fewer pieces, and take longer"),
    of_paper("paper_flat", "Flat below", "Folds of a smaller angle have no line"),
    of_paper("paper_merge", "Merge below",
             "Facets whose fold is smaller become one polygon, which is never cut. 0: none"),
    of_paper("paper_side", "Print on the", "Which side of the paper is printed"),
    of_paper("paper_angles", "Fold angles", "Write the angle beside each fold, in degrees"),
};

}  // namespace

std::vector<PanelRow> panel_rows_of_document() {
  std::vector<PanelRow> out(triangle_rows.begin(), triangle_rows.end());
  out.insert(out.end(), document_rows.begin(), document_rows.end());
  return out;
}

}  // namespace hariko
