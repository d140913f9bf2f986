#include "app/pictures/file_pictures.hpp"

#include <epoxy/gl.h>

#include "app/engines/surface_builder.hpp"
#include "app/files/open_file.hpp"
#include "core/document/object_shape.hpp"
#include "ui/editor/object_kind.hpp"
#include "ui/editor/object_lines.hpp"
#include "ui/view/view_pictures.hpp"

namespace hariko {

namespace fs = std::filesystem;

namespace {

/// An object as a part of the scene, to which it may add lines of its own.
SceneObject part_of(const Document& document, const std::shared_ptr<const Object>& object,
                    const CancelToken& cancel, std::vector<OverlayLine>& lines) {
  SceneObject out;
  SurfaceBuilder builder;
  out.mesh = builder.build(object, neighbours_of(document, object->id), {}, Quality::final, cancel).mesh;
  out.polyhedron = lines_of(document, *object);
  out.transform = matrix_of(object->transform);
  out.show_network = true;
  // Points of a dense cage would hide it.
  constexpr std::size_t most_points = 80;
  out.show_points = out.polyhedron && out.polyhedron->positions.size() <= most_points;
  object_kind(*object).adjust_in_file(*object, out, lines);
  return out;
}

}  // namespace

Scene file_scene(const fs::path& path, const CancelToken& cancel) {
  Scene scene;
  scene.grid.visible = false;
  const auto opened = open_file(path);
  if (!opened.document) return scene;
  for (const auto& object : opened.document->objects) {
    if (!has_shape(*object) || !object->visible) continue;
    const SceneObject part = part_of(*opened.document, object, cancel, scene.lines);
    for (const Similarity& place : places_of(*object)) {
      scene.objects.push_back(part);
      scene.objects.back().transform = matrix_of(place);
    }
  }
  return scene;
}

Camera file_camera(const Scene& scene, PixelSize size) {
  constexpr double margin = 1.12;
  Camera camera = framed(Camera::standard(StandardView::iso), scene, size);
  camera.distance *= margin;
  return camera;
}

std::optional<Image> draw_picture(Renderer& renderer, const Scene& scene, PixelSize size) {
  if (scene.objects.empty() ||
      !renderer.draw(scene, file_camera(scene, size), {size, 4, thumbnail_picture}).ok())
    return {};
  Image image = renderer.read(thumbnail_picture);
  renderer.forget(thumbnail_picture);
  return image;
}

unsigned upload_picture(const Image& image) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  // Without mipmaps: pictures are shown at about their own size, and a software renderer compiles a program
  // to make mipmaps, which takes as long as half a start.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               image.rgba.data());
  glBindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

void release_picture(unsigned texture) {
  if (texture != 0) glDeleteTextures(1, &texture);
}

}  // namespace hariko
