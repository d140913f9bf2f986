#pragma once

// SurfaceBuilder: surface of an object with the data that its display needs.

#include <memory>

#include "app/engines/rebuild_engine.hpp"
#include "core/modeling/surfacing/object_surfacer.hpp"
#include "render/surface_maps.hpp"

namespace hariko {

/// Builds the views of one object and caches what the next one can reuse.
class SurfaceBuilder final : public ViewBuilder {
 public:
  SurfaceView build(const std::shared_ptr<const Object>& object, const ObjectPointers& neighbours,
                    const MapSurroundings& surroundings, Quality quality, const CancelToken& cancel) override;
  ContinuityReport measure(const Surface& surface, const CancelToken& cancel) override;
  double progress() const override { return surfacer_.progress().fraction(); }

 private:
  Result<ObjectSurface> surface_of(const Object& object, const ObjectPointers& neighbours, Quality quality,
                                   const CancelToken& cancel);

  MapPlace place_of(const Object& object, const MapSurroundings& surroundings);
  void take_mesh(const Object& object, const MapSurroundings& surroundings, bool fresh, SurfaceView& view,
                 const CancelToken& cancel);
  void take_range(const Object& object, double limit, SurfaceView& view);

  ObjectSurfacer surfacer_;
  std::shared_ptr<const Object> made_from_;  ///< object from which last_ was made
  ObjectPointers made_beside_;               ///< its neighbours then
  ObjectSurface last_;
  std::optional<double> sticks_out_;  ///< protrusion of last_; the rest of an envelope is not kept
  Quality last_quality_ = Quality::drag;
  std::shared_ptr<const DisplayMesh> base_mesh_;  ///< mesh of the whole surface, for revision base_revision_
  std::uint64_t base_revision_ = 0, facet_revision_ = 0;
  std::shared_ptr<const CombLines> combs_;  ///< combs of last_
  SurfaceMap map_ = SurfaceMap::shaded;
  MapSurroundings surroundings_;  ///< those of `base_mesh_`
  bool rough_ = false;            ///< whether the values of `base_mesh_` are those of a gesture
  std::optional<Message> map_error_;
  std::shared_ptr<const DeviationReference> reference_;  ///< made for `surroundings_`; null where unused
  MapRange range_settings_;
  ValueRange range_;
  std::vector<float> histogram_;
};

}  // namespace hariko
