#pragma once

// Subject of the legend of a map: the active object's own map, or the view's on all surfaces.

#include <optional>
#include <string>
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
/// Reason why an object that should show a map of making has no values.
struct MissingMap {
  std::string object;               ///< its name; empty for the active object
  const Message* reason = nullptr;  ///< as long as the editor's views stay as they are
};
/// The map of the active object, else of the first other one that is not the reference of deviations.
std::optional<MissingMap> missing_map(const Editor& editor);

/// Settings that the range is found by.
const MapRange& range_settings(const Editor& editor, const LegendSource& source);
/// Sets that, in the view or as a step of the document.
void set_range(Editor& editor, const LegendSource& source, const MapRange& range);

}  // namespace hariko
