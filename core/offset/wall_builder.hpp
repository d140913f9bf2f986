#pragma once

// WallBuilder: the topology of offset surfaces and shells. Internal to this folder.

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/offset/wall_patch_set.hpp"

namespace hariko {

/// Patches, seams and counts of an offset (one layer) or a shell (two layers, the outer one first).
class WallBuilder {
 public:
  WallBuilder(std::shared_ptr<const BaseNormals> normals, std::vector<double> layers);

  /// Makes the surface. Nothing where a sharp edge has opposite normals.
  std::optional<Surface> build();

  std::size_t sharp_edges() const { return sharp_edges_; }
  std::size_t crossings() const { return crossings_; }
  std::size_t gaps() const { return gaps_; }
  std::size_t tips() const { return tips_; }

 private:
  /// Square patch, in triangles two halves of one, or a patch of the base's own domain.
  struct Cell {
    Index patch = no_index;
    bool flipped = false, own_domain = false;
  };
  /// Part of a side of a cell before it is flipped.
  struct CellPart {
    Cell cell;
    int side = 0;
    double begin = 0, end = 1;
  };
  /// Turn of the normal at an end of a sharp edge, from one group of corners to another, with the cell and
  /// the side in each layer that have it.
  struct Turn {
    Index from = no_index, to = no_index;
    Vector3 position = Vector3::Zero();
    Provenance source;
    std::vector<std::optional<Cell>> cells;  ///< by layer; nothing at distance 0
    int side = 0;
    bool closed = false;
  };
  /// Beginning (side 1) or end (side 3) of a strip along the border.
  struct Port {
    std::optional<Cell> side_1, side_3;
  };

  Cell add(const WallPatch& patch, const Provenance& source, bool flipped, bool own_domain);
  Cell face(std::size_t layer, Index patch) const;
  PatchSide placed(const CellPart& part, double& begin, double& end) const;
  void join(const CellPart& a, const CellPart& b, Continuity continuity, const Element& source = {});
  void add_faces();
  bool add_base_seam(Index seam);
  bool add_join(Index seam);
  std::optional<Index> group_at(const PatchSide& side, double x) const;
  void close_turns();
  void add_fans(std::span<const Index> turns);
  void add_rims();
  void add_rim(const PatchSide& side, double begin, double end);
  void add_ends();
  void join_ports();
  void take_port(std::optional<Index> group, const Cell& cell, int side);
  void count_tips();
  Surface surface() const;

  std::shared_ptr<const BaseNormals> normals_;
  const Surface& base_;
  std::vector<double> layers_;
  bool triangles_;
  int corners_;
  std::vector<WallPatch> patches_;
  std::vector<Provenance> provenance_;
  std::vector<Seam> seams_;
  std::vector<Turn> turns_;
  std::map<Index, Port> ports_;
  std::size_t sharp_edges_ = 0, crossings_ = 0, gaps_ = 0, tips_ = 0;
};

}  // namespace hariko
