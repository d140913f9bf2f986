#pragma once

// What `hariko render` draws, as pictures or lines. Internal to app/commands.

#include <optional>
#include <vector>

#include "app/commands/commands.hpp"
#include "core/document/document.hpp"

namespace hariko {

struct ShownObject {
  SceneObject part;
  Surface surface;
};

/// The visible objects, surfaces and reference facets; reports what is wrong and gives nothing when one
/// cannot be made, or there is none.
std::optional<std::vector<ShownObject>> shown_objects_or_report(const Document& document,
                                                                const RenderArguments& arguments);

}  // namespace hariko
