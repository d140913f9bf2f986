#pragma once

// Labels of enumerations: one table for each that is shown in a list, in the order of its enumerators, which
// the compiler checks. Words for files and scripts stand beside the enumerations (`enum_words.hpp`).

#include "core/approximation/mesh_options.hpp"
#include "core/document/words.hpp"
#include "render/scene.hpp"
#include "ui/base/settings.hpp"
#include "ui/widgets/choice.hpp"

namespace hariko {

// Document.
template <>
inline constexpr auto enum_choices<Unit> = all_choices<Unit>({
    {Unit::millimetre, {translatable("Millimetres"), ""}},
    {Unit::centimetre, {translatable("Centimetres"), ""}},
    {Unit::metre, {translatable("Metres"), ""}},
    {Unit::inch, {translatable("Inches"), ""}},
});
// Polyhedra.
template <>
inline constexpr auto enum_choices<Mode> = all_choices<Mode>({
    {Mode::paper, {translatable("As published"), translatable("The construction as first published")}},
    {Mode::target,
     {translatable("Local"),
      translatable("Each face follows its own boundary curves alone: the quickest to compute")}},
    {Mode::fair,
     {translatable("Fair"), translatable("Balances the curvature inside the faces: the smoothest result")}},
    {Mode::g2,
     {translatable("G2"), translatable("Curvature runs on without a break over edges and through vertices")}},
});
template <>
inline constexpr auto enum_choices<VertexTag> = all_choices<VertexTag>({
    {VertexTag::automatic,
     {translatable("Automatic"), translatable("A corner where creases or the border demand it")}},
    {VertexTag::corner,
     {translatable("Corner"), translatable("Every curve ends here with its own direction")}},
    {VertexTag::smooth,
     {translatable("Smooth"), translatable("Creases and the border run smoothly through")}},
});
template <>
inline constexpr auto enum_choices<Continuity> = all_choices<Continuity>({
    {Continuity::g0, {translatable("Position"), translatable("The edge lies on the side's curve")}},
    {Continuity::g1, {translatable("Tangent"), translatable("The tangent planes agree too, all along")}},
});
template <>
inline constexpr auto enum_choices<Adapts> = all_choices<Adapts>({
    {Adapts::surface,
     {translatable("Surface"), translatable("This surface takes the patch's tangent planes")}},
    {Adapts::patch,
     {translatable("Patch"),
      translatable("The patch's second row of points takes this surface's tangent planes")}},
});
// Solids.
template <>
inline constexpr auto enum_choices<EnvelopeMethod> = all_choices<EnvelopeMethod>({
    {EnvelopeMethod::ball,
     {translatable("Ball"), translatable("What a ball leaves that rolls over the solids, rounded")}},
    {EnvelopeMethod::network,
     {translatable("Curves"),
      translatable("A network of curves round the hull of the solids; it may fold or miss them")}},
});
template <>
inline constexpr auto enum_choices<SymmetryPlane> = all_choices<SymmetryPlane>({
    {SymmetryPlane::none, {translatable("None"), translatable("Only the solids that are there")}},
    {SymmetryPlane::x,
     {translatable("Across x"),
      translatable("Solids have images beyond the plane across the x axis; the surface is symmetric")}},
    {SymmetryPlane::y,
     {translatable("Across y"),
      translatable("Solids have images beyond the plane across the y axis; the surface is symmetric")}},
    {SymmetryPlane::z,
     {translatable("Across z"),
      translatable("Solids have images beyond the plane across the z axis; the surface is symmetric")}},
});
// Skins.
template <>
inline constexpr auto enum_choices<SkinMethod> = all_choices<SkinMethod>({
    {SkinMethod::smooth,
     {translatable("Smooth"),
      translatable("A regular grid over a blend of the sections: smooth everywhere, features may blur")}},
    {SkinMethod::anchored,
     {translatable("Anchored"),
      translatable("A regular grid whose columns run through the points that you join")}},
    {SkinMethod::pleat,
     {translatable("Pleat"),
      translatable("Points of the sections are joined by lines that the surface follows")}},
});
template <>
inline constexpr auto enum_choices<FrameMode> = all_choices<FrameMode>({
    {FrameMode::automatic, {translatable("Automatic"), translatable("By the bends of the path")}},
    {FrameMode::translate,
     {translatable("Parallel"), translatable("Sections are moved along the path without turning")}},
    {FrameMode::rotation_minimising,
     {translatable("Turning"),
      translatable("Sections turn with the path, and as little as possible round it")}},
    {FrameMode::two_rail,
     {translatable("Two rails"), translatable("Sections are stretched between the path and a second one")}},
});
template <>
inline constexpr auto enum_choices<Blend> = all_choices<Blend>({
    {Blend::automatic,
     {translatable("Automatic"), translatable("Linear for two sections, natural for more")}},
    {Blend::linear, {translatable("Linear"), translatable("A ridge at each section")}},
    {Blend::natural, {translatable("Natural"), translatable("Flows through the sections")}},
    {Blend::hermite, {translatable("Hermite"), translatable("Each section acts near itself only")}},
});
template <>
inline constexpr auto enum_choices<SectionFit> = all_choices<SectionFit>({
    {SectionFit::none, {translatable("None"), translatable("Sections inside are approached only")}},
    {SectionFit::local,
     {translatable("Local"), translatable("Goes exactly through the sections; dense rows can dimple")}},
    {SectionFit::fair,
     {translatable("Fair"),
      translatable("Goes exactly through the sections, as fair as the tension lets it")}},
});
template <>
inline constexpr auto enum_choices<Caps> = all_choices<Caps>({
    {Caps::none, {translatable("None"), translatable("Closed sections leave the ends open")}},
    {Caps::flat, {translatable("Flat"), translatable("A face with a sharp edge closes each end")}},
    {Caps::dome, {translatable("Dome"), translatable("A round end")}},
});
template <>
inline constexpr auto enum_choices<MatchCost> = all_choices<MatchCost>({
    {MatchCost::parameter,
     {translatable("Parameter"), translatable("By how far along their sections points are")}},
    {MatchCost::shape,
     {translatable("Shape"),
      translatable("By where points are on their sections: finds the seams of closed ones")}},
});
template <>
inline constexpr auto enum_choices<ColumnParameters> = all_choices<ColumnParameters>({
    {ColumnParameters::uniform, {translatable("Even"), translatable("At even distances along each section")}},
    {ColumnParameters::shared,
     {translatable("Shared"),
      translatable("Where they follow all sections best, at the same places of each")}},
    {ColumnParameters::per_section,
     {translatable("Each section"), translatable("Where they follow each section best")}},
});
// Outlines.
template <>
inline constexpr auto enum_choices<GaussMode> = all_choices<GaussMode>({
    {GaussMode::curvature,
     {translatable("Curvature"),
      translatable(
          "Uses the Gaussian curvature along the loops; it fixes how the surface bends across them")}},
    {GaussMode::umbilic,
     {translatable("Round"),
      translatable("As round as the loops and their normals allow; for domes and saddles")}},
    {GaussMode::minkowski,
     {translatable("Minkowski"),
      translatable("Spreads the curvature inside so that areas fit exactly; for domes only")}},
    {GaussMode::paper,
     {translatable("As published"),
      translatable("The construction as first published, for comparison: it does not converge")}},
    {GaussMode::position,
     {translatable("Position"),
      translatable("Bends as little as it can; curvature of both signs and folds are allowed")}},
});
template <>
inline constexpr auto enum_choices<CurvatureSign> = all_choices<CurvatureSign>({
    {CurvatureSign::positive,
     {translatable("Dome"), translatable("The surface bends to one side everywhere")}},
    {CurvatureSign::negative,
     {translatable("Saddle"), translatable("The surface bends to both sides everywhere")}},
});
// Pictures.
template <>
inline constexpr auto enum_choices<PictureLayer> = all_choices<PictureLayer>({
    {PictureLayer::space, {translatable("In space"), translatable("Its plane lies among the surfaces")}},
    {PictureLayer::behind, {translatable("Behind"), translatable("Behind all that is modelled")}},
    {PictureLayer::front, {translatable("In front"), translatable("Before all that is modelled")}},
});
template <>
inline constexpr auto enum_choices<PictureSide> = all_choices<PictureSide>({
    {PictureSide::front, {translatable("Front"), translatable("A view from the front sees it squarely")}},
    {PictureSide::back, {translatable("Back"), translatable("A view from the back sees it squarely")}},
    {PictureSide::left, {translatable("Left"), translatable("A view from the left sees it squarely")}},
    {PictureSide::right, {translatable("Right"), translatable("A view from the right sees it squarely")}},
    {PictureSide::top, {translatable("Top"), translatable("A view from above sees it squarely")}},
    {PictureSide::bottom, {translatable("Bottom"), translatable("A view from below sees it squarely")}},
});
// Display.
template <>
inline constexpr auto enum_choices<SurfaceMap> = all_choices<SurfaceMap>({
    {SurfaceMap::shaded,
     {translatable("As the view"),
      translatable("The map that the menu Analyse shows on all surfaces, or a material in studio light")}},
    {SurfaceMap::patches, {translatable("Patches"), translatable("One colour for each patch")}},
    {SurfaceMap::zebra,
     {translatable("Zebra"),
      translatable("Reflected stripes: a kink in a stripe shows a jump of curvature")}},
    {SurfaceMap::gaussian,
     {translatable("Gaussian curvature"),
      translatable("Product of the principal curvatures: red dome, blue saddle")}},
    {SurfaceMap::mean, {translatable("Mean curvature"), translatable("Mean of the principal curvatures")}},
    {SurfaceMap::principal_max,
     {translatable("Greatest curvature"), translatable("The larger principal curvature k1")}},
    {SurfaceMap::principal_min,
     {translatable("Least curvature"), translatable("The smaller principal curvature k2")}},
    {SurfaceMap::continuity,
     {translatable("Continuity"), translatable("How much curvature jumps across the edges")}},
    {SurfaceMap::isophotes,
     {translatable("Isophotes"), translatable("Bands of equal angle between the surface and a direction")}},
    {SurfaceMap::draft,
     {translatable("Draft angle"), translatable("Angle between the surface and the pull of a mould")}},
    {SurfaceMap::radius,
     {translatable("Smallest radius"), translatable("Radius of the tighter of the two curvatures")}},
    {SurfaceMap::thickness,
     {translatable("Wall thickness"), translatable("How far it is to the other side of a closed surface")}},
    {SurfaceMap::deviation,
     {translatable("Deviation"), translatable("Distance from another object, which is the reference")}},
});
template <>
inline constexpr auto enum_choices<Material> = all_choices<Material>({
    {Material::clay, {translatable("Clay"), translatable("Matt: shows the form")}},
    {Material::porcelain,
     {translatable("Porcelain"), translatable("White gloss: shows where highlights run")}},
    {Material::metal, {translatable("Metal"), translatable("Mirrors the studio: shows every dent")}},
    {Material::wax, {translatable("Wax"), translatable("Soft light under the skin")}},
    {Material::rubber, {translatable("Rubber"), translatable("Dark and dull: shows outlines")}},
    {Material::plastic, {translatable("Plastic"), translatable("Coloured gloss")}},
});
template <>
inline constexpr auto enum_choices<EnvironmentKind> = all_choices<EnvironmentKind>({
    {EnvironmentKind::studio, {translatable("Studio"), translatable("Soft boxes in a grey room")}},
    {EnvironmentKind::tubes,
     {translatable("Light tubes"), translatable("Parallel tubes overhead, as in a body shop")}},
    {EnvironmentKind::horizon,
     {translatable("Horizon"),
      translatable("Dark ground under a clear sky: shows one line that runs round")}},
    {EnvironmentKind::overcast,
     {translatable("Overcast sky"), translatable("Soft light from above, without edges")}},
    {EnvironmentKind::file,
     {translatable("Picture file"), translatable("A panorama of your own: Radiance, PNG or JPEG")}},
});
template <>
inline constexpr auto enum_choices<RangeMode> = all_choices<RangeMode>({
    {RangeMode::symmetric,
     {translatable("Symmetric"), translatable("As far below zero as above, without the outermost 2 %")}},
    {RangeMode::percentile, {translatable("Percentile"), translatable("From the 2 % to the 98 % quantile")}},
    {RangeMode::full, {translatable("Full"), translatable("From the least to the greatest value")}},
    {RangeMode::manual, {translatable("Typed"), translatable("From and to the values below")}},
});
template <>
inline constexpr auto enum_choices<StripeLock> = all_choices<StripeLock>({
    {StripeLock::view, {translatable("View"), translatable("Stripes keep their place on the screen")}},
    {StripeLock::world, {translatable("World"), translatable("Stripes stand in the room")}},
    {StripeLock::object, {translatable("Object"), translatable("Stripes turn with the object")}},
    {StripeLock::tubes,
     {translatable("Ceiling"),
      translatable("Zebra: parallel light tubes hang over the model, near enough that "
                   "stripes depend on the place, too")}},
});
template <>
inline constexpr auto enum_choices<PatchWire> = all_choices<PatchWire>({
    {PatchWire::none, {translatable("None"), translatable("No lines over the surface")}},
    {PatchWire::borders, {translatable("Patch borders"), translatable("Where patches meet")}},
    {PatchWire::mesh, {translatable("Display mesh"), translatable("The triangles on the screen")}},
});
// Paper and triangles.
template <>
inline constexpr auto enum_choices<CutGoal> = all_choices<CutGoal>({
    {CutGoal::fewest, {translatable("Fewest pieces"), translatable("As few pieces as can be found")}},
    {CutGoal::balanced, {translatable("Balanced"), translatable("Few pieces, few pages and few strips")}},
    {CutGoal::easiest, {translatable("Easiest to glue"), translatable("Few slits, so few joint strips")}},
});
template <>
inline constexpr auto enum_choices<MeshStart> = all_choices<MeshStart>({
    {MeshStart::patches,
     {translatable("Whole patches"),
      translatable("Two facets a patch, which are cut where they have to be")}},
    {MeshStart::cells,
     {translatable("Cells"), translatable("As long as their curvature lets them be: fewer facets where a "
                                          "surface bends evenly, or one way only")}},
});
template <>
inline constexpr auto enum_choices<SplitRule> = all_choices<SplitRule>({
    {SplitRule::midpoint, {translatable("Longest edge"), translatable("The longest edge in its middle")}},
    {SplitRule::halving,
     {translatable("Halved normals"), translatable("Where the normal halves the angle, as in the paper")}},
    {SplitRule::gauss,
     {translatable("Curvature"), translatable("Along the curvature, by the image on the sphere of normals")}},
    {SplitRule::curvature,
     {translatable("Root of curvature"), translatable("By the square root of the curvature; for distances")}},
});

// Preferences. A language is called by its own name, and products by theirs.
template <>
inline constexpr auto enum_choices<ThemeId> = all_choices<ThemeId>({
    {ThemeId::dark, {translatable("Dark"), ""}},
    {ThemeId::light, {translatable("Light"), ""}},
});
template <>
inline constexpr auto enum_choices<LanguageId> = all_choices<LanguageId>({
    {LanguageId::english, {"English", ""}},
    {LanguageId::japanese, {japanese_in_japanese, ""}},
});
template <>
inline constexpr auto enum_choices<NavigationPreset> = all_choices<NavigationPreset>({
    {NavigationPreset::hariko, {"Hariko", ""}},
    {NavigationPreset::blender, {"Blender", ""}},
    {NavigationPreset::maya, {"Maya", ""}},
    {NavigationPreset::rhino, {"Rhino", ""}},
    {NavigationPreset::trackpad, {translatable("Trackpad"), ""}},
});

}  // namespace hariko
