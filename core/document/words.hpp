#pragma once

// Words of the document's enumerations: the format, the command line and scripts share them.

#include "core/base/text/enum_words.hpp"
#include "core/document/document.hpp"
#include "core/document/paper_model.hpp"

namespace hariko {

template <>
inline constexpr auto enum_words<Unit> = all_words<Unit>(
    {{Unit::millimetre, "mm"}, {Unit::centimetre, "cm"}, {Unit::metre, "m"}, {Unit::inch, "in"}});
template <>
inline constexpr auto enum_words<Projection> = all_words<Projection>({{Projection::perspective,
                                                                       "perspective"},
                                                                      {Projection::parallel, "parallel"},
                                                                      {Projection::two_point, "two_point"}});
template <>
inline constexpr auto enum_words<Axis> = all_words<Axis>({{Axis::x, "x"}, {Axis::y, "y"}, {Axis::z, "z"}});
/// Elements that files name; `line` is one of messages only.
template <>
inline constexpr auto enum_words<Element::Kind> =
    first_words<Element::Kind>({{Element::Kind::none, "none"},
                                {Element::Kind::vertex, "vertex"},
                                {Element::Kind::edge, "edge"},
                                {Element::Kind::face, "face"},
                                {Element::Kind::object, "object"}});

// Display.
template <>
inline constexpr auto enum_words<SurfaceMap> =
    all_words<SurfaceMap>({{SurfaceMap::shaded, "shaded"},
                           {SurfaceMap::patches, "patches"},
                           {SurfaceMap::zebra, "zebra"},
                           {SurfaceMap::gaussian, "gaussian"},
                           {SurfaceMap::mean, "mean"},
                           {SurfaceMap::principal_max, "principal_max"},
                           {SurfaceMap::principal_min, "principal_min"},
                           {SurfaceMap::continuity, "continuity"},
                           {SurfaceMap::isophotes, "isophotes"},
                           {SurfaceMap::draft, "draft"},
                           {SurfaceMap::radius, "radius"},
                           {SurfaceMap::thickness, "thickness"},
                           {SurfaceMap::deviation, "deviation"}});
template <>
inline constexpr auto enum_words<Material> = all_words<Material>({{Material::clay, "clay"},
                                                                  {Material::porcelain, "porcelain"},
                                                                  {Material::metal, "metal"},
                                                                  {Material::wax, "wax"},
                                                                  {Material::rubber, "rubber"},
                                                                  {Material::plastic, "plastic"}});
template <>
inline constexpr auto enum_words<PatchWire> = all_words<PatchWire>({{PatchWire::none, "none"},
                                                                    {PatchWire::borders, "borders"},
                                                                    {PatchWire::mesh, "mesh"}});
template <>
inline constexpr auto enum_words<RangeMode> = all_words<RangeMode>({{RangeMode::symmetric, "symmetric"},
                                                                    {RangeMode::percentile, "percentile"},
                                                                    {RangeMode::full, "full"},
                                                                    {RangeMode::manual, "manual"}});

// Polyhedra.
template <>
inline constexpr auto enum_words<Mode> = all_words<Mode>(
    {{Mode::paper, "paper"}, {Mode::target, "target"}, {Mode::fair, "fair"}, {Mode::g2, "g2"}});
template <>
inline constexpr auto enum_words<Frames> = all_words<Frames>({{Frames::equal, "equal"},
                                                              {Frames::metric, "metric"}});
template <>
inline constexpr auto enum_words<VertexTag> = all_words<VertexTag>({{VertexTag::automatic, "automatic"},
                                                                    {VertexTag::corner, "corner"},
                                                                    {VertexTag::smooth, "smooth"}});
template <>
inline constexpr auto enum_words<Pin::Kind> = all_words<Pin::Kind>({{Pin::Kind::tangents, "tangents"},
                                                                    {Pin::Kind::normal, "normal"}});
/// Continuities of attached edges, which are never joined with `g2`.
template <>
inline constexpr auto enum_words<Continuity> = first_words<Continuity>({{Continuity::g0, "g0"},
                                                                        {Continuity::g1, "g1"}});
template <>
inline constexpr auto enum_words<Adapts> = all_words<Adapts>({{Adapts::surface, "surface"},
                                                              {Adapts::patch, "patch"}});

// Solids.
template <>
inline constexpr auto enum_words<EnvelopeMethod> =
    all_words<EnvelopeMethod>({{EnvelopeMethod::ball, "ball"}, {EnvelopeMethod::network, "network"}});
template <>
inline constexpr auto enum_words<SymmetryPlane> = all_words<SymmetryPlane>({{SymmetryPlane::none, "none"},
                                                                            {SymmetryPlane::x, "x"},
                                                                            {SymmetryPlane::y, "y"},
                                                                            {SymmetryPlane::z, "z"}});

// Skins.
template <>
inline constexpr auto enum_words<FrameMode> = all_words<FrameMode>({{FrameMode::automatic, "automatic"},
                                                                    {FrameMode::translate, "translate"},
                                                                    {FrameMode::rotation_minimising, "rmf"},
                                                                    {FrameMode::two_rail, "two-rail"}});
template <>
inline constexpr auto enum_words<SkinMethod> = all_words<SkinMethod>({{SkinMethod::smooth, "smooth"},
                                                                      {SkinMethod::anchored, "anchored"},
                                                                      {SkinMethod::pleat, "pleat"}});
template <>
inline constexpr auto enum_words<Caps> =
    all_words<Caps>({{Caps::none, "none"}, {Caps::flat, "flat"}, {Caps::dome, "dome"}});
template <>
inline constexpr auto enum_words<ColumnParameters> =
    all_words<ColumnParameters>({{ColumnParameters::uniform, "uniform"},
                                 {ColumnParameters::shared, "shared"},
                                 {ColumnParameters::per_section, "per-section"}});
template <>
inline constexpr auto enum_words<Blend> = all_words<Blend>({{Blend::automatic, "automatic"},
                                                            {Blend::linear, "linear"},
                                                            {Blend::natural, "natural"},
                                                            {Blend::hermite, "hermite"}});
template <>
inline constexpr auto enum_words<RowPlacement> = all_words<RowPlacement>({{RowPlacement::even, "even"},
                                                                          {RowPlacement::path, "path"}});
template <>
inline constexpr auto enum_words<SectionFit> = all_words<SectionFit>({{SectionFit::none, "none"},
                                                                      {SectionFit::local, "local"},
                                                                      {SectionFit::fair, "fair"}});
template <>
inline constexpr auto enum_words<MatchCost> = all_words<MatchCost>({{MatchCost::parameter, "parameter"},
                                                                    {MatchCost::shape, "shape"}});
template <>
inline constexpr auto enum_words<StripSide> = all_words<StripSide>({{StripSide::a, "a"},
                                                                    {StripSide::b, "b"}});

// Outlines.
template <>
inline constexpr auto enum_words<GaussMode> = all_words<GaussMode>({{GaussMode::curvature, "curvature"},
                                                                    {GaussMode::umbilic, "umbilic"},
                                                                    {GaussMode::paper, "paper"},
                                                                    {GaussMode::position, "position"}});
/// Word of a mode that does not exist any more; files and command lines with it get `umbilic` and
/// `OutlineSettings::mode_replaced`.
inline constexpr std::string_view replaced_outline_mode = "minkowski";
template <>
inline constexpr auto enum_words<CurvatureSign> =
    all_words<CurvatureSign>({{CurvatureSign::positive, "positive"}, {CurvatureSign::negative, "negative"}});

// Pictures.
template <>
inline constexpr auto enum_words<PictureLayer> = all_words<PictureLayer>({{PictureLayer::space, "space"},
                                                                          {PictureLayer::behind, "behind"},
                                                                          {PictureLayer::front, "front"}});
template <>
inline constexpr auto enum_words<PictureSide> = all_words<PictureSide>({{PictureSide::front, "front"},
                                                                        {PictureSide::back, "back"},
                                                                        {PictureSide::left, "left"},
                                                                        {PictureSide::right, "right"},
                                                                        {PictureSide::top, "top"},
                                                                        {PictureSide::bottom, "bottom"}});

// Dimensions and paper models.
template <>
inline constexpr auto enum_words<DimensionKind> =
    all_words<DimensionKind>({{DimensionKind::distance, "distance"},
                              {DimensionKind::angle, "angle"},
                              {DimensionKind::radius, "radius"}});
template <>
inline constexpr auto enum_words<CutGoal> = all_words<CutGoal>({{CutGoal::fewest, "fewest"},
                                                                {CutGoal::balanced, "balanced"},
                                                                {CutGoal::easiest, "easiest"}});

}  // namespace hariko
