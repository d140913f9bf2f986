#pragma once

// PaperModel: what the designer decided about a paper model of the document: settings, which edges fold, what
// was chosen by hand, and where pieces lie. Coordinates, tabs, numbers and pages follow from it and from the
// model (core/unfolding/paper_document.hpp).

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/ids.hpp"
#include "core/document/paper_settings.hpp"
#include "core/document/source.hpp"

namespace hariko {

/// A corner of facets by what it is on the model, so that it is found again when the model has changed.
struct PaperVertex {
  ObjectId object;
  Element element;  ///< that the patch comes from; a vertex itself; none: a vertex of a reference mesh
  /// Of the element, as in `Provenance`, plus 65536 for its image in a live mirror; the number of the mesh's
  /// vertex.
  std::uint32_t side = 0;
  double u = 0, v = 0;  ///< on the patch

  friend bool operator==(const PaperVertex&, const PaperVertex&) = default;
  friend bool operator<(const PaperVertex& a, const PaperVertex& b);
};

/// Numbers of `PaperModel::vertices`, the lower first unless said otherwise.
using PaperEdge = std::array<std::uint32_t, 2>;

/// As `PiecePlacement`: a point p of the frame lies at R(angle) p + (x, y) on the page.
struct PaperPlace {
  std::uint32_t page = 0;
  double angle = 0, x = 0, y = 0;  ///< radians, mm
  friend bool operator==(const PaperPlace&, const PaperPlace&) = default;
};

/// What is preferred of layouts.
enum class CutGoal : std::uint8_t {
  fewest,    ///< pieces
  balanced,  ///< pieces + pages + 0.05 strips
  easiest    ///< to glue: few slits, so few strips
};

/// Invariants (checked by the file reader): vertices ascend; all numbers name vertices; lists of edges
/// ascend.
struct PaperModel {
  std::vector<ObjectId> objects;  ///< that it is made of, ascending; they need not exist
  bool of_polyhedra = false;      ///< the faces of polyhedra are the facets, not their surfaces
  double distance = 0;            ///< largest between surface and facets, the document's unit
  double normal_angle = 0;        ///< largest between their normals, radians; 0: any
  PaperSettings settings;         ///< `scale` for the document's unit
  CutGoal goal = CutGoal::fewest;
  std::uint64_t steps = 300'000;  ///< of the search for cuts

  std::vector<PaperVertex> vertices;
  std::vector<PaperEdge> folds, cuts;          ///< all of them, but for borders
  std::vector<PaperEdge> own_folds, own_cuts;  ///< those the designer chose
  std::vector<PaperEdge> tabs;    ///< chosen sides: of the facet that has the edge in this direction
  std::vector<PaperEdge> strips;  ///< chosen instead of tabs

  /// Where a facet lies whose first corner is the origin of its frame and whose second is on its x axis. The
  /// piece with the facet lies so; where it has several of these facets, the first one counts.
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

  /// Cuts were chosen; otherwise there are settings only.
  bool unfolded() const { return !vertices.empty(); }
  friend bool operator==(const PaperModel&, const PaperModel&) = default;
};

}  // namespace hariko
