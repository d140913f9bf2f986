#pragma once

// PaperSolid: the paper model in space, between flat pages and the solid, ready to be drawn and pointed at.

#include <memory>

#include "core/unfolding/folding.hpp"
#include "render/display_mesh.hpp"
#include "render/display_polyhedron.hpp"
#include "render/scene.hpp"
#include "ui/editor/paper_state.hpp"

namespace hariko {

struct PaperSolid {
  std::shared_ptr<const PaperLayout> layout;
  double folded = 1;
  std::vector<SpaceCorners> corners;               ///< one for each facet, in the document's space
  std::shared_ptr<const DisplayMesh> mesh;         ///< one patch a facet
  std::shared_ptr<const DisplayPolyhedron> lines;  ///< folds that have a line, and cuts
  Box3 box;
};

/// Solid, the facets lie where the model is; flat, the pages lie beside each other at its foot. O(facets).
std::shared_ptr<const PaperSolid> fold_up(std::shared_ptr<const PaperLayout> layout, double folded);

/// For the scene: white paper with its lines; the facet pointed at and the selected piece stand out.
SceneObject scene_object_of(const PaperSolid& solid, const PaperState& state);

/// The facet that a ray meets first, with the edge that is nearer to it than `reach` (the document's unit).
PaperHover paper_under(const PaperSolid& solid, const Ray& ray, double reach);

}  // namespace hariko
