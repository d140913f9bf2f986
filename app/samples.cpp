#include "app/samples.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <set>

#include "app/files/open_file.hpp"
#include "app/surface_builder.hpp"
#include "ui/view_pictures.hpp"

namespace hariko {

namespace fs = std::filesystem;

namespace {

constexpr PixelSize picture_size{540, 360};

struct Description {
  const char* stem;
  const char* title;
  const char* text;
};
constexpr Description descriptions[] = {
    {"cube", "Cube", "Six quads become a rounded solid"},
    {"fig2", "Vase body", "Three hexagon rings, closed"},
    {"fig2_open", "Open vase", "The same without its top: a border"},
    {"fig5c", "Flattened edges", "Edge tension 10 flattens"},
    {"fig5d", "Points", "Vertex tension 10 makes points"},
    {"concave", "Concave faces", "What folds, and the warning for it"},
    {"concave_split", "Concave, split", "The same with its concave faces decomposed"},
    {"genus3", "Three holes", "A closed shape of genus 3"},
    {"torus", "Torus", "Eight by four quads"},
    {"grid", "Open grid", "A free-form patch with borders"},
    {"grid3", "Open grid", "A free-form patch with borders"},
    {"creased", "Creased cube", "Sharp edges among smooth ones"},
    {"cube_crease", "Creased cube", "Sharp edges among smooth ones"},
    {"car", "Car body", "Larger model"},
    {"knot", "Knot", "A thousand faces, to see how fast everything follows"},
    {"skin_smooth", "Smooth skin", "Two sections with few columns, placed where they matter"},
    {"skin_ridges", "Ridges by themselves", "Points matched by their places alone"},
    {"skin_joined", "Joined ridges", "Two lines say which ridge goes where"},
    {"skin_grouped", "Grouped ridges", "Curves round points that belong together"},
    {"skin_between", "Joined on a grid", "Features aligned without extraordinary vertices"},
    {"skin_car_smooth", "Car, smooth skin", "Seven sections along a path, on a regular grid"},
    {"skin_car", "Car, pleated skin", "The same sections with their edges joined"},
    {"skin_merge_inside", "Merging ridges", "Two ridges become one on the way"},
    {"skin_merge_end", "Ridges that end in one", "Two ridges become one at the last section"},
    {"sphere_cap", "Sphere cap", "An outline with normals and curvature: an exact sphere"},
    {"ellipsoid_cap", "Ellipsoid cap", "An outline with normals and curvature, filled"},
    {"paraboloid", "Paraboloid", "An outline that is not flat"},
    {"sphere_band", "Spherical band", "Two outlines, one surface between them"},
    {"sphere_holes", "Sphere with three holes", "Three outlines bound one surface"},
    {"catenoid", "Catenoid", "A saddle everywhere, between two rings"},
    {"saddle", "Saddle", "A saddle over a round outline"},
    {"shell", "Shell", "A flat rim with tilted normals becomes a housing"},
    {"wheel_arch", "Wheel arch", "A hole between bicubic patches, closed smoothly"},
};

Sample describe(const fs::path& path) {
  const std::string stem = path.stem().string();
  for (const Description& known : descriptions)
    if (stem == known.stem) return {path, known.title, known.text};
  std::string title = stem;
  std::replace(title.begin(), title.end(), '_', ' ');
  if (!title.empty() && title[0] >= 'a' && title[0] <= 'z')
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
  return {path, title, path.filename().string()};
}

}  // namespace

std::vector<Sample> find_samples(const fs::path& assets) {
  std::vector<Sample> samples;
  std::error_code error;
  std::set<fs::path> paths;
  for (fs::directory_iterator it(assets / "samples", error), end; !error && it != end; it.increment(error))
    if (const auto extension = it->path().extension(); extension == ".hariko" || extension == ".obj")
      paths.insert(it->path());
  for (const fs::path& path : paths) {
    // A document made from a mesh of the same name stands for both.
    if (path.extension() == ".obj" && paths.contains(fs::path(path).replace_extension(".hariko"))) continue;
    samples.push_back(describe(path));
  }
  return samples;
}

Scene sample_scene(const fs::path& path, const CancelToken& cancel) {
  Scene scene;
  scene.grid.visible = false;
  const auto opened = open_file(path);
  if (!opened.document) return scene;
  for (const auto& object : opened.document->objects) {
    if (!object->has_surface() || !object->visible) continue;
    SurfaceBuilder builder;
    const SurfaceView view =
        builder.build(object, neighbours_of(*opened.document, object->id), Quality::final, cancel);
    SceneObject out;
    out.mesh = view.mesh;
    out.polyhedron = cage_of(*object);
    out.show_polyhedron = object->polyhedron() != nullptr;
    out.show_network = true;
    out.transform = matrix_of(object->transform);
    scene.objects.push_back(std::move(out));
  }
  return scene;
}

std::optional<Image> draw_picture(Renderer& renderer, const Scene& scene, PixelSize size) {
  const Camera camera = Camera::standard(StandardView::iso).frame(scene.world_box(), size);
  if (scene.objects.empty() || !renderer.draw(scene, camera, {size, 4, thumbnail_picture}).ok()) return {};
  Image image = renderer.read(thumbnail_picture);
  renderer.forget(thumbnail_picture);
  return image;
}

ImTextureID upload_picture(const Image& image) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               image.rgba.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, 0);
  // NOLINTNEXTLINE(performance-no-int-to-ptr): ImGui passes names of textures as pointers
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
}

void release_picture(ImTextureID picture) {
  const auto texture = static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(picture));
  if (texture != 0) glDeleteTextures(1, &texture);
}

ImTextureID sample_picture(Renderer& renderer, const Scene& scene) {
  const auto image = draw_picture(renderer, scene, picture_size);
  return image ? upload_picture(*image) : nullptr;
}

}  // namespace hariko
