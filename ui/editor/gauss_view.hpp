#pragma once

// GaussView: the Gauss sphere of the active outline as the window has it, beside the views of the model.

#include <memory>
#include <optional>

#include "core/document/document.hpp"

namespace hariko {

struct GaussSphere;

struct GaussView {
  bool shown = false;
  bool cells = true, triangles = true;  ///< drawn
  std::optional<Index> step;            ///< so many sites are inserted; empty: all
  /// The sphere of an outline and a step, made by the application; null until there is one.
  std::shared_ptr<const GaussSphere> sphere;
  std::shared_ptr<const Object> object;  ///< object that it was made of
  std::optional<Index> made_step;
  std::optional<Index> hovered, selected;  ///< sites

  /// The site that was inserted last, while some are left out.
  std::optional<Index> newest() const;
  /// Whether a site of the sphere is known.
  bool has(std::optional<Index> site) const;
  void forget() {
    sphere.reset();
    object.reset();
    made_step.reset();
    hovered.reset();
    selected.reset();
  }
};

}  // namespace hariko
