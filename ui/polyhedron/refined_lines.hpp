#pragma once

// RefinedLines: where the new points and lines of a refinement will lie, before it is made.

#include <optional>
#include <vector>

#include "core/modeling/cuts/cut.hpp"
#include "ui/editor/operations.hpp"
#include "ui/view/tool.hpp"

namespace hariko {

/// On the surface, which is made once for each object, or on straight edges and across flat faces. All places
/// are in the document's space.
class RefinedLines {
 public:
  /// False: on straight edges, whatever the surface is.
  bool on_surface = true;

  /// The form that a refinement of a polyhedron keeps; null where new points lie on straight edges.
  const SurfaceForm* form_of(const Editor& editor, const Object& object);
  /// The same, but null for polyhedra whose surface takes longer than a frame.
  const SurfaceForm* quick_form_of(const Editor& editor, const Object& object);
  /// Reason why `form_of` last gave no form that should be kept; nothing where it gave one or none is kept.
  std::optional<Message> lost_form() const { return on_surface ? form_.lost : std::nullopt; }

  /// A point of an existing vertex or edge of the object.
  Vector3 point(const Editor& editor, const Object& object, const CutPoint& point);
  /// The line between two points of a common face.
  std::vector<Vector3> line(const Editor& editor, const Object& object, const CutPoint& from,
                            const CutPoint& to);

 private:
  FormToKeep form_;
  const Object* formed_ = nullptr;  ///< object that `form_` was made for
};

/// The share of an edge, from its end with the smaller id, at which its curve is seen on the straight line of
/// the screen between two places; the crossing nearest to `share` counts, which is the result where there is
/// none, or no curve is shown for the edge.
double share_seen_between(const ToolContext& context, ObjectId object, const EdgePoint& share,
                          const Vector3& from, const Vector3& to);

}  // namespace hariko
