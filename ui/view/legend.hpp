#pragma once

// Legends over the picture to read it by: of maps, marks, combs and tensions.

#include "ui/editor/scene_builder.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// Name of the window that the legend is.
inline constexpr const char* legend_window = "##legend";

/// At the lower left of a rectangle, about the active object; nothing where nothing needs explaining. A click
/// on an end of a map's range types a value, the mode's name offers the others, a right click resets.
void draw_legend(PanelContext& context, const PanelRect& viewport, const SceneBuilder& scene);

/// A colour of maps as ImGui has colours.
ImU32 to_imgui(const Color& color);

/// A ring where the shown error is the largest, and, where four pictures are compared, what this one shows.
void draw_mesh_overlay(const PanelContext& context, const Camera& camera, PixelSize size,
                       const PanelRect& pane, std::size_t view);

}  // namespace hariko
