#pragma once

// Subject of the legend of a map: the active object's own map, or the view's on all surfaces.

#include <optional>
#include <vector>

#include "ui/editor/editor.hpp"
#include "ui/editor/scene_builder.hpp"

namespace hariko {

struct LegendSource {
  SurfaceMap map = SurfaceMap::shaded;
  ValueRange range;
  const std::vector<float>* histogram = nullptr;  ///< as long as scene and editor stay as they are
  bool of_view = false;                           ///< the view's: its range is no part of the document
};

/// The legend of a map with values that shows; nothing else.
std::optional<LegendSource> legend_source(const Editor& editor, const SceneBuilder& scene);
/// How the range is found.
const MapRange& range_settings(const Editor& editor, const LegendSource& source);
/// Sets that, in the view or as a step of the document.
void set_range(Editor& editor, const LegendSource& source, const MapRange& range);

}  // namespace hariko
