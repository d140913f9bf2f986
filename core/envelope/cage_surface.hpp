#pragma once

// The fair quartic surface over a cage, with the cage pushed out until the surface contains the solids
// (docs/envelope.md, spec 11b and 16.7).

#include <optional>
#include <span>

#include "core/envelope/cage_mirror.hpp"
#include "core/envelope/enclosure_check.hpp"
#include "core/envelope/solid_distance.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko {

/// Of the edge between two vertices: above 1 its curve bends more, below it is straighter.
struct CageFullness {
  Index from = 0, to = 0;
  double factor = 1;
};

struct CageSurfaceRequest {
  PolygonMesh cage;          ///< positions relative to `origin`
  std::vector<double> cell;  ///< one a vertex: it moves by at most so much, two and a half times as far for
                             ///< what only the independent check finds
  Vector3 origin = Vector3::Zero();
  double diagonal = 1;
  std::span<const SolidDistance> distances;  ///< of the solids, relative to `origin`
  std::span<const PlacedSolid> placed;       ///< their test points
  std::vector<CageFullness> fullness = {};   ///< what has none of them is left as it is
  std::optional<CageMirror> mirror = {};     ///< the cage is its own image in it, and stays so
  double tolerance = 1e-4;                   ///< of the diagonal
  int rounds = 14;                           ///< of pushing by the loop's own test
  bool strict = true;                        ///< then by the independent check
};

struct CageSurface {
  PolyhedronSurface made;
  Polyhedron cage;
  Shaping shaping;                       ///< tensions of the cage's edges
  double worst = 0;                      ///< of the loop's own test, length
  std::optional<EnclosureReport> check;  ///< the independent one
  std::size_t folds = 0;                 ///< patches that turn over
  int rounds = 0;
  /// Or runs into itself, as far as the independent check has looked.
  bool is_folded() const { return folds > 0 || (check && check->covered > 0); }
};

/// Tensions of edges by their lengths: short edges are tense, so that uneven cages do not fold.
Shaping length_tensions(const Polyhedron& cage);

/// Errors: those of `Polyhedron::build` and `PolyhedronSurfacer::rebuild`.
Result<CageSurface> cage_surface(const CageSurfaceRequest& request, const CancelToken& cancel = {});

}  // namespace hariko
