#include "ui/editor/reference_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hariko {

namespace {

/// Pairs that name the same side.
constexpr std::array sides_and_views{
    std::pair{PictureSide::front, StandardView::front}, std::pair{PictureSide::right, StandardView::right},
    std::pair{PictureSide::left, StandardView::left},   std::pair{PictureSide::back, StandardView::back},
    std::pair{PictureSide::top, StandardView::top},     std::pair{PictureSide::bottom, StandardView::bottom}};

ScenePicture scene_picture(const Editor& editor, const Object& object) {
  const PictureSource& source = *object.picture();
  ScenePicture out;
  out.transform = matrix_of(object.transform);
  out.half = {source.width / 2, source.height() / 2};
  out.look = source.look;
  if (const ReferenceView* view = editor.references.of(object.id)) {
    out.image = view->image;
    out.missing = view->error.has_value();
  }
  if (editor.mode != ElementMode::object) return out;
  const ElementRef whole{object.id, element_of(object.id)};
  out.selected = editor.selection.contains(whole);
  out.hovered = editor.hovered == whole;
  return out;
}

/// The side that faces the eye most; of equal ones the first of the list above.
PictureSide nearest_side(const Camera& camera) {
  PictureSide best = PictureSide::front;
  double most = -2;
  for (const auto& [side, view] : sides_and_views) {
    const double squareness = -camera.forward().dot(facing(side) * Vector3::UnitZ());
    if (squareness < most + 1e-6) continue;
    most = squareness;
    best = side;
  }
  return best;
}

/// Rounded down to two digits: a width that is easy to say.
double round_length(double length) {
  const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1);
  return std::max(1.0, std::floor(length / unit)) * unit;
}

}  // namespace

std::vector<ScenePicture> scene_pictures(const Editor& editor) {
  std::vector<ScenePicture> out;
  if (editor.view.surfaces_only) return out;
  for (const auto& object : editor.document().objects)
    if (object->visible && object->picture()) out.push_back(scene_picture(editor, *object));
  return out;
}

std::vector<ObjectId> pictures_under(const Editor& editor, const Projector& projector, const Vector2& pixel) {
  std::vector<std::pair<double, ObjectId>> hits;
  const Ray ray = projector.ray(pixel);
  for (const auto& object : editor.document().objects) {
    if (!object->visible || object->locked || !object->picture()) continue;
    const ScenePicture picture = scene_picture(editor, *object);
    if (!picture.seen_by(projector.camera())) continue;
    if (const auto t = picture.hit(ray)) hits.emplace_back(*t, object->id);
  }
  std::stable_sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<ObjectId> out;
  for (const auto& [t, id] : hits) out.push_back(id);
  return out;
}

const Object* active_picture(const Editor& editor) {
  const Object* object = editor.has_document ? editor.active_object() : nullptr;
  return object && object->picture() ? object : nullptr;
}

std::vector<ObjectId> missing_pictures(const Editor& editor) {
  std::vector<ObjectId> out;
  for (const auto& object : editor.document().objects) {
    const ReferenceView* view = object->picture() ? editor.references.of(object->id) : nullptr;
    if (view && view->error) out.push_back(object->id);
  }
  return out;
}

PicturePlace place_for_picture(const Camera& camera, PixelSize view, PixelSize picture) {
  constexpr double share = 0.8;
  const auto side = side_of(camera);
  PicturePlace place;
  PictureSide faces = nearest_side(camera);
  for (const auto& [named, standard] : sides_and_views)
    if (side == standard) faces = named;
  if (side) {
    place.look.only_from = faces;
    place.look.layer = PictureLayer::behind;
  }
  const double height = share * camera.view_height(), width = height * view.aspect();
  place.width = round_length(std::min(width, height * picture.aspect()));
  place.transform.rotation = facing(faces);
  const Vector3 normal = place.transform.rotation * Vector3::UnitZ();
  place.transform.translation = camera.target - normal.dot(camera.target) * normal;
  return place;
}

void look_at_picture(Editor& editor, const Object& object) {
  const PictureSource& source = *object.picture();
  const Camera& camera = editor.layout.active_view().goal();
  const bool seen = !source.look.only_from || scene_picture(editor, object).seen_by(camera);
  const Vector3 normal = object.transform.rotation * Vector3::UnitZ();
  constexpr double too_flat = 0.2;  // cosine
  if (seen && std::abs(normal.dot(camera.forward())) > too_flat) return;
  const auto faces = source.look.only_from ? source.look.only_from : faced_side(object.transform.rotation);
  for (const auto& [side, view] : sides_and_views)
    if (faces == side) editor.layout.active_view().look_from(view, editor.now);
}

}  // namespace hariko
