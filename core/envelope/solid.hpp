#pragma once

// What the designer places: simple solids, and the settings of the surface that envelops them. Authored data
// only.

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/flat_map.hpp"
#include "core/base/result.hpp"
#include "core/base/vector.hpp"

namespace hariko {

inline constexpr Code e_no_solids{"E_NO_SOLIDS"};
inline constexpr Code e_too_many_solids{"E_TOO_MANY_SOLIDS"};
inline constexpr Code e_solid_size{"E_SOLID_SIZE"};
inline constexpr Code e_solid_sides{"E_SOLID_SIDES"};
inline constexpr Code e_solid_tube{"E_SOLID_TUBE"};
inline constexpr Code e_solid_points{"E_SOLID_POINTS"};
inline constexpr Code e_solid_flat{"E_SOLID_FLAT"};
inline constexpr Code e_solid_place{"E_SOLID_PLACE"};
inline constexpr Code e_envelope_setting{"E_ENVELOPE_SETTING"};

enum class SolidKind : std::uint8_t {
  box,
  sphere,
  cylinder,
  cone,
  prism,
  pyramid,
  capsule,
  torus,
  polyhedron
};

/// One solid. Which sizes mean something depends on the kind; the others are kept. The axis of round solids
/// is their z; a cone or pyramid has its centroid, which is a quarter of the height above the base, at
/// `position`.
struct Solid {
  SolidKind kind = SolidKind::box;
  Vector3 size = Vector3::Ones();        ///< box: edge lengths
  double radius = 0.5;                   ///< all but box and polyhedron; prisms: of the corners
  double height = 1;                     ///< cylinder, cone, prism, pyramid
  double length = 1;                     ///< capsule: between the centres of its ends
  double tube = 0.2;                     ///< torus: radius of the tube
  std::uint32_t sides = 6;               ///< prism, pyramid
  std::vector<Vector3> points = {};      ///< polyhedron: the solid is their convex hull
  Vector3 position = Vector3::Zero();    ///< length
  Vector3 rotation = Vector3::Zero();    ///< degrees; first round x, then y, then z
  Vector3 scale = Vector3::Ones();       ///< along the solid's own axes, positive
  std::optional<double> roundness = {};  ///< own roundness, (0, 1]; else that of the envelope
  std::uint32_t id = 0;                  ///< stable name within the envelope, unique

  friend bool operator==(const Solid&, const Solid&) = default;
};

/// A vertex of the curve network, named by its solid's id and its number there; in a valley by the ids of the
/// two solids, and a number that follows from the edge of the hull that was sunk. So settings survive while
/// the solids move.
struct NetworkVertexKey {
  std::uint32_t solid = 0, vertex = 0;
  std::uint32_t other =
      no_index;  ///< in a valley the larger id, or the same one between a solid and its image

  bool in_valley() const { return other != no_index; }
  bool is_of(std::uint32_t id) const { return id == solid || (in_valley() && id == other); }
  friend auto operator<=>(const NetworkVertexKey&, const NetworkVertexKey&) = default;
};
/// An edge of the curve network.
struct NetworkEdgeKey {
  NetworkVertexKey low, high;  ///< low < high
  static NetworkEdgeKey of(NetworkVertexKey a, NetworkVertexKey b) {
    return a < b ? NetworkEdgeKey{a, b} : NetworkEdgeKey{b, a};
  }
  friend auto operator<=>(const NetworkEdgeKey&, const NetworkEdgeKey&) = default;
};
/// Two solids with low < high, whose bridge it is.
struct SolidPair {
  std::uint32_t low = 0, high = 0;
  static SolidPair of(std::uint32_t a, std::uint32_t b) { return a < b ? SolidPair{a, b} : SolidPair{b, a}; }
  friend auto operator<=>(const SolidPair&, const SolidPair&) = default;
};

/// Documents have `ball` or `network`.
enum class EnvelopeMethod : std::uint8_t { automatic, network, field, ball };
enum class EnvelopePatches : std::uint8_t { rational, fair };
enum class SymmetryPlane : std::uint8_t { none, x, y, z };  ///< normal of the plane through the origin

/// Lengths are in the document's unit, angles in degrees. Ranges are those that `check_envelope` holds.
struct EnvelopeSettings {
  double roundness = 0.35;  ///< (0, 1], tangents on primitive parts; 1: circular arcs
  double waist = 0.5;       ///< (0, 1], tangents on inserted parts; towards 0: taut
  double tightness = 0;     ///< [0, 1], 0: the hull, 1: follows concave arrangements
  double clearance = 0;     ///< >= 0, distance that is kept from every solid
  double detail = 0.09;  ///< [0, 0.3], vertices nearer to each other than this part of the size are thinned
  double merge_angle = 40;  ///< [0, 60], largest angle between two triangles that may make a quad
  double cage_detail = 1;   ///< [0.5, 1.5], cells of the field's cage: smaller is closer to the solids
  EnvelopeMethod method = EnvelopeMethod::automatic;
  /// Method `ball`: of the ball, which fills what it cannot reach; nothing: as large as can be, the hull. At
  /// least three times the rounding.
  std::optional<double> ball_radius = {};
  bool from_before = false;  ///< read from a file in which another method made the surface; not saved
  double rounding = 0;       ///< method `ball`: length; edges get a radius of 1.5 times this
  EnvelopePatches patches = EnvelopePatches::rational;
  SymmetryPlane symmetry = SymmetryPlane::none;
  FlatMap<SolidPair, double> waists = {};         ///< factors on `waist` per bridge, (0, 2]
  FlatMap<NetworkEdgeKey, double> fullness = {};  ///< factors on the tangents of a curve, [0.1, 3]
  FlatMap<NetworkVertexKey, Vector3> offsets =
      {};  ///< added to a vertex's place: in the solid's own axes, in valleys the object's

  friend bool operator==(const EnvelopeSettings&, const EnvelopeSettings&) = default;
};

struct EnvelopeInput {
  std::vector<Solid> solids;
  EnvelopeSettings settings;
  friend bool operator==(const EnvelopeInput&, const EnvelopeInput&) = default;
};

inline constexpr std::size_t max_solids = 200;
inline constexpr std::size_t max_solid_points = 2000;
inline constexpr std::uint32_t max_solid_sides = 64;

/// "box", "sphere", ...
std::string_view name_of(SolidKind kind);
std::optional<SolidKind> solid_kind_named(std::string_view name);

/// Errors name the solid by its place in the list (from 0, the element is an object with that number) and the
/// field: E_NO_SOLIDS, E_TOO_MANY_SOLIDS, E_SOLID_SIZE (not positive or not finite), E_SOLID_SIDES,
/// E_SOLID_TUBE (tube >= radius), E_SOLID_POINTS (fewer than four, not finite), E_SOLID_FLAT,
/// E_SOLID_PLACE (position or rotation not finite), E_ENVELOPE_SETTING.
Result<Done> check_envelope(const EnvelopeInput& input);
/// The same for one solid that is number `index` of a list.
Result<Done> check_solid(const Solid& solid, std::size_t index);

/// A box along the axes round the solid in its place; not the smallest one of round solids that are turned.
Eigen::AlignedBox3d box_of(const Solid& solid);

/// Rz Ry Rx of angles in degrees.
Matrix3 solid_rotation(const Vector3& degrees);

}  // namespace hariko
