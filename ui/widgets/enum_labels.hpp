#pragma once

// Labels of enumerations: one table for each that is shown in a list, in the order of its enumerators, which
// the compiler checks. Words for files and scripts stand beside the enumerations (`enum_words.hpp`).

#include "core/approximation/mesh_options.hpp"
#include "core/document/words.hpp"
#include "render/scene.hpp"
#include "ui/base/language.hpp"
#include "ui/base/settings.hpp"
#include "ui/widgets/choice.hpp"

namespace hariko {

// Document.
template <>
inline constexpr auto enum_choices<Unit> = all_choices<Unit>({
    {Unit::millimetre, "Millimetres", ""},
    {Unit::centimetre, "Centimetres", ""},
    {Unit::metre, "Metres", ""},
    {Unit::inch, "Inches", ""},
});
// Polyhedra.
template <>
inline constexpr auto enum_choices<Mode> = all_choices<Mode>({
    {Mode::paper, "As published", "The construction as first published"},
    {Mode::target, "Local", "Each face follows its own boundary curves alone: the quickest to compute"},
    {Mode::fair, "Fair", "Balances the curvature inside the faces: the smoothest result"},
    {Mode::g2, translatable("G2"), "Curvature runs on without a break over edges and through vertices"},
});
template <>
inline constexpr auto enum_choices<VertexTag> = all_choices<VertexTag>({
    {VertexTag::automatic, "Automatic", "A corner where creases or the border demand it"},
    {VertexTag::corner, "Corner", "Every curve ends here with its own direction"},
    {VertexTag::smooth, "Smooth", "Creases and the border run smoothly through"},
});
template <>
inline constexpr auto enum_choices<Continuity> = all_choices<Continuity>({
    {Continuity::g0, translatable("continuity\4Position"), "The edge lies on the side's curve"},
    {Continuity::g1, translatable("continuity\4Tangent"), "The tangent planes agree too, all along"},
});
template <>
inline constexpr auto enum_choices<Adapts> = all_choices<Adapts>({
    {Adapts::surface, "Surface", "This surface takes the patch's tangent planes"},
    {Adapts::patch, "Patch", "The patch's second row of points takes this surface's tangent planes"},
});
// Solids.
template <>
inline constexpr auto enum_choices<EnvelopeMethod> = all_choices<EnvelopeMethod>({
    {EnvelopeMethod::ball, "Ball", "What a ball leaves that rolls over the solids, rounded"},
    {EnvelopeMethod::network, "Curves",
     "A network of curves round the hull of the solids; it may fold or miss them"},
});
template <>
inline constexpr auto enum_choices<SymmetryPlane> = all_choices<SymmetryPlane>({
    {SymmetryPlane::none, "None", "Only the solids that are there"},
    {SymmetryPlane::x, "Across x",
     "Solids have images beyond the plane across the x axis; the surface is symmetric"},
    {SymmetryPlane::y, "Across y",
     "Solids have images beyond the plane across the y axis; the surface is symmetric"},
    {SymmetryPlane::z, "Across z",
     "Solids have images beyond the plane across the z axis; the surface is symmetric"},
});
// Skins.
template <>
inline constexpr auto enum_choices<SkinMethod> = all_choices<SkinMethod>({
    {SkinMethod::smooth, "Smooth",
     "A regular grid over a blend of the sections: smooth everywhere, features may blur"},
    {SkinMethod::anchored, "Anchored", "A regular grid whose columns run through the points that you join"},
    {SkinMethod::pleat, "Pleat", "Points of the sections are joined by lines that the surface follows"},
});
template <>
inline constexpr auto enum_choices<FrameMode> = all_choices<FrameMode>({
    {FrameMode::automatic, "Automatic", "By the bends of the path"},
    {FrameMode::translate, "Parallel", "Sections are moved along the path without turning"},
    {FrameMode::rotation_minimising, "Turning",
     "Sections turn with the path, and as little as possible round it"},
    {FrameMode::two_rail, "Two rails", "Sections are stretched between the path and a second one"},
});
template <>
inline constexpr auto enum_choices<Blend> = all_choices<Blend>({
    {Blend::automatic, "Automatic", "Linear for two sections, natural for more"},
    {Blend::linear, "Linear", "A ridge at each section"},
    {Blend::natural, "Natural", "Flows through the sections"},
    {Blend::hermite, "Hermite", "Each section acts near itself only"},
});
template <>
inline constexpr auto enum_choices<SectionFit> = all_choices<SectionFit>({
    {SectionFit::none, "None", "Sections inside are approached only"},
    {SectionFit::local, "Local", "Goes exactly through the sections; dense rows can dimple"},
    {SectionFit::fair, "Fair", "Goes exactly through the sections, as fair as the tension lets it"},
});
template <>
inline constexpr auto enum_choices<Caps> = all_choices<Caps>({
    {Caps::none, "None", "Closed sections leave the ends open"},
    {Caps::flat, "Flat", "A face with a sharp edge closes each end"},
    {Caps::dome, "Dome", "A round end"},
});
template <>
inline constexpr auto enum_choices<MatchCost> = all_choices<MatchCost>({
    {MatchCost::parameter, "Parameter", "By how far along their sections points are"},
    {MatchCost::shape, "Shape", "By where points are on their sections: finds the seams of closed ones"},
});
template <>
inline constexpr auto enum_choices<ColumnParameters> = all_choices<ColumnParameters>({
    {ColumnParameters::uniform, "Even", "At even distances along each section"},
    {ColumnParameters::shared, "Shared", "Where they follow all sections best, at the same places of each"},
    {ColumnParameters::per_section, "Each section", "Where they follow each section best"},
});
// Outlines.
template <>
inline constexpr auto enum_choices<GaussMode> = all_choices<GaussMode>({
    {GaussMode::curvature, "Curvature",
     "Uses the Gaussian curvature along the loops; it fixes how the surface bends across them"},
    {GaussMode::umbilic, "Round", "As round as the loops and their normals allow; for domes and saddles"},
    {GaussMode::paper, "As published",
     "The construction as first published, for comparison: it does not converge"},
    {GaussMode::position, "Position",
     "Bends as little as it can; curvature of both signs and folds are allowed"},
});
template <>
inline constexpr auto enum_choices<CurvatureSign> = all_choices<CurvatureSign>({
    {CurvatureSign::positive, "Dome", "The surface bends to one side everywhere"},
    {CurvatureSign::negative, "Saddle", "The surface bends to both sides everywhere"},
});
// Pictures.
template <>
inline constexpr auto enum_choices<PictureLayer> = all_choices<PictureLayer>({
    {PictureLayer::space, "In space", "Its plane lies among the surfaces"},
    {PictureLayer::behind, "Behind", "Behind all that is modelled"},
    {PictureLayer::front, "In front", "Before all that is modelled"},
});
template <>
inline constexpr auto enum_choices<PictureSide> = all_choices<PictureSide>({
    {PictureSide::front, "Front", "A view from the front sees it squarely"},
    {PictureSide::back, "Back", "A view from the back sees it squarely"},
    {PictureSide::left, "Left", "A view from the left sees it squarely"},
    {PictureSide::right, "Right", "A view from the right sees it squarely"},
    {PictureSide::top, "Top", "A view from above sees it squarely"},
    {PictureSide::bottom, "Bottom", "A view from below sees it squarely"},
});
// Display.
template <>
inline constexpr auto enum_choices<SurfaceMap> = all_choices<SurfaceMap>({
    {SurfaceMap::shaded, "As the view",
     "The map that the menu Analyse shows on all surfaces, or a material in studio light"},
    {SurfaceMap::patches, "Patches", "One colour for each patch"},
    {SurfaceMap::zebra, "Zebra", "Reflected stripes: a kink in a stripe shows a jump of curvature"},
    {SurfaceMap::gaussian, "Gaussian curvature",
     "Product of the principal curvatures: red dome, blue saddle"},
    {SurfaceMap::mean, "Mean curvature", "Mean of the principal curvatures"},
    {SurfaceMap::principal_max, "Greatest curvature", "The larger principal curvature k1"},
    {SurfaceMap::principal_min, "Least curvature", "The smaller principal curvature k2"},
    {SurfaceMap::continuity, "Continuity", "How much curvature jumps across the edges"},
    {SurfaceMap::isophotes, "Isophotes", "Bands of equal angle between the surface and a direction"},
    {SurfaceMap::draft, "Draft angle", "Angle between the surface and the pull of a mould"},
    {SurfaceMap::radius, "Smallest radius", "Radius of the tighter of the two curvatures"},
    {SurfaceMap::thickness, "Wall thickness", "How far it is to the other side of a closed surface"},
    {SurfaceMap::deviation, "Deviation", "Distance from another object, which is the reference"},
});
template <>
inline constexpr auto enum_choices<Material> = all_choices<Material>({
    {Material::clay, "Clay", "Matt: shows the form"},
    {Material::porcelain, "Porcelain", "White gloss: shows where highlights run"},
    {Material::metal, "Metal", "Mirrors the studio: shows every dent"},
    {Material::wax, "Wax", "Soft light under the skin"},
    {Material::rubber, "Rubber", "Dark and dull: shows outlines"},
    {Material::plastic, "Plastic", "Coloured gloss"},
});
template <>
inline constexpr auto enum_choices<EnvironmentKind> = all_choices<EnvironmentKind>({
    {EnvironmentKind::studio, "Studio", "Soft boxes in a grey room"},
    {EnvironmentKind::tubes, "Light tubes", "Parallel tubes overhead, as in a body shop"},
    {EnvironmentKind::horizon, "Horizon", "Dark ground under a clear sky: shows one line that runs round"},
    {EnvironmentKind::overcast, "Overcast sky", "Soft light from above, without edges"},
    {EnvironmentKind::file, "Picture file", "A panorama of your own: Radiance, PNG or JPEG"},
});
template <>
inline constexpr auto enum_choices<RangeMode> = all_choices<RangeMode>({
    {RangeMode::symmetric, "Symmetric", "As far below zero as above, without the outermost 2 %"},
    {RangeMode::percentile, "Percentile", "From the 2 % to the 98 % quantile"},
    {RangeMode::full, "Full", "From the least to the greatest value"},
    {RangeMode::manual, "Typed", "From and to the values below"},
});
template <>
inline constexpr auto enum_choices<StripeLock> = all_choices<StripeLock>({
    {StripeLock::view, "Screen", "Stripes keep their place on the screen"},
    {StripeLock::world, "World", "Stripes stand in the room"},
    {StripeLock::object, "Object", "Stripes turn with the object"},
    {StripeLock::tubes, "Ceiling",
     "Zebra: parallel light tubes hang over the model, near enough that stripes depend on the place, too"},
});
template <>
inline constexpr auto enum_choices<PatchWire> = all_choices<PatchWire>({
    {PatchWire::none, "None", "No lines over the surface"},
    {PatchWire::borders, "Patch borders", "Where patches meet"},
    {PatchWire::mesh, "Display mesh", "The triangles on the screen"},
});
// Paper and triangles.
template <>
inline constexpr auto enum_choices<CutGoal> = all_choices<CutGoal>({
    {CutGoal::fewest, "Fewest pieces", "As few pieces as can be found"},
    {CutGoal::balanced, "Balanced", "Few pieces, few pages and few strips"},
    {CutGoal::easiest, "Easiest to glue", "Few slits, so few joint strips"},
});
template <>
inline constexpr auto enum_choices<MeshStart> = all_choices<MeshStart>({
    {MeshStart::patches, "Whole patches", "Two facets a patch, which are cut where they have to be"},
    {MeshStart::cells, "Cells",
     "As long as their curvature lets them be: fewer facets where a surface bends evenly, or one way only"},
});
template <>
inline constexpr auto enum_choices<SplitRule> = all_choices<SplitRule>({
    {SplitRule::midpoint, "Longest edge", "The longest edge in its middle"},
    {SplitRule::halving, "Halved normals", "Where the normal halves the angle, as in the paper"},
    {SplitRule::gauss, "Curvature", "Along the curvature, by the image on the sphere of normals"},
    {SplitRule::curvature, "Root of curvature", "By the square root of the curvature; for distances"},
});

// Preferences. Products are called by their own names.
template <>
inline constexpr auto enum_choices<ThemeId> = all_choices<ThemeId>({
    {ThemeId::dark, "Dark", ""},
    {ThemeId::light, "Light", ""},
});
template <>
inline constexpr auto enum_choices<NavigationPreset> = all_choices<NavigationPreset>({
    {NavigationPreset::hariko, "Hariko", ""},
    {NavigationPreset::blender, "Blender", ""},
    {NavigationPreset::maya, "Maya", ""},
    {NavigationPreset::rhino, "Rhino", ""},
    {NavigationPreset::trackpad, "Trackpad", ""},
});

}  // namespace hariko
