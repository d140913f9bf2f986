#pragma once

// Rectilinear grids of inside flags: their topology, the choice of one that has the field's topology, and the
// planes that can be left out (docs/envelope.md, spec 16.4).

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// Nodes at planes along three axes; flags say which are inside.
struct FlagGrid {
  std::array<std::vector<double>, 3> planes;
  std::vector<char> inside;

  std::array<int, 3> size() const {
    return {int(planes[0].size()), int(planes[1].size()), int(planes[2].size())};
  }
  std::size_t index(int i, int j, int k) const {
    return (std::size_t(k) * planes[1].size() + std::size_t(j)) * planes[0].size() + std::size_t(i);
  }
  Vector3 point(int i, int j, int k) const {
    return {planes[0][std::size_t(i)], planes[1][std::size_t(j)], planes[2][std::size_t(k)]};
  }
};

/// Of the cubes and their faces between nodes that are inside.
struct GridTopology {
  int components = 0, tunnels = 0;
  friend bool operator==(const GridTopology&, const GridTopology&) = default;
};

/// Keeps the largest component where it holds nearly all, fills voids, and counts. O(nodes).
GridTopology tidy(FlagGrid& grid);
std::size_t sign_changes(const FlagGrid& grid);

/// Of the sharp field on a grid that is fine enough for the thinnest solid.
struct GridReference {
  GridTopology topology;
  double volume = 0, area = 0;
};

/// In the grid's frame.
struct GridField {
  std::function<double(const Vector3&)> value;
  /// -1 where it is negative in all of a ball, 1 where it is nowhere below `above`, 0 where that would take a
  /// closer look.
  std::function<int(const Vector3& centre, double radius, double above)> side;
};

struct GridRequest {
  GridField field;       ///< with the wanted fillet
  GridField sharp;       ///< with a small one, for the reference
  Vector3 low, high;     ///< box of the solids
  double thickness = 1;  ///< smallest of the solids
  double detail = 1, budget = 400, aspect = 2.5;
  bool few = false;              ///< fewer than four solids: offsets only where they are needed
  std::vector<Vector3> covered;  ///< points that should be inside
};

/// Which grid about the middle of the box, and what counts as inside.
struct GridChoice {
  double cell = 0;     ///< between planes
  int parity = 0;      ///< bits 0 to 2: whether the planes of x, y, z lie half a cell beside the middle
  double offset = 0;   ///< inside is field < offset
  double covered = 1;  ///< share of the points that should be inside and were when it was chosen
};

struct ChosenGrid {
  FlagGrid grid;  ///< planes between equal slices left out
  GridChoice choice;
  GridTopology topology;
};

GridReference grid_reference(const GridRequest& request);

/// The coarsest grid with the topology of the reference, or the best there is. Deterministic.
std::optional<ChosenGrid> choose_grid(const GridRequest& request, const GridReference& reference,
                                      const CancelToken& cancel = {});

/// The grid that was chosen for solids which have moved since; nothing where it has not the topology of the
/// reference any more, or misses points. A small part of the cost of choosing.
std::optional<ChosenGrid> same_grid(const GridRequest& request, const GridReference& reference,
                                    const GridChoice& choice);

}  // namespace hariko
