#pragma once

// Objects that `hariko render` draws, as pictures or lines. Internal to app/commands.

#include <optional>
#include <vector>

#include "app/commands/commands.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// Object of a picture, with its surface.
struct ShownObject {
  SceneObject part;
  Surface surface;
};

/// Visible surfaces and reference facets; reports errors and returns nothing where one cannot be made, or
/// there is none.
std::optional<std::vector<ShownObject>> shown_objects_or_report(const Document& document,
                                                                const RenderArguments& arguments);

}  // namespace hariko
