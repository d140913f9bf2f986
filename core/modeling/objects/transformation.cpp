#include "core/modeling/objects/transformation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/index_list.hpp"
#include "core/document/edits/edits.hpp"
#include "core/modeling/mesh_editor.hpp"

namespace hariko {

namespace {

/// Cosine and sine of an angle in degrees, exact at quarter turns.
std::pair<double, double> turn(double degrees) {
  const double rest = std::remainder(degrees, 360);
  if (rest == 0) return {1, 0};
  if (rest == 90) return {0, 1};
  if (rest == -90) return {0, -1};
  if (std::abs(rest) == 180) return {-1, 0};
  const double radians = rest * std::numbers::pi / 180;
  return {std::cos(radians), std::sin(radians)};
}

Matrix3 rotation(const Vector3& axis, double degrees) {
  const auto [c, s] = turn(degrees);
  Matrix3 cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return c * Matrix3::Identity() + s * cross + (1 - c) * (axis * axis.transpose());
}

/// Rotation as a quaternion, made from the half angle so that small turns keep their digits.
Eigen::Quaterniond quaternion(const Transformation& t) {
  const auto [c, s] = turn(t.degrees / 2);
  return {c, s * t.axis.x(), s * t.axis.y(), s * t.axis.z()};
}

Result<PolyhedronSource> stretched(const PolyhedronSource& source, const Matrix3& linear) {
  const Index count = source.polyhedron.vertex_count();
  std::vector<Vector3> positions(count);
  for (Index v = 0; v < count; ++v)
    positions[v] = linear * (source.origin + source.polyhedron.position(v)) - source.origin;
  auto moved = source.polyhedron.with_positions(ascending_indices(count), positions);
  if (!moved) return moved.error();
  PolyhedronSource result = source;
  result.polyhedron = std::move(moved).value();
  for (const auto& [edge, attachment] : *source.attachments) {
    if (!attachment.frozen) continue;
    Attachment changed = attachment;
    for (auto* rows : {&changed.frozen->curve, &changed.frozen->row})
      for (Vector3& point : *rows) point = linear * (source.origin + point) - source.origin;
    if (linear.determinant() < 0)
      for (auto* rows : {&changed.frozen->curve, &changed.frozen->row})
        std::reverse(rows->begin(), rows->end());
    Attachments changed_all = *result.attachments;
    changed_all.set(edge, changed);
    result.attachments = std::move(changed_all);
  }
  if (linear.determinant() > 0) return result;
  MeshEditor draft(result);
  for (const FaceId id : draft.faces()) {
    const auto corners = draft.face(id);
    draft.set_face(id, {corners.rbegin(), corners.rend()});
  }
  return std::move(draft).finish();
}

Result<PatchSource> stretched(const PatchSource& source, const Matrix3& linear) {
  BicubicNet net = source.control_net();
  for (Vector3& point : net.points) point = linear * (source.origin + point) - source.origin;
  // A reflection keeps the order of the points, because edges may be attached to them.
  Result<PatchSource> made = PatchSource::from_net(source.origin, net);
  if (!made) return made;
  PatchSource result = std::move(made).value();
  result.kept = source.kept;
  return result;
}

Result<BezierSource> stretched(const BezierSource& source, const Matrix3& linear) {
  std::vector<BezierPatch> patches = *source.patches;
  for (BezierPatch& patch : patches) {
    for (Vector3& point : patch.points) point = linear * (source.origin + point) - source.origin;
    // Keeps the outside of a reflected patch.
    if (linear.determinant() < 0) patch = flipped(patch);
  }
  Result<BezierSource> made = BezierSource::from_patches(source.origin, std::move(patches));
  if (!made) return made;
  BezierSource result = std::move(made).value();
  result.kept = source.kept;
  return result;
}

Result<MeshSource> stretched(const MeshSource& source, const Matrix3& linear) {
  PolygonMesh mesh = *source.mesh;
  for (Vector3& position : mesh.positions) {
    position = linear * (source.origin + position) - source.origin;
    if (!position.allFinite())
      return make_error(e_transform_invalid, "The object cannot be stretched like this.",
                        "Use smaller factors.");
  }
  if (linear.determinant() < 0)
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
      std::reverse(mesh.face_vertices.begin() + static_cast<std::ptrdiff_t>(mesh.face_offsets[f]),
                   mesh.face_vertices.begin() + static_cast<std::ptrdiff_t>(mesh.face_offsets[f + 1]));
  MeshSource result = source;
  result.mesh = std::move(mesh);
  return result;
}

Result<Source> stretched(const Object& object, const Matrix3& linear) {
  const auto as_source = [](auto result) -> Result<Source> {
    if (!result) return result.error();
    return Source(std::move(result).value());
  };
  if (const PolyhedronSource* source = object.polyhedron()) return as_source(stretched(*source, linear));
  if (const MeshSource* source = object.mesh()) return as_source(stretched(*source, linear));
  if (const PatchSource* source = object.patches()) return as_source(stretched(*source, linear));
  if (const BezierSource* source = object.bezier()) return as_source(stretched(*source, linear));
  if (object.picture())
    return make_error(e_wrong_kind, "The picture \"" + object.name + "\" cannot be stretched or mirrored.",
                      "Scale it evenly.", element_of(object.id));
  return make_error(e_wrong_kind,
                    "The object \"" + object.name + "\" cannot be stretched: its kind is not known here.",
                    "Scale it evenly.", element_of(object.id));
}

}  // namespace

Matrix3 Transformation::linear(double weight) const {
  Matrix3 result = Matrix3::Identity();
  if (factors != Vector3::Ones()) {
    const Vector3 weighted = Vector3::Ones() + weight * (factors - Vector3::Ones());
    result = uniform() ? Matrix3(weighted.x() * Matrix3::Identity())
                       : Matrix3(frame * weighted.asDiagonal() * frame.transpose());
  }
  return degrees == 0 ? result : Matrix3(result * rotation(axis, weight * degrees));
}

Vector3 Transformation::apply(const Vector3& point, const Vector3& pivot, double weight) const {
  if (only_translates()) return point + weight * translation;
  return pivot + linear(weight) * (point - pivot) + weight * translation;
}

Transformation Transformation::in_space_of(const Similarity& object) const {
  const Eigen::Quaterniond back = object.rotation.conjugate();
  Transformation result = *this;
  result.translation = back * translation / object.scale;
  result.axis = back * axis;
  result.frame = back.toRotationMatrix() * frame;
  return result;
}

Result<Document> transform_object(const Document& document, ObjectId id, const Transformation& transformation,
                                  const Vector3& pivot) {
  const Object* object = document.find(id);
  Similarity place = object ? object->transform : Similarity{};
  place.translation = transformation.apply(place.translation, pivot);
  if (transformation.degrees != 0)
    place.rotation = (quaternion(transformation) * place.rotation).normalized();
  const bool similar = transformation.uniform() && transformation.factors.x() > 0;
  if (similar) place.scale *= transformation.factors.x();
  const auto placed = set_transform(document, id, place);
  if (!placed || similar) return placed;
  // The factors, expressed in the object's own axes.
  Transformation factors;
  factors.frame = transformation.frame;
  factors.factors = transformation.factors;
  const Matrix3 linear = factors.in_space_of(place).linear();
  const auto source = stretched(*object, linear);
  if (!source) return source.error();
  const auto stretched_source = set_source(*placed, id, *source);
  if (!stretched_source || object->copies->empty()) return stretched_source;
  return set_copies(*stretched_source, id, mapped(*object->copies, linear));
}

}  // namespace hariko
