#include "core/modeling/objects/mirrored_source.hpp"

#include "core/envelope/scene_symmetry.hpp"
#include "core/gaussmap/outlines/resample_loop.hpp"
#include "core/modeling/surfacing/mirrored.hpp"
#include "core/skinning/edit/edit_section.hpp"

namespace hariko {

namespace {

Result<Source> source_across(const MeshSource& source, const MirrorPlane& plane) {
  PolygonMesh mesh = *source.mesh;
  for (Vector3& position : mesh.positions) position = plane.image(position);
  reverse_faces(mesh);
  MeshSource out = source;
  out.origin = plane.image(source.origin);
  out.mesh = std::move(mesh);
  return Source(std::move(out));
}

/// The columns in opposite order keep the outside. Nothing is attached to the sides of an image yet.
Result<Source> source_across(const PatchSource& source, const MirrorPlane& plane) {
  const BicubicNet net = source.control_net();
  BicubicNet image = net;
  for (Index j = 0; j < net.height(); ++j)
    for (Index i = 0; i < net.width(); ++i)
      image.points[image.index(i, j)] = plane.image(net.at(net.width() - 1 - i, j));
  Result<PatchSource> made = PatchSource::from_net(plane.image(source.origin), image);
  if (!made) return made.error();
  PatchSource out = std::move(made).value();
  out.kept = source.kept;
  return Source(std::move(out));
}

Result<Source> source_across(const BezierSource& source, const MirrorPlane& plane) {
  std::vector<BezierPatch> patches = *source.patches;
  for (BezierPatch& patch : patches) {
    for (Vector3& point : patch.points) point = plane.image(point);
    patch = flipped(patch);
  }
  Result<BezierSource> made = BezierSource::from_patches(plane.image(source.origin), std::move(patches));
  if (!made) return made.error();
  BezierSource out = std::move(made).value();
  out.kept = source.kept;
  return Source(std::move(out));
}

Source source_across(const SolidsSource& source, Eigen::Index axis) {
  EnvelopeInput input = *source.input;
  for (Solid& solid : input.solids) solid = reflected(solid, axis);
  SolidsSource out = source;
  out.input = std::move(input);
  return out;
}

Source source_across(const SkinSource& source, Eigen::Index axis) {
  Skin skin = mirrored(*source.skin, Vector3::Zero(), Vector3::Unit(axis));
  if (skin.mirror && skin.mirror->axis == axis) skin.mirror->position = -skin.mirror->position;
  SkinSource out = source;
  out.skin = std::move(skin);
  return out;
}

/// Seen from the tips of the reflected normals the surface would lie on the right, so the loops are reversed.
Source source_across(const OutlineSource& source, const MirrorPlane& plane) {
  Outline outline = *source.outline;
  for (OutlineLoop& loop : outline.loops) {
    for (Vector3& point : loop.points) point = plane.image(point);
    for (Vector3& normal : loop.normals) normal = plane.image(normal);
    loop = reversed(loop);
  }
  OutlineSource out = source;
  out.outline = std::move(outline);
  return out;
}

}  // namespace

bool can_be_mirrored(const Object& object) {
  return object.has_surface() || object.mesh();
}

Result<Source> mirrored_source(const Object& object, Axis axis) {
  HARIKO_ASSERT(can_be_mirrored(object), "sources of this kind have no mirror image");
  const MirrorPlane plane = mirror_plane(axis);
  const Eigen::Index along = index_of(axis);
  if (const PolyhedronSource* source = object.polyhedron())
    return Source(mirror_object(*source, axis).source);
  if (const MeshSource* source = object.mesh()) return source_across(*source, plane);
  if (const PatchSource* source = object.patches()) return source_across(*source, plane);
  if (const BezierSource* source = object.bezier()) return source_across(*source, plane);
  if (const SolidsSource* source = object.solids()) return source_across(*source, along);
  if (const SkinSource* source = object.skin()) return source_across(*source, along);
  return source_across(*object.outline(), plane);
}

}  // namespace hariko
