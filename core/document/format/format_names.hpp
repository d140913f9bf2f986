#pragma once

// Words of the file format, in the order of the enumerations; reader and writer use the same lists.

#include <array>
#include <span>
#include <string_view>

namespace hariko::detail {

using namespace std::string_view_literals;

using Names = std::span<const std::string_view>;
inline constexpr std::array unit_names{"mm"sv, "cm"sv, "m"sv, "in"sv};
inline constexpr std::array map_names{"shaded"sv,    "patches"sv,       "zebra"sv,         "gaussian"sv,
                                      "mean"sv,      "principal_max"sv, "principal_min"sv, "continuity"sv,
                                      "isophotes"sv, "draft"sv,         "radius"sv,        "thickness"sv,
                                      "deviation"sv};
inline constexpr std::array material_names{"clay"sv, "porcelain"sv, "metal"sv,
                                           "wax"sv,  "rubber"sv,    "plastic"sv};
inline constexpr std::array wire_names{"none"sv, "borders"sv, "mesh"sv};
inline constexpr std::array range_mode_names{"symmetric"sv, "percentile"sv, "full"sv, "manual"sv};
inline constexpr std::array mode_names{"paper"sv, "target"sv, "fair"sv, "g2"sv};
inline constexpr std::array frames_names{"equal"sv, "metric"sv};
inline constexpr std::array tag_names{"automatic"sv, "corner"sv, "smooth"sv};
inline constexpr std::array axis_names{"x"sv, "y"sv, "z"sv};
inline constexpr std::array pin_names{"tangents"sv, "normal"sv};

/// Members that this version knows; all others are kept unchanged, or refused where that is not possible.
inline constexpr std::array document_members{"format"sv,  "version"sv,    "unit"sv,   "next_object_id"sv,
                                             "objects"sv, "dimensions"sv, "making"sv, "paper"sv};
inline constexpr std::array object_members{"id"sv,        "name"sv,    "visible"sv, "locked"sv,
                                           "transform"sv, "display"sv, "source"sv};
inline constexpr std::array transform_members{"rotation"sv, "scale"sv, "translation"sv};
inline constexpr std::array display_members{"surface"sv, "polyhedron"sv, "network"sv, "map"sv,  "density"sv,
                                            "colour"sv,  "material"sv,   "points"sv,  "wire"sv, "tensions"sv,
                                            "marks"sv,   "combs"sv,      "ranges"sv};
inline constexpr std::array combs_members{"shown"sv, "density"sv, "scale"sv};
inline constexpr std::array range_members{"mode"sv, "low"sv, "high"sv};
/// Names of the maps in `DisplaySettings::ranges`, in that order.
inline constexpr std::array ranges_members{"gaussian"sv,      "mean"sv,       "principal_max"sv,
                                           "principal_min"sv, "continuity"sv, "draft"sv,
                                           "radius"sv,        "thickness"sv,  "deviation"sv};
inline constexpr std::array polyhedron_members{
    "kind"sv,   "mode"sv,     "frames"sv, "round"sv,     "mirror"sv,  "preparation"sv,
    "origin"sv, "vertices"sv, "faces"sv,  "alpha"sv,     "beta"sv,    "crease"sv,
    "tag"sv,    "pin"sv,      "form"sv,   "kept_area"sv, "attached"sv};
inline constexpr std::array preparation_members{"split_concave"sv, "merge_coplanar"sv, "automatic_tension"sv};
inline constexpr std::array attachment_members{"edge"sv,       "patch"sv,  "side"sv,  "reversed"sv,
                                               "continuity"sv, "adapts"sv, "frozen"sv};
inline constexpr std::array frozen_members{"curve"sv, "row"sv};
inline constexpr std::array continuity_names{"g0"sv, "g1"sv};
inline constexpr std::array adapts_names{"surface"sv, "patch"sv};
inline constexpr std::array patches_members{"kind"sv, "origin"sv, "columns"sv, "rows"sv, "points"sv};
inline constexpr std::array bezier_members{"kind"sv, "origin"sv, "patches"sv};
inline constexpr std::array bezier_patch_members{"degree"sv, "points"sv, "weights"sv};
inline constexpr std::array mirror_members{"axis"sv, "weld_distance"sv};
inline constexpr std::array pin_members{"vertex"sv, "kind"sv, "vectors"sv};
inline constexpr std::array form_members{"vertex"sv, "edges"sv};
/// Members of solids; many of them occur only in files before version 4.
inline constexpr std::array solids_members{"kind"sv,        "primitives"sv, "roundness"sv,    "waist"sv,
                                           "tightness"sv,   "clearance"sv,  "detail"sv,       "merge_deg"sv,
                                           "cage_detail"sv, "method"sv,     "surface"sv,      "symmetry"sv,
                                           "waists"sv,      "fullness"sv,   "offsets"sv,      "ball_radius"sv,
                                           "rounding"sv,    "on_faces"sv,   "finer_patches"sv};
/// Names of methods; "auto" and "field" occur only in files before version 4.
inline constexpr std::array method_names{"auto"sv, "network"sv, "field"sv, "ball"sv};
inline constexpr std::array envelope_surface_names{"rational"sv, "fair"sv};
inline constexpr std::array symmetry_names{"none"sv, "x"sv, "y"sv, "z"sv};
inline constexpr std::array skin_members{"kind"sv,   "path"sv,  "rail2"sv,   "frame"sv,        "sections"sv,
                                         "method"sv, "caps"sv,  "creases"sv, "flip_normals"sv, "smooth"sv,
                                         "pleat"sv,  "links"sv, "merges"sv,  "mirror"sv};
inline constexpr std::array skin_mirror_members{"axis"sv, "position"sv};
inline constexpr std::array outline_members{"kind"sv,   "loops"sv,       "method"sv, "curvature_sign"sv,
                                            "radius"sv, "most_points"sv, "gap"sv,    "mode"sv};
inline constexpr std::array picture_members{"kind"sv,  "path"sv,    "pixels"sv,    "width"sv,
                                            "layer"sv, "opacity"sv, "only_from"sv, "data"sv};
inline constexpr std::array layer_names{"space"sv, "behind"sv, "front"sv};
inline constexpr std::array side_names{"front"sv, "back"sv, "left"sv, "right"sv, "top"sv, "bottom"sv};
inline constexpr std::array gauss_names{"curvature"sv, "umbilic"sv, "minkowski"sv, "paper"sv, "position"sv};
inline constexpr std::array sign_names{"positive"sv, "negative"sv};
inline constexpr std::array outline_patch_names{"fair"sv, "g2"sv};
inline constexpr std::array loop_members{"points"sv, "normals"sv, "K"sv};
inline constexpr std::array frame_names{"automatic"sv, "translate"sv, "rmf"sv, "two-rail"sv};
inline constexpr std::array skin_method_names{"smooth"sv, "anchored"sv, "pleat"sv};
inline constexpr std::array caps_names{"none"sv, "flat"sv, "dome"sv};
inline constexpr std::array parameters_names{"uniform"sv, "shared"sv, "per-section"sv};
inline constexpr std::array blend_names{"automatic"sv, "linear"sv, "natural"sv, "hermite"sv};
inline constexpr std::array row_names{"even"sv, "path"sv};
inline constexpr std::array fit_names{"none"sv, "local"sv, "fair"sv};
inline constexpr std::array cost_names{"parameter"sv, "shape"sv};
inline constexpr std::array strip_side_names{"a"sv, "b"sv};
inline constexpr std::array mesh_members{"kind"sv, "origin"sv, "vertices"sv, "faces"sv};

inline constexpr std::array dimension_members{"id"sv, "kind"sv, "anchors"sv, "label"sv};
inline constexpr std::array anchor_members{"object"sv, "point"sv, "solid"sv, "vertex"sv,
                                           "image"sv,  "edge"sv,  "share"sv, "straight"sv,
                                           "patch"sv,  "side"sv,  "at"sv,    "nearest"sv};
inline constexpr std::array dimension_names{"distance"sv, "angle"sv, "radius"sv};

inline constexpr std::array making_members{"pull"sv, "draft"sv, "radius"sv, "thickness"sv, "reference"sv};

inline constexpr std::array paper_members{"objects"sv,  "of_polyhedra"sv, "distance"sv,  "normal_angle"sv,
                                          "settings"sv, "goal"sv,         "steps"sv,     "vertices"sv,
                                          "folds"sv,    "cuts"sv,         "own_folds"sv, "own_cuts"sv,
                                          "tabs"sv,     "strips"sv,       "places"sv,    "strip_places"sv};
inline constexpr std::array paper_setting_members{
    "scale"sv,       "page"sv,   "margin"sv,    "gap"sv,         "tab_height"sv, "least_tab"sv,
    "strip_width"sv, "inside"sv, "flat_fold"sv, "merge_angle"sv, "fold_angles"sv};
inline constexpr std::array goal_names{"fewest"sv, "balanced"sv, "easiest"sv};
inline constexpr std::array element_names{"none"sv, "vertex"sv, "edge"sv, "face"sv, "object"sv};

/// Word of an enumerator.
template <class Enum>
std::string_view name_of(Enum value, Names names) {
  return names[static_cast<std::size_t>(value)];
}

}  // namespace hariko::detail
