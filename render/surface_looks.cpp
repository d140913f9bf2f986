#include "render/surface_looks.hpp"

#include <algorithm>
#include <cmath>

namespace hariko::gl {

namespace {

constexpr int environment_unit = 4;  // first texture unit here; those before are the painter's

/// Mode number of surface.frag.glsl.
int surface_mode(SurfaceMap map, bool with_values, bool reflects) {
  switch (map) {
    case SurfaceMap::shaded:
      return reflects ? 6 : 0;
    case SurfaceMap::patches:
      return 1;
    case SurfaceMap::zebra:
      return 2;
    case SurfaceMap::continuity:
      return 4;
    case SurfaceMap::isophotes:
      return 5;
    default:
      return with_values ? 3 : 4;
  }
}

bool has_highlights(const SceneObject& object) {
  return !object.selected_patches.empty() || !object.hovered_patches.empty();
}

/// Properties that a program is compiled for.
struct SurfaceLook {
  int mode = 0;
  Material material = Material::clay;
  bool highlights = false, wire = false, tubes = false;
};

std::string defines_of(const SurfaceLook& look) {
  const auto line = [](const char* name, int value) {
    return "#define " + std::string(name) + " " + std::to_string(value) + "\n";
  };
  return line("MODE", look.mode) + line("MATERIAL", look.mode == 0 ? static_cast<int>(look.material) : 0) +
         line("HIGHLIGHTS", look.highlights ? 1 : 0) + line("WIRE", look.wire ? 1 : 0) +
         line("TUBES", look.tubes ? 1 : 0);
}

/// Texture with the levels of an environment. Columns meet at their ends; rows end at the poles.
Texture environment_texture(const EnvironmentLevels& environment) {
  Texture texture = Texture::make();
  glActiveTexture(GL_TEXTURE0 + environment_unit);
  glBindTexture(GL_TEXTURE_2D, texture.name());
  for (std::size_t i = 0; i < environment.levels.size(); ++i) {
    const RadianceImage& level = environment.levels[i];
    glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(i), GL_RGBA16F, level.width, level.height, 0, GL_RGB,
                 GL_FLOAT, level.pixels.data());
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(environment.levels.size()) - 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

bool mirrors_environment(const SceneObject& object, const Scene& scene) {
  return object.map == SurfaceMap::shaded && scene.environment.levels != nullptr;
}

bool mirrors_ceiling(const SceneObject& object, const Scene& scene) {
  return object.map == SurfaceMap::zebra && scene.zebra.lock == StripeLock::tubes;
}

std::string surface_defines(const SceneObject& object, const Scene& scene) {
  return defines_of({surface_mode(object.map, object.mesh->has_values(), mirrors_environment(object, scene)),
                     object.material, has_highlights(object), object.wire == PatchWire::mesh,
                     mirrors_ceiling(object, scene)});
}

std::string plain_surface_defines() {
  return defines_of({});
}

void set_ceiling(const Program& program, const Matrix4& view, const Scene& scene) {
  const Box3 box = scene.world_box();
  const double diagonal = box.isEmpty() ? 1 : std::max(box.sizes().norm(), 1e-9);
  Vector3 middle = box.isEmpty() ? Vector3(Vector3::Zero()) : Vector3(box.center());
  middle.z() = (box.isEmpty() ? 0 : box.max().z()) + diagonal / 2;
  const Matrix3 rotation = view.topLeftCorner<3, 3>();
  const Vector3 wanted(scene.zebra.direction.x(), scene.zebra.direction.y(), 0);
  const Vector3 across = wanted.norm() > 1e-9 ? Vector3(wanted.normalized()) : Vector3(Vector3::UnitX());
  program.set("ceiling_middle", to_float(Vector3(rotation * middle + view.topRightCorner<3, 1>())));
  program.set("ceiling_normal", to_float(Vector3(rotation * Vector3::UnitZ())));
  program.set("tubes_per_length", std::clamp(scene.zebra.stripes, 2, 64) / (2 * diagonal));
  program.set("stripe_direction", to_float(Vector3(rotation * across)));
}

std::size_t EnvironmentTexture::set(const Program& program, const Matrix4& view,
                                    const Environment& environment) {
  const bool other = levels_ != environment.levels;
  if (other) {
    texture_ = environment_texture(*environment.levels);
    levels_ = environment.levels;
  }
  const Matrix3 to_world = view.topLeftCorner<3, 3>().transpose();
  program.set("environment", environment_unit);
  program.set("to_environment", to_float(Matrix3(environment.axes() * to_world)));
  program.set("roughest_level", static_cast<float>(levels_->levels.size() - 1));
  program.set("exposure", std::exp2(environment.exposure));
  glActiveTexture(GL_TEXTURE0 + environment_unit);
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  return other ? levels_->bytes() : 0;
}

}  // namespace hariko::gl
