#pragma once

// What lies over the picture to read it by: legends of maps, marks, combs and tensions, and the tensions'
// numbers.

#include "ui/editor/scene_builder.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// Name of the window that the legend is.
inline constexpr const char* legend_window = "##legend";

/// At the lower left of a rectangle, about the active object; nothing where nothing needs explaining. A click
/// on an end of a map's range types a value, the mode's name offers the others, a right click resets.
void draw_legend(PanelContext& context, const PanelRect& viewport, const SceneBuilder& scene);

/// Tensions beside their elements, on objects that show them: all where they are few, else those that were
/// changed, as many as have room. Into the current window.
void draw_tension_numbers(PanelContext& context, const PanelRect& view, const Camera& camera,
                          const Scene& scene);

/// A colour of maps as ImGui has colours.
ImU32 to_imgui(const Color& color);

}  // namespace hariko
