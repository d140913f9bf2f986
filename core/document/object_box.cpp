#include "core/document/object_box.hpp"

namespace hariko {

namespace {

/// Calls visit(point) with points of the object's own space whose bounding box is that of its source.
template <class Visit>
void visit_points(const Object& object, Visit&& visit) {
  if (const Polyhedron* cage = object.cage()) {
    const Vector3 origin = object.cage_origin();
    const Mirror* mirror =
        object.polyhedron() && object.polyhedron()->mirror ? &*object.polyhedron()->mirror : nullptr;
    for (Index v = 0; v < cage->vertex_count(); ++v) {
      Vector3 point = origin + cage->position(v);
      visit(point);
      if (!mirror) continue;
      point[index_of(mirror->axis)] *= -1;
      visit(point);
    }
  } else if (const MeshSource* mesh = object.mesh()) {
    for (const Vector3& position : mesh->mesh->positions) visit(mesh->origin + position);
  } else if (const BezierSource* bezier = object.bezier()) {
    for (const BezierPatch& patch : *bezier->patches)
      for (const Vector3& point : patch.points) visit(bezier->origin + point);
  } else if (const SolidsSource* solids = object.solids()) {
    const SymmetryPlane plane = solids->input->settings.symmetry;
    for (const Solid& solid : solids->input->solids) {
      const Eigen::AlignedBox3d box = box_of(solid);
      for (int i = 0; i < 8; ++i) {
        Vector3 corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
        visit(corner);
        if (plane == SymmetryPlane::none) continue;
        corner[static_cast<Eigen::Index>(plane) - 1] *= -1;
        visit(corner);
      }
    }
  } else if (const SkinSource* skin = object.skin()) {
    Skin all = *skin->skin;
    change_positions(all, [&](const Vector3& point) { visit(point); });
  } else if (const OutlineSource* outline = object.outline()) {
    for (const OutlineLoop& loop : outline->outline->loops)
      for (const Vector3& point : loop.points) visit(point);
  } else if (const PictureSource* picture = object.picture()) {
    for (const Vector3& corner : picture->corners()) visit(corner);
  }
}

}  // namespace

Eigen::AlignedBox3d world_box(const Object& object) {
  Eigen::AlignedBox3d box;
  visit_points(object, [&](const Vector3& point) { box.extend(object.transform.apply(point)); });
  return box;
}

}  // namespace hariko
