#pragma once

// SceneBuilder: from the editor's state to what the renderer draws. Keeps what did not change between frames.

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "ui/editor/editor.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/paper_solid.hpp"

namespace hariko {

/// The common colours of the view's map, in the units of the world.
struct ViewScale {
  SurfaceMap map = SurfaceMap::shaded;
  ValueRange range;
  std::vector<float> histogram;
};

class SceneBuilder {
 public:
  /// Describes the present state.
  void update(const Editor& editor);
  const Scene& scene() const { return scene_; }
  /// Scene that a view shows: the same in all, unless meshes are compared.
  const Scene& scene_of(int view) const {
    return compared_.empty() ? scene_ : compared_[static_cast<std::size_t>(view)];
  }
  ObjectId object_id(std::size_t scene_object) const { return ids_[scene_object]; }
  /// Range of a view's map with values, where a surface shows it; null else.
  const ViewScale* view_scale() const { return view_scale_ ? &*view_scale_ : nullptr; }
  /// The paper that is shown instead of the objects; null when they are shown.
  const PaperSolid* paper() const { return paper_.get(); }
  /// Rises whenever the picture would be another one.
  std::uint64_t version() const { return version_; }

 private:
  struct Entry {
    std::shared_ptr<const Object> object;
    ObjectLines lines;
    std::shared_ptr<const EdgeCurves> edge_curves;
    std::shared_ptr<const HalfEdgeMesh> curves_topology;  ///< mesh that the curves of edges were found for
    std::shared_ptr<const EdgeMarks> marks;
    std::shared_ptr<const DisplayMesh::Curves> marked_curves;  ///< curves that the marks were made from
    std::shared_ptr<const ContinuityReport> marked_report;
    ContinuityTolerance marked_tolerance;
  };
  std::shared_ptr<const EdgeMarks> marks_of(ObjectId id, const SurfaceView& view,
                                            const ContinuityTolerance& tolerance);
  /// Edges of a polyhedron on its surface; null of other kinds.
  std::shared_ptr<const EdgeCurves> edge_curves_of(const Object& object, const DisplayMesh& mesh,
                                                   const DisplayPolyhedron& polyhedron);
  void colour_by_view(const Editor& editor, Scene& scene);
  void add_copies(const Document& document, bool whole, Scene& scene);
  SceneObject describe(const Editor& editor, const std::shared_ptr<const Object>& object);
  void describe_surface(const Editor& editor, const Object& object, const SurfaceView& view,
                        SceneObject& out);
  std::shared_ptr<const DisplayPolyhedron> lines_of(const Document& document,
                                                    const std::shared_ptr<const Object>& object);

  void compare(const Editor& editor);
  void fold_paper(const PaperState& paper);

  Scene scene_;
  std::vector<Scene> compared_;  ///< one a view, or none
  std::shared_ptr<const PaperSolid> paper_;
  std::optional<ViewScale> view_scale_;
  std::vector<std::shared_ptr<const DisplayMesh>> scaled_meshes_;  ///< meshes `view_scale_` was measured on
  MapRange scaled_settings_;
  double scaled_limit_ = 0;
  std::vector<ObjectId> ids_;
  std::map<ObjectId, Entry> entries_;
  std::uint64_t version_ = 0;
};

/// Behind the model.
Background background_of(ThemeId theme);

/// The section plane of a view, or nothing when it is off.
std::optional<SectionPlane> section_plane(const ViewSettings& view);

/// The element that a hit on the scene means; of kind none where the object does not have it (any more).
ElementRef element_at(const Document& document, ObjectId object, Element::Kind kind, Index index);

}  // namespace hariko
