#pragma once

// WorkingPlane: the plane in which tools draw and place. Part of the interface, not of the document.

#include <optional>

#include "core/modeling/objects/plane_frame.hpp"

namespace hariko {

class Editor;

struct WorkingPlane {
  enum class Kind { ground, view, face, points, section };
  Kind kind = Kind::ground;
  PlaneFrame frame;  ///< frame of the ground: the axes of the document

  bool is_ground() const { return kind == Kind::ground; }
  friend bool operator==(const WorkingPlane&, const WorkingPlane&) = default;
};

/// Its name, in English: "Ground", "Three points".
const char* plane_name(WorkingPlane::Kind kind);

/// Plane that faces the viewer of the active view, through the middle of what is selected, else through the
/// view's target.
WorkingPlane plane_of_view(const Editor& editor);
/// Plane of the selected face of a polyhedron or a net of patches; nothing unless one is selected, and has an
/// area.
std::optional<WorkingPlane> plane_of_selected_face(const Editor& editor);
/// Plane through the three selected points: the first that was selected is its zero, the last one gives the
/// side of positive y. Nothing unless three are selected that span a plane.
std::optional<WorkingPlane> plane_of_selected_points(const Editor& editor);
/// Plane of the section of which points are selected; nothing unless they are of one.
std::optional<WorkingPlane> plane_of_selected_section(const Editor& editor);

}  // namespace hariko
