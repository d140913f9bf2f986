#pragma once

// SurfaceForm: the surface of a polyhedron before a refinement, and the means by which the refined polyhedron
// keeps it (kuriyama.md section 12.7).

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/modeling/cuts/refined_points.hpp"
#include "core/modeling/mesh_editor.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko {

/// New vertices are put on the surface: on the curve of an edge, or on the patches of a face. With frames by
/// measure, vertices whose tangents would change store the old ones (`KeptForm`), and the pieces of a face
/// are weighted as the face was (`Shaping::kept_area`). Attachments to other objects are ignored.
class SurfaceForm {
 public:
  /// Makes the surface of `source`. Errors: those of `surface_input` and `PolyhedronSurfacer::rebuild`.
  static Result<SurfaceForm> of(const PolyhedronSource& source);

  const PolyhedronSource& source() const { return source_; }

  /// Bezier points of an edge's curve from its end with the smaller id, relative to the source's origin;
  /// nothing for edges that the prepared polyhedron does not have.
  std::optional<std::array<Vector3, 4>> curve(EdgeId edge) const;

  /// Points of the surface on the path from one point to the other across a face that contains both, relative
  /// to the source's origin; empty where no face contains both.
  std::vector<Vector3> path(const RefinedPoint& from, const RefinedPoint& to) const;

  /// Returns `after` with vertices, forms and areas that keep the surface. `after` is a refinement of the
  /// source, with new vertices at `places` of the source. Errors: those of `surface_input` and of
  /// `kept_tangents`.
  Result<PolyhedronSource> keep(PolyhedronSource after, const RefinedPoints& places) const;

 private:
  /// A point in the plane chart of a face of the prepared polyhedron.
  struct Spot {
    Index face = no_index;
    Vector2 chart = Vector2::Zero();
  };
  /// Location of a vertex on the prepared polyhedron: as a vertex, on an edge, in faces.
  struct Sight {
    Index vertex = no_index;      ///< vertex of the prepared polyhedron; no_index if it is none
    std::optional<EdgePoint> on;  ///< edge of the prepared polyhedron
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
  /// Bezier tangents at both ends of the surface curve from one point to the other.
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
  /// Chart of a refined face; nothing where it is not part of a prepared face. `corner`: the vertex whose
  /// number is wanted.
  std::optional<ChartedFace> charted(const Polyhedron& after, Index face, Index corner,
                                     const SightOf& sight_of) const;
  /// Derivative of the surface at a corner, in the direction of the chart towards the middle of the refined
  /// face.
  Vector3 split_direction(const ChartedFace& face) const;
  /// Lengths for `WantedSides` where the corner lies between its neighbours on a straight line; else nothing.
  static std::optional<std::pair<double, double>> parts_of_side(const ChartedFace& face);

  /// Prepared face that contains all corners; nothing if there is none.
  static std::optional<Index> common_face(std::span<const Sight> corners);
  /// Area with which mode FAIR weights a prepared face.
  double counted_area(Index face) const;
  Result<FlatMap<FaceId, double>> kept_areas(const PolyhedronSurfaceInput& after,
                                             const SightOf& sight_of) const;

  PolyhedronSource source_;
  PolyhedronSurfaceInput input_;  ///< the prepared polyhedron
  PolyhedronSurface surface_;
  FaceCharts charts_;
  /// prepared faces by the designer's face that they are part of
  std::map<FaceId, std::vector<Index>> parts_;
};

/// Returns the form that a refinement of `source` keeps. Nothing with equal frames, whose surfaces do not
/// depend on lengths. Errors: those of `SurfaceForm::of`; a refinement without a form is then still possible.
Result<std::optional<SurfaceForm>> form_to_keep(const PolyhedronSource& source);

/// Finishes a refinement: new vertices lie on the surface where `on` is given, else on straight edges and
/// flat faces. Errors: those of `MeshEditor::finish` and `SurfaceForm::keep`.
Result<EditResult> finish_refined(MeshEditor&& draft, ElementSet selection, const SurfaceForm* on);

}  // namespace hariko
