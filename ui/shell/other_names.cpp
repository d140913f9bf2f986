// Other names of commands, by which the palette finds them, too: what they are called elsewhere. A name
// stands here only where the program has the thing itself.

#include <array>

#include "ui/shell/shell_commands.hpp"

namespace hariko {

namespace {

struct OtherNames {
  const char *id, *names;  ///< between commas
};

constexpr std::array other_names_of_commands{
    OtherNames{"file.import", "insert, merge file"},
    OtherNames{"file.export", "3D print, STL, OBJ, shell, thicken"},
    OtherNames{"file.export_cad", "NURBS, B-rep, shell, thicken"},
    OtherNames{"file.export_picture", "screenshot, render, image"},
    OtherNames{"file.revert", "reload, discard changes"},
    OtherNames{"file.quit", "exit, leave"},
    OtherNames{"edit.preferences", "settings, options"},
    OtherNames{"edit.record_script", "macro, action recorder"},
    OtherNames{"help.keys", "shortcuts, hotkeys"},
    OtherNames{"object.show_all", "unhide, reveal"},
    OtherNames{"object.isolate", "solo, local view"},
    OtherNames{"object.lock", "freeze, unlock"},
    OtherNames{"object.duplicate", "clone, copy"},
    OtherNames{"object.delete", "erase, remove"},
    OtherNames{"object.array_row", "linear array, pattern"},
    OtherNames{"object.array_ring", "polar array, circular array, radial array"},
    OtherNames{"object.array_curve", "path array, array on path"},
    OtherNames{"object.copies_to_objects", "explode, apply array, instances"},
    OtherNames{"select.none", "deselect, clear selection"},
    OtherNames{"select.box", "marquee, rectangle"},
    OtherNames{"select.linked", "connected, island"},
    OtherNames{"add.outline", "surface from curve, fill curve"},
    OtherNames{"add.patches", "NURBS surface, Bezier surface"},
    OtherNames{"add.skin", "loft, sweep"},
    OtherNames{"skin.draw", "loft, sweep"},
    OtherNames{"skin.add_section", "profile, cross section"},
    OtherNames{"skin.to_polyhedron", "make editable, bake"},
    OtherNames{"solid.to_polyhedron", "make editable, bake"},
    OtherNames{"outline.convert", "make editable, bake"},
    OtherNames{"transform.move", "translate, grab"},
    OtherNames{"transform.scale", "resize, stretch"},
    OtherNames{"transform.gizmo", "gumball, manipulator"},
    OtherNames{"transform.soft", "proportional editing, magnet"},
    OtherNames{"snap.always", "object snap, osnap"},
    OtherNames{"plane.ground", "construction plane, cplane"},
    OtherNames{"plane.view", "construction plane, cplane"},
    OtherNames{"plane.face", "construction plane, cplane"},
    OtherNames{"plane.points", "construction plane, cplane"},
    OtherNames{"mesh.extrude", "push pull, pull out"},
    OtherNames{"mesh.inset", "offset inwards, inner face"},
    OtherNames{"mesh.bevel_edges", "fillet, chamfer"},
    OtherNames{"mesh.bevel_vertices", "chamfer corner, truncate"},
    OtherNames{"mesh.loop_cut", "insert edge loop, add loop"},
    OtherNames{"mesh.knife", "cut, slice"},
    OtherNames{"mesh.connect", "add edge, split face"},
    OtherNames{"mesh.subdivide", "split faces, refine"},
    OtherNames{"mesh.merge_distance", "weld, remove doubles"},
    OtherNames{"mesh.merge_centre", "weld, join vertices"},
    OtherNames{"mesh.merge_first", "weld, join vertices"},
    OtherNames{"mesh.merge_last", "weld, join vertices"},
    OtherNames{"mesh.delete", "erase, remove"},
    OtherNames{"mesh.fill_hole", "cap, close hole"},
    OtherNames{"mesh.flip", "flip normals, reverse"},
    OtherNames{"mesh.separate", "unweld, rip"},
    OtherNames{"mesh.detach", "separate selection, extract"},
    OtherNames{"mesh.join", "combine, merge objects"},
    OtherNames{"mesh.project_reference", "shrinkwrap, conform"},
    OtherNames{"mesh.fit_reference", "wrap, reverse engineering"},
    OtherNames{"mesh.reduce_reference", "decimate, simplify"},
    OtherNames{"mirror.live_x", "symmetry, mirror modifier"},
    OtherNames{"mirror.live_y", "symmetry, mirror modifier"},
    OtherNames{"mirror.live_z", "symmetry, mirror modifier"},
    OtherNames{"shape.crease", "sharp edge, hard edge"},
    OtherNames{"shape.weld_patches", "join surfaces, stitch"},
    OtherNames{"shape.separate_patches", "explode, unjoin"},
    OtherNames{"paper.unfold", "unroll, papercraft"},
    OtherNames{"picture.add", "background image, blueprint"},
    OtherNames{"view.frame_all", "zoom extents, zoom all, fit all, home"},
    OtherNames{"view.frame_selection", "zoom selected, focus"},
    OtherNames{"view.iso", "isometric, axonometric"},
    OtherNames{"view.four", "quad view, four viewports"},
    OtherNames{"view.maximise", "maximize, single view"},
    OtherNames{"view.x_ray", "see through, ghosted"},
    OtherNames{"view.save", "bookmark, named view"},
    OtherNames{"view.focal_length", "field of view, FOV"},
    OtherNames{"analyse.section", "clipping plane, slice"},
    OtherNames{"analyse.section_curves", "contours, slices"},
    OtherNames{"analyse.zebra", "reflection lines, stripes"},
    OtherNames{"analyse.combs", "curvature graph, porcupine"},
    OtherNames{"analyse.environment", "environment map, HDRI"},
    OtherNames{"analyse.mesh", "tessellate, facets"},
    OtherNames{"measure.distance", "ruler, dimension, length"},
    OtherNames{"measure.angle", "protractor, dimension"},
    OtherNames{"property.unit", "units, millimeters, inches"},
    OtherNames{"property.mirror", "symmetry, mirror modifier"},
    OtherNames{"property.rounding", "fillet, edge radius"},
    OtherNames{"property.skin_mirror", "symmetry, symmetric editing"},
    OtherNames{"property.skin_caps", "cap, close ends"},
    OtherNames{"property.skin_flip", "flip normals, reverse"},
    OtherNames{"property.material", "shader, matcap"},
    OtherNames{"property.wire", "wireframe, mesh lines"},
    OtherNames{"property.density", "display quality, resolution"},
    OtherNames{"property.preferences.navigation", "pan, orbit, rotate view"},
    OtherNames{"property.preferences.theme", "dark mode, light mode"},
};

}  // namespace

void add_other_names(CommandTable& table) {
  for (const OtherNames& each : other_names_of_commands) table.call_also(each.id, each.names);
}

}  // namespace hariko
