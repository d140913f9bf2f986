#include "core/document/live_copies.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/document/document.hpp"

namespace hariko {

namespace {

constexpr double full_circle = 360;

/// Rotation about an axis through a point.
Similarity turned_about(const Vector3& point, const Vector3& direction, double degrees) {
  Similarity out;
  out.rotation = Eigen::AngleAxisd(degrees * std::numbers::pi / 180, direction.stableNormalized());
  out.translation = point - out.rotation * point;
  return out;
}

/// Motions of one array, in the object's space; the first is none.
struct MotionsOfArray {
  std::vector<Similarity> operator()(const RowOfCopies& row) const {
    std::vector<Similarity> out(static_cast<std::size_t>(row.count));
    for (std::size_t k = 1; k < out.size(); ++k) out[k].translation = static_cast<double>(k) * row.step;
    return out;
  }
  std::vector<Similarity> operator()(const RingOfCopies& ring) const {
    const double parts = std::abs(ring.degrees) == full_circle ? ring.count : ring.count - 1;
    std::vector<Similarity> out(static_cast<std::size_t>(ring.count));
    for (std::size_t k = 1; k < out.size(); ++k)
      out[k] = turned_about(ring.point, ring.direction, ring.degrees * static_cast<double>(k) / parts);
    return out;
  }
  std::vector<Similarity> operator()(const ListOfCopies& list) const {
    std::vector<Similarity> out(1);
    out.insert(out.end(), list.places.begin(), list.places.end());
    return out;
  }
  std::vector<Similarity> operator()(const MirrorOfCopies& mirror) const {
    return {Similarity{}, reflection_in(mirror.point, mirror.normal.stableNormalized())};
  }
};

struct CountOfArray {
  std::size_t operator()(const RowOfCopies& row) const { return static_cast<std::size_t>(row.count); }
  std::size_t operator()(const RingOfCopies& ring) const { return static_cast<std::size_t>(ring.count); }
  std::size_t operator()(const ListOfCopies& list) const { return list.places.size() + 1; }
  std::size_t operator()(const MirrorOfCopies&) const { return 2; }
};

bool is_direction(const Vector3& vector) {
  const double length = vector.stableNorm();
  return length > 0 && std::isfinite(length);
}

bool is_motion(const Similarity& place) {
  return place.translation.allFinite() && std::abs(place.rotation.norm() - 1) <= 1e-9 && place.scale == 1;
}

struct FaultOfArray {
  const char* operator()(const RowOfCopies& row) const {
    return is_direction(row.step) ? nullptr : "The step of a row of live copies is zero or not finite.";
  }
  const char* operator()(const RingOfCopies& ring) const {
    if (!is_direction(ring.direction) || !ring.point.allFinite())
      return "The axis of a ring of live copies has no direction.";
    return ring.degrees != 0 && std::abs(ring.degrees) <= full_circle
               ? nullptr
               : "The angle of a ring of live copies is zero or beyond a full turn.";
  }
  const char* operator()(const ListOfCopies& list) const {
    for (const Similarity& place : list.places)
      if (!is_motion(place)) return "A place of live copies is not finite, or is scaled.";
    return nullptr;
  }
  const char* operator()(const MirrorOfCopies& mirror) const {
    return is_direction(mirror.normal) && mirror.point.allFinite()
               ? nullptr
               : "The plane of mirrored live copies has no direction.";
  }
};

/// Rotation that is nearest to what a linear map makes of a rotation.
Eigen::Quaterniond rotation_under(const Eigen::Quaterniond& rotation, const Matrix3& linear) {
  const Matrix3 image = linear * rotation.toRotationMatrix() * linear.inverse();
  const Eigen::JacobiSVD<Matrix3> parts(image, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Matrix3 turn = parts.matrixU() * parts.matrixV().transpose();
  return Eigen::Quaterniond(turn).normalized();
}

struct MappedArray {
  const Matrix3& linear;
  /// Whether the map keeps all directions, which then keep their digits.
  const bool enlarges = linear == linear(0, 0) * Matrix3::Identity() && linear(0, 0) > 0;

  CopyArray operator()(RowOfCopies row) const {
    row.step = linear * row.step;
    return row;
  }
  CopyArray operator()(RingOfCopies ring) const {
    // The plane of the ring goes along, so its normal is mapped as normals are.
    ring.point = linear * ring.point;
    if (enlarges) return ring;
    ring.direction = (linear.inverse().transpose() * ring.direction).stableNormalized();
    if (linear.determinant() < 0) ring.degrees = -ring.degrees;
    return ring;
  }
  CopyArray operator()(MirrorOfCopies mirror) const {
    mirror.point = linear * mirror.point;
    if (!enlarges) mirror.normal = (linear.inverse().transpose() * mirror.normal).stableNormalized();
    return mirror;
  }
  CopyArray operator()(ListOfCopies list) const {
    for (Similarity& place : list.places) {
      if (!enlarges) place.rotation = rotation_under(place.rotation, linear);
      place.translation = linear * place.translation;
    }
    return list;
  }
};

struct ArrayInSpace {
  const Similarity& place;
  const Similarity back = place.inverse();

  CopyArray operator()(RowOfCopies row) const {
    row.step = back.apply_to_vector(row.step);
    return row;
  }
  CopyArray operator()(RingOfCopies ring) const {
    ring.point = back.apply(ring.point);
    ring.direction = back.rotation * ring.direction;
    return ring;
  }
  CopyArray operator()(MirrorOfCopies mirror) const {
    mirror.point = back.apply(mirror.point);
    mirror.normal = back.rotation * mirror.normal;
    return mirror;
  }
  CopyArray operator()(ListOfCopies list) const {
    for (Similarity& motion : list.places) {
      motion = composed(back, composed(motion, place));
      motion.scale = 1;
    }
    return list;
  }
};

Message invalid_copies(const char* text) {
  return make_error(
      e_copies_invalid, text,
      "Use from 2 to 10,000 places, a step that is not zero, an axis or a plane with a direction, and an "
      "angle from -360 to 360 degrees.");
}

}  // namespace

Result<Done> check_copies(const LiveCopies& copies) {
  constexpr const char* wrong_count = "Live copies have from 2 to 10,000 places.";
  std::size_t count = 1;
  for (const CopyArray& array : copies) {
    const std::size_t own = std::visit(CountOfArray{}, array);
    if (own < static_cast<std::size_t>(least_places) || own > static_cast<std::size_t>(most_places))
      return invalid_copies(wrong_count);
    count *= own;
    if (count > static_cast<std::size_t>(most_places)) return invalid_copies(wrong_count);
    if (const char* fault = std::visit(FaultOfArray{}, array)) return invalid_copies(fault);
  }
  return Done{};
}

std::size_t place_count(const Object& object) {
  std::size_t count = 1;
  for (const CopyArray& array : *object.copies) count *= std::visit(CountOfArray{}, array);
  return count;
}

std::vector<Similarity> places_of(const Object& object) {
  std::vector<Similarity> local(1);
  for (const CopyArray& array : *object.copies) {
    const std::vector<Similarity> motions = std::visit(MotionsOfArray{}, array);
    std::vector<Similarity> next = local;
    next.reserve(local.size() * motions.size());
    for (std::size_t k = 1; k < motions.size(); ++k)
      for (const Similarity& inner : local) next.push_back(composed(motions[k], inner));
    local = std::move(next);
  }
  std::vector<Similarity> out{object.transform};
  out.reserve(local.size());
  for (std::size_t k = 1; k < local.size(); ++k) out.push_back(composed(object.transform, local[k]));
  return out;
}

std::string name_of_place(const Object& object, std::size_t place) {
  return place == 0 ? object.name : object.name + " (" + std::to_string(place + 1) + ")";
}

CopyArray in_space_of(const CopyArray& array, const Similarity& place) {
  return std::visit(ArrayInSpace{place}, array);
}

LiveCopies mapped(const LiveCopies& copies, const Matrix3& linear) {
  LiveCopies out;
  for (const CopyArray& array : copies) out.push_back(std::visit(MappedArray{linear}, array));
  return out;
}

}  // namespace hariko
