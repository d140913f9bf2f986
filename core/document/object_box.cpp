#include "core/document/object_box.hpp"

#include <variant>

namespace hariko {

namespace {

/// Box in the document's space round the points of a source, and round what a live mirror or a plane of
/// symmetry adds.
struct WorldBox {
  const Similarity& transform;
  Eigen::AlignedBox3d box = {};

  void add(const Vector3& point) { box.extend(transform.apply(point)); }
  void add_image(Vector3 point, Eigen::Index axis) {
    point[axis] *= -1;
    add(point);
  }

  void operator()(const PolyhedronSource& source) {
    for (Index v = 0; v < source.polyhedron.vertex_count(); ++v) {
      const Vector3 point = source.origin + source.polyhedron.position(v);
      add(point);
      if (source.mirror) add_image(point, index_of(source.mirror->axis));
    }
  }
  void operator()(const MeshSource& source) {
    for (const Vector3& position : source.mesh->positions) add(source.origin + position);
  }
  void operator()(const PatchSource& source) {
    for (Index v = 0; v < source.net.vertex_count(); ++v) add(source.origin + source.net.position(v));
  }
  void operator()(const BezierSource& source) {
    for (const BezierPatch& patch : *source.patches)
      for (const Vector3& point : patch.points) add(source.origin + point);
  }
  void operator()(const SolidsSource& source) {
    const SymmetryPlane plane = source.input->settings.symmetry;
    for (const Solid& solid : source.input->solids) {
      const Eigen::AlignedBox3d own = box_of(solid);
      for (int i = 0; i < 8; ++i) {
        const Vector3 corner = own.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
        add(corner);
        if (plane != SymmetryPlane::none) add_image(corner, static_cast<Eigen::Index>(plane) - 1);
      }
    }
  }
  void operator()(const SkinSource& source) {
    Skin all = *source.skin;
    change_positions(all, [this](const Vector3& point) { add(point); });
  }
  void operator()(const OutlineSource& source) {
    for (const OutlineLoop& loop : source.outline->loops)
      for (const Vector3& point : loop.points) add(point);
  }
  void operator()(const PictureSource& source) {
    for (const Vector3& corner : source.corners()) add(corner);
  }
  void operator()(const UnknownSource&) {}
};

}  // namespace

Eigen::AlignedBox3d world_box(const Object& object) {
  if (object.copies->empty()) return box_at_own_place(object);
  return box_of_places(object, [&](const Similarity& place) {
    WorldBox one{place};
    std::visit(one, object.source);
    return one.box;
  });
}

Eigen::AlignedBox3d box_of_places(const Object& object,
                                  const std::function<Eigen::AlignedBox3d(const Similarity&)>& box_at) {
  Eigen::AlignedBox3d out;
  const Similarity* measured = nullptr;
  Eigen::AlignedBox3d box;
  const std::vector<Similarity> places = places_of(object);
  for (const Similarity& place : places) {
    // Places that are not turned against the last measured one have the same box elsewhere.
    const bool moved =
        measured && measured->rotation.coeffs() == place.rotation.coeffs() && measured->scale == place.scale;
    if (!moved) {
      box = box_at(place);
      measured = &place;
    }
    if (box.isEmpty()) return out;
    out.extend(box.translated(place.translation - measured->translation));
  }
  return out;
}

Eigen::AlignedBox3d box_at_own_place(const Object& object) {
  WorldBox out{object.transform};
  std::visit(out, object.source);
  return out.box;
}

}  // namespace hariko
