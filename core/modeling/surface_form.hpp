#pragma once

// SurfaceForm: the surface of a polyhedron before it is refined, and how the refined polyhedron keeps it
// (kuriyama.md section 12.7).

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/modeling/mesh_draft.hpp"
#include "core/modeling/refined_points.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko {

/// New vertices come to lie where the surface has them: on the curve of an edge, on the patches of a face.
/// With frames by measure the vertices whose tangents would change remember them (`KeptForm`), and the pieces
/// of a face count as the face did (`Shaping::kept_area`). What the polyhedron is attached to does not count.
class SurfaceForm {
 public:
  /// Makes the surface of `source`. Errors: those of `surface_input` and `PolyhedronSurfacer::rebuild`.
  static Result<SurfaceForm> of(const PolyhedronSource& source);

  const PolyhedronSource& source() const { return source_; }

  /// Bezier points of an edge's curve from its end with the smaller id, relative to the source's origin; none
  /// for edges that the surface does not have.
  std::optional<std::array<Vector3, 4>> curve(EdgeId edge) const;

  /// Points of the surface on the way from one to the other across a face that has both, relative to the
  /// source's origin; none where no face has both.
  std::vector<Vector3> path(const RefinedPoint& from, const RefinedPoint& to) const;

  /// `after` is a refinement of the source, with new vertices at `places` of the source.
  Result<PolyhedronSource> keep(PolyhedronSource after, const RefinedPoints& places) const;

 private:
  /// A point in the plane chart of a face of the prepared polyhedron.
  struct Spot {
    Index face = no_index;
    Vector2 chart = Vector2::Zero();
  };
  /// All that is known of where a vertex lies.
  struct Sight {
    Index vertex = no_index;      ///< of the prepared polyhedron, where it is one
    std::optional<EdgePoint> on;  ///< an edge that the surface has
    std::vector<Spot> spots;
  };

  SurfaceForm(const PolyhedronSource& source, PolyhedronSurfaceInput input, PolyhedronSurface surface,
              FaceCharts charts);
  Sight sight(VertexId vertex) const;
  Sight sight(const RefinedPoint& place) const;
  std::optional<Spot> spot_in_face(Index face, const Vector3& position) const;
  /// Patch and parameter of a spot.
  std::pair<Index, Vector2> parameter(const Spot& spot) const;
  Vector3 point(const Spot& spot) const;
  std::optional<Vector3> point(const Sight& sight) const;
  /// Bezier tangents of the curve that leads over the surface from one to the other, at both ends.
  std::optional<std::pair<Vector3, Vector3>> tangents(const Sight& a, const Sight& b) const;
  std::optional<std::pair<Vector3, Vector3>> tangents_along_edge(const Sight& a, const Sight& b) const;
  std::vector<Vector3> points_across(const Spot& a, const Spot& b) const;
  std::pair<Vector3, Vector3> tangents_across(const Spot& a, const Spot& b) const;

  /// A face of the refined polyhedron in the chart of the prepared face that it is part of.
  struct ChartedFace {
    Index whole = no_index;
    std::vector<Vector2> corners;
    std::size_t number_of_corner = 0;
  };
  using SightOf = std::function<Sight(VertexId)>;
  /// None where the face is not part of one; `corner`: the vertex whose number is wanted.
  std::optional<ChartedFace> charted(const Polyhedron& after, Index face, Index corner,
                                     const SightOf& sight_of) const;
  /// Derivative of the surface at a corner, in the chart towards the middle of the refined face.
  Vector3 split_direction(const ChartedFace& face) const;
  /// As `WantedSides`: the corner lies between its neighbours.
  static std::optional<std::pair<double, double>> parts_of_side(const ChartedFace& face);

  /// The prepared face in which all corners lie.
  static std::optional<Index> common_face(std::span<const Sight> corners);
  /// Area with which mode FAIR counts a prepared face.
  double counted_area(Index face) const;
  Result<FlatMap<FaceId, double>> kept_areas(const PolyhedronSurfaceInput& after,
                                             const SightOf& sight_of) const;

  PolyhedronSource source_;
  PolyhedronSurfaceInput input_;  ///< the prepared polyhedron
  PolyhedronSurface surface_;
  FaceCharts charts_;
  std::map<FaceId, std::vector<Index>> parts_;  ///< prepared faces by the face that they are part of
};

/// The form that a refinement of `source` keeps: nothing with equal frames, whose surfaces do not follow
/// lengths, and where the polyhedron has no surface yet.
std::optional<SurfaceForm> form_to_keep(const PolyhedronSource& source);

/// Finishes a refinement: on the surface where `on` is given, on straight edges and flat faces else. Errors:
/// those of `MeshDraft::finish` and `SurfaceForm::keep`.
Result<Modeled> finish_refined(MeshDraft&& draft, ElementSet selection, const SurfaceForm* on);

}  // namespace hariko
