#include "ui/view/skin_sight.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "ui/editor/scene_builder.hpp"

namespace hariko {

namespace {

using Kind = SkinView::Handle::Kind;

/// Places on the surface next to points of sections that it may miss.
std::map<std::uint32_t, Vector3> places_on_surface(const Editor& editor, const Object& object) {
  std::map<std::uint32_t, Vector3> out;
  const Surface* surface = shown_surface(editor, object);
  const SubdivisionPatchSet* patches = surface ? subdivision_patches(*surface) : nullptr;
  if (!patches || !patches->skin() || patches->skin()->skin.method != SkinMethod::pleat) return out;
  const SkinResult& result = *patches->skin();
  for (std::size_t k = 0; k < result.mesh.section_rows.size(); ++k) {
    const auto& points = result.skin.sections[k].points;
    for (std::size_t i = 0; i < points.size(); ++i)
      out[points[i].id] = patches->limit_position(result.mesh.section_rows[k][i]) + surface->origin();
  }
  return out;
}

}  // namespace

SkinSight::SkinSight(const Editor& editor, const Projector& projector, const SkinView& view,
                     const Object& object)
    : view_(view),
      object_(object),
      through_(editor.view.x_ray || editor.selecting.through),
      occlusion_(shown_surfaces(editor), section_plane(editor.view), projector, 4 * editor.pixel_scale),
      hidden_(view.handles.size(), 0) {
  // Points may lie below the surface that they shape: they can be seen where the curve or the surface that
  // belongs to them can.
  std::map<std::uint32_t, bool> covered;
  for (const auto& [id, place] : places_on_surface(editor, object)) covered[id] = hides(place);
  for (const SkinView::Handle& handle : view.handles)
    if (handle.kind == Kind::limit)
      if (const auto place = covered.try_emplace(handle.id, true).first; place->second)
        place->second = hides(handle.position);
  for (std::size_t i = 0; i < hidden_.size(); ++i) {
    const SkinView::Handle& handle = view.handles[i];
    if (handle.kind != Kind::limit && handle.kind != Kind::control) continue;
    const auto place = covered.find(handle.id);
    hidden_[i] = (place == covered.end() || place->second) && hides(handle.position);
  }
}

bool SkinSight::hides(const Vector3& point) const {
  return occlusion_.hides(object_.transform.apply(point));
}

std::set<std::uint32_t> SkinSight::hidden_points() const {
  std::set<std::uint32_t> out;
  if (through_) return out;
  for (std::size_t i = 0; i < hidden_.size(); ++i)
    if (hidden_[i]) out.insert(view_.handles[i].id);
  // Two marks are shown of a point, and either will do.
  for (std::size_t i = 0; i < hidden_.size(); ++i)
    if (!hidden_[i] && (view_.handles[i].kind == Kind::limit || view_.handles[i].kind == Kind::control))
      out.erase(view_.handles[i].id);
  return out;
}

SkinHit SkinSight::hit(const Projector& projector, const Vector2& pixel, double pixel_scale) const {
  if (through_) return skin_hit(view_, object_, projector, pixel, pixel_scale);
  SkinView seen;
  std::vector<std::size_t> handles, diamonds;
  for (std::size_t i = 0; i < view_.handles.size(); ++i)
    if (!hides_handle(i)) seen.handles.push_back(view_.handles[i]), handles.push_back(i);
  for (std::size_t i = 0; i < view_.diamonds.size(); ++i)
    if (!hides(view_.diamonds[i].position)) seen.diamonds.push_back(view_.diamonds[i]), diamonds.push_back(i);
  SkinHit out = skin_hit(seen, object_, projector, pixel, pixel_scale);
  if (out.kind == SkinHit::Kind::handle) out.index = handles[out.index];
  if (out.kind == SkinHit::Kind::diamond) out.index = diamonds[out.index];
  return out;
}

void HandleSight::look(const Editor& editor) {
  if (editor.view.x_ray || editor.selecting.through) return view_.reset();
  std::vector<SceneObject> surfaces = shown_surfaces(editor);
  const auto section = section_plane(editor.view);
  const auto same = [](const SceneObject& a, const SceneObject& b) {
    return a.mesh == b.mesh && a.transform == b.transform;
  };
  if (view_ && view_->camera == editor.camera() && view_->viewport == editor.viewport &&
      view_->section == section && std::ranges::equal(view_->surfaces, surfaces, same))
    return;
  SurfaceOcclusion occlusion(surfaces, section, Projector(editor.camera(), editor.viewport),
                             4 * editor.pixel_scale);
  view_.emplace(View{editor.camera(), editor.viewport, section, std::move(surfaces), std::move(occlusion)});
}

std::vector<SceneObject> shown_surfaces(const Editor& editor) {
  std::vector<SceneObject> out;
  for (const auto& object : editor.document().objects) {
    const SurfaceView* shown = editor.view_of(object->id);
    // A surface that is not that of the present document must not keep it from being mended.
    if (!object->visible || !object->display.surface || !object->has_surface() || !shown || !shown->mesh ||
        shown->error)
      continue;
    for (const Similarity& place : places_of(*object)) {
      SceneObject& surface = out.emplace_back();
      surface.mesh = shown->mesh;
      surface.transform = matrix_of(place);
    }
  }
  return out;
}

}  // namespace hariko
