#pragma once

// PaperModel: the designer's choices for a paper model of the document: settings, fold and cut edges, edges
// chosen by hand, and places of pieces. Coordinates, tabs, numbers and pages are derived from it and from the
// objects (core/unfolding/paper_document.hpp).

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/ids.hpp"
#include "core/document/paper_settings.hpp"
#include "core/document/source.hpp"

namespace hariko {

/// Corner of facets, identified by its place on the model, so that it is found again when the model has
/// changed.
struct PaperVertex {
  ObjectId object;
  /// Element that the patch comes from, or the vertex itself; none: a vertex of a reference mesh.
  Element element;
  /// Side of the element, as in `Provenance`, plus 65536 for its image in a live mirror; for a reference mesh
  /// the index of the vertex.
  std::uint32_t side = 0;
  /// Parameters on the patch; at the further places of live copies u is two larger from place to place, and
  /// indices of reference meshes go on.
  double u = 0, v = 0;

  friend bool operator==(const PaperVertex&, const PaperVertex&) = default;
  friend bool operator<(const PaperVertex& a, const PaperVertex& b);
};

/// Edge by indices into `PaperModel::vertices`, the lower first unless stated otherwise.
using PaperEdge = std::array<std::uint32_t, 2>;

/// Placement as in `PiecePlacement`: a point p of the frame lies at R(angle) p + (x, y) on the page.
struct PaperPlace {
  std::uint32_t page = 0;
  double angle = 0, x = 0, y = 0;  ///< radians, mm
  friend bool operator==(const PaperPlace&, const PaperPlace&) = default;
};

/// Preferred property of the cuts.
enum class CutGoal : std::uint8_t {
  fewest,    ///< fewest pieces
  balanced,  ///< least pieces + pages + 0.05 strips
  easiest    ///< easiest to glue: few slits, so few strips
};

/// Paper model. Invariants (checked by the file reader): vertices ascend; all indices refer to vertices;
/// lists of edges ascend.
struct PaperModel {
  std::vector<ObjectId> objects;  ///< unfolded objects, ascending; they need not exist
  bool of_polyhedra = false;      ///< facets are the faces of polyhedra instead of their surfaces
  double distance = 0;            ///< largest distance between surface and facets, in the document's unit
  double normal_angle = 0;        ///< largest angle between their normals, radians; 0: unlimited
  PaperSettings settings;         ///< `scale` for the document's unit
  CutGoal goal = CutGoal::fewest;
  std::uint64_t steps = 300'000;  ///< number of steps of the search for cuts

  std::vector<PaperVertex> vertices;
  std::vector<PaperEdge> folds, cuts;          ///< all folds and cuts, except borders
  std::vector<PaperEdge> own_folds, own_cuts;  ///< folds and cuts chosen by the designer
  std::vector<PaperEdge> tabs;  ///< sides chosen for tabs: that of the facet with the edge in this direction
  std::vector<PaperEdge> strips;  ///< edges chosen to have strips instead of tabs

  /// Place of a facet whose first corner is the origin of its frame and whose second is on its x axis. It
  /// determines the place of its piece; where a piece has several of these facets, the first one counts.
  struct FacetPlace {
    std::array<std::uint32_t, 3> facet{};
    PaperPlace place;
    friend bool operator==(const FacetPlace&, const FacetPlace&) = default;
  };
  struct StripPlace {
    PaperEdge edge{};
    PaperPlace place;
    friend bool operator==(const StripPlace&, const StripPlace&) = default;
  };
  std::vector<FacetPlace> places;
  std::vector<StripPlace> strip_places;
  KeptMembers kept;

  /// Whether cuts were chosen; otherwise there are only settings.
  bool unfolded() const { return !vertices.empty(); }
  friend bool operator==(const PaperModel&, const PaperModel&) = default;
};

}  // namespace hariko
