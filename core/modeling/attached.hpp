#pragma once

// Surfaces of objects that are attached to each other: polyhedra whose border edges follow patches, and
// patches that follow polyhedra.

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "core/document/document.hpp"
#include "core/envelope/envelope.hpp"
#include "core/modeling/surface_input.hpp"
#include "core/patching/adapted_net.hpp"
#include "core/skinning/evaluate_skin.hpp"

namespace hariko {

inline constexpr Code e_join_lost{"E_JOIN_LOST"};
inline constexpr Code e_join_seam{"E_JOIN_SEAM"};

using ObjectPointers = std::vector<std::shared_ptr<const Object>>;

/// The other objects that an object's surface depends on, in the document's order.
ObjectPointers neighbours_of(const Document& document, ObjectId object);

/// Makes the surface of one object of any kind that has one. Keeps what helps next time; calls must
/// not overlap. A `final` result does not depend on earlier calls.
class ObjectSurfacer {
 public:
  ObjectSurfacer();
  ~ObjectSurfacer();

  /// `neighbours`: as `neighbours_of` gives them. Errors: those of `surface_input` and of
  /// `PolyhedronSurfacer::rebuild`, E_JOIN_LOST (what an edge is attached to is gone), E_JOIN_SEAM (an
  /// attached edge is inside of the mirrored whole), E_ATTACHMENT_CYCLE; of Bezier patches those of
  /// `weld_patches`, of solids those of `EnvelopeSurfacer::rebuild`, of skins those of
  /// `SkinSurfacer::surface`, of outlines those of `control_points` and `outline_polyhedron`. Warnings of
  /// patches: W_JOIN_REFUSED.
  Result<PolyhedronSurface> surface(const Object& object, const ObjectPointers& neighbours, Quality quality,
                                    const CancelToken& cancel = {});
  /// Of the part of the work that takes long: placing the columns of skins. For any thread.
  const Progress& progress() const { return progress_; }

 private:
  struct Adapted;
  struct Helper;
  class Call;
  PolyhedronSurfacer surfacer_;
  SurfaceInputCache cache_;
  std::map<ObjectId, std::unique_ptr<Helper>> helpers_;  ///< polyhedra that patches adapt to
  PolyhedronSurface whole(Surface surface, std::vector<Message> warnings);
  Result<PolyhedronSurface> around(const SolidsSource& source, Quality quality, const CancelToken& cancel);
  Result<PolyhedronSurface> over(const SkinSource& source, Quality quality, const CancelToken& cancel);
  Result<PolyhedronSurface> inside(const OutlineSource& source, Quality quality, const CancelToken& cancel);

  EnvelopeSurfacer enveloper_;
  SkinSurfacer skinner_;
  const Progress progress_ = Progress::make();
  std::uint64_t patch_revision_ = 0;
};

/// The surface of an object of a document at quality `final`.
Result<PolyhedronSurface> object_surface(const Document& document, const Object& object,
                                         const CancelToken& cancel = {});

}  // namespace hariko
