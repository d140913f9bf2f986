#pragma once

// ObjectSurface: the surface of an object of any kind. Objects may be attached to each other: polyhedra whose
// border edges follow patches, and patches that follow polyhedra.

#include <map>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "core/document/document.hpp"
#include "core/envelope/envelope.hpp"
#include "core/modeling/surfacing/surface_input.hpp"
#include "core/patching/cross_boundary_fit.hpp"
#include "core/skinning/evaluate_skin.hpp"

namespace hariko {

inline constexpr Code e_join_lost{"E_JOIN_LOST"};
inline constexpr Code e_join_seam{"E_JOIN_SEAM"};

using ObjectPointers = std::vector<std::shared_ptr<const Object>>;

/// Surface of an object, with its warnings and what the maker of its kind adds.
struct ObjectSurface {
  Surface surface;
  std::vector<Message> warnings;
  /// Report of the solver for polyhedra and outlines, all about the envelope for solids.
  std::variant<std::monostate, SolveReport, std::shared_ptr<const EnvelopeSurface>> details;
  /// Revision, and patches that changed since another one: see `PolyhedronSurface`.
  std::uint64_t revision = 0, base_revision = 0;
  std::shared_ptr<const std::vector<Index>> changed;
  /// Whether frames, target curvatures or automatic tensions are those of the last result at quality `final`.
  bool provisional = false;
};

/// Returns the other objects that an object's surface depends on, in the document's order.
ObjectPointers neighbours_of(const Document& document, ObjectId object);

/// Makes the surface of one object of any kind that has one. Caches intermediate results for the next call;
/// calls must not overlap. A result at quality `final` does not depend on earlier calls.
class ObjectSurfacer {
 public:
  ObjectSurfacer();
  ~ObjectSurfacer();

  /// Returns the surface of `object`. `neighbours`: the result of `neighbours_of`. Errors: those of
  /// `surface_input` and of `PolyhedronSurfacer::rebuild`, E_JOIN_LOST (the patch side that an edge is
  /// attached to no longer exists), E_JOIN_SEAM (an attached edge lies inside the mirrored whole),
  /// E_ATTACHMENT_CYCLE; for Bezier patches those of `weld_patches`, for solids those of
  /// `EnvelopeSurfacer::rebuild`, for skins those of `SkinSurfacer::surface`, for outlines those of
  /// `control_points` and `outline_polyhedron`. Warnings of patches: W_JOIN_REFUSED, W_JOIN_KINK.
  Result<ObjectSurface> surface(const Object& object, const ObjectPointers& neighbours, Quality quality,
                                const CancelToken& cancel = {});
  /// Progress of the slow part of the work, the placing of the columns of skins. Safe to read from any
  /// thread.
  const Progress& progress() const { return progress_; }

 private:
  struct Adapted;
  struct Helper;
  class Call;
  PolyhedronSurfacer surfacer_;
  SurfaceInputCache cache_;
  std::map<ObjectId, std::unique_ptr<Helper>> helpers_;  ///< polyhedra that patches adapt to
  ObjectSurface whole(Surface surface, std::vector<Message> warnings = {});
  Result<ObjectSurface> over(const PolyhedronSurfaceInput& input, Quality quality, const CancelToken& cancel);
  Result<ObjectSurface> around(const SolidsSource& source, Quality quality, const CancelToken& cancel);
  Result<ObjectSurface> over(const SkinSource& source, Quality quality, const CancelToken& cancel);
  Result<ObjectSurface> inside(const OutlineSource& source, Quality quality, const CancelToken& cancel);

  EnvelopeSurfacer enveloper_;
  SkinSurfacer skinner_;
  const Progress progress_ = Progress::make();
  std::uint64_t revision_ = 0;  ///< number of the last surface that `whole` made
};

/// Returns the surface of an object of a document at quality `final`. Errors: those of
/// `ObjectSurfacer::surface`.
Result<ObjectSurface> object_surface(const Document& document, const Object& object,
                                     const CancelToken& cancel = {});

}  // namespace hariko
