#pragma once

// EnvelopeInput: the solids placed by the designer, and the settings of their envelope surface. Authored data
// only.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/text/enum_words.hpp"
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
inline constexpr Code e_solid_pull{"E_SOLID_PULL"};

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
template <>
inline constexpr auto enum_words<SolidKind> = all_words<SolidKind>({{SolidKind::box, "box"},
                                                                    {SolidKind::sphere, "sphere"},
                                                                    {SolidKind::cylinder, "cylinder"},
                                                                    {SolidKind::cone, "cone"},
                                                                    {SolidKind::prism, "prism"},
                                                                    {SolidKind::pyramid, "pyramid"},
                                                                    {SolidKind::capsule, "capsule"},
                                                                    {SolidKind::torus, "torus"},
                                                                    {SolidKind::polyhedron, "polyhedron"}});

/// Marks a solid as the bar between two others.
struct Bridge {
  std::array<std::uint32_t, 2> between{};  ///< ids of the two solids, which may have been deleted
  /// Method `ball`: radius of the ball where it touches only the bar and these two, instead of that of the
  /// settings; length.
  std::optional<double> ball_radius = {};
  friend bool operator==(const Bridge&, const Bridge&) = default;
};

/// Place through which the surface of method `ball` is pulled by hand, outwards or inwards. It moves with its
/// solid.
struct Pull {
  Vector3 place = Vector3::Zero();  ///< in the solid's own axes, before its scale
  double radius = 1;  ///< length, > 0: the surface is changed this far about the place, or farther
  friend bool operator==(const Pull&, const Pull&) = default;
};

/// One solid. The kind determines which sizes are used; the others are kept. The axis of round solids is
/// their z; a cone or pyramid has its centroid, which is a quarter of the height above the base, at
/// `position`.
struct Solid {
  SolidKind kind = SolidKind::box;
  Vector3 size = Vector3::Ones();      ///< box: edge lengths
  double radius = 0.5;                 ///< all kinds except box and polyhedron; prism, pyramid: circumradius
  double height = 1;                   ///< cylinder, cone, prism, pyramid
  double length = 1;                   ///< capsule: distance between the centres of its ends
  double tube = 0.2;                   ///< torus: radius of the tube
  std::uint32_t sides = 6;             ///< prism, pyramid
  std::vector<Vector3> points = {};    ///< polyhedron: the solid is their convex hull
  Vector3 position = Vector3::Zero();  ///< length
  Vector3 rotation = Vector3::Zero();  ///< Euler angles in degrees; first about x, then y, then z
  Vector3 scale = Vector3::Ones();     ///< along the solid's own axes, positive
  /// Own roundness, (0, 1]. Method `network`: instead of that of the settings; method `ball`: see `softened`.
  std::optional<double> roundness = {};
  std::uint32_t id = 0;  ///< stable id within the envelope, unique
  std::optional<Bridge> bridge = {};
  std::vector<Pull> pulls = {};

  friend bool operator==(const Solid&, const Solid&) = default;
};

/// Method of the envelope: rolling ball or curve network (docs/envelope.md).
enum class EnvelopeMethod : std::uint8_t { ball, network };
enum class SymmetryPlane : std::uint8_t { none, x, y, z };  ///< normal of the plane through the origin

/// Changes that were made when an older file was read, told with the surface. Not saved, and all equal, so
/// that a saved document equals the one that is read back.
struct ConvertedSettings {
  bool method = false;  ///< another method made the surface
  std::string lost;     ///< names of settings that mean nothing any more
  friend bool operator==(const ConvertedSettings&, const ConvertedSettings&) { return true; }
};

/// Settings of the envelope. Lengths are in the document's unit. `check_envelope` checks the ranges.
struct EnvelopeSettings {
  /// The default, because the ball's lengths depend on the solids: see `choose_ball`.
  EnvelopeMethod method = EnvelopeMethod::network;
  /// Method `ball`: radius of the ball; the surface fills the parts it cannot reach; nothing: an infinite
  /// radius, the hull. At least three times the rounding.
  std::optional<double> ball_radius = {};
  double rounding = 0;   ///< method `ball`: length; edges get a radius of 1.5 times this
  double clearance = 0;  ///< >= 0, distance kept from every solid
  /// Method `ball`: flat faces of the surface lie on those of the solids, at the clearance; edges protrude.
  bool on_faces = false;
  bool finer_patches = false;  ///< method `ball`: about twice as many patches, closer to the shape
  double roundness = 0.35;     ///< (0, 1], method `network`: tangents on primitive parts; 1: circular arcs
  SymmetryPlane symmetry = SymmetryPlane::none;
  ConvertedSettings converted = {};

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
inline constexpr std::size_t max_pulls = 32;  ///< limit for one solid
/// Largest distance of a pull from the middle of its solid, relative to the solid's diagonal.
inline constexpr double farthest_pull = 2;

/// Name of a kind: "box", "sphere", ...
inline std::string_view name_of(SolidKind kind) {
  return enum_word(kind);
}

/// Checks solids and settings. Errors name the solid by its index in the list (from 0, the element is an
/// object with that number) and the field: E_NO_SOLIDS, E_TOO_MANY_SOLIDS, E_SOLID_SIZE (not positive or not
/// finite), E_SOLID_SIDES, E_SOLID_TUBE (tube >= radius), E_SOLID_POINTS (fewer than four, not finite),
/// E_SOLID_FLAT, E_SOLID_PLACE (position or rotation not finite), E_SOLID_PULL, E_ENVELOPE_SETTING.
Result<Done> check_envelope(const EnvelopeInput& input);
/// Checks one solid, which has number `index` in a list.
Result<Done> check_solid(const Solid& solid, std::size_t index);

/// Bounding box of the placed solid along the axes; not the smallest one for rotated round solids.
Eigen::AlignedBox3d box_of(const Solid& solid);

/// Point of a solid's own axes, before its scale, where the solid stands, and the reverse.
Vector3 placed(const Solid& solid, const Vector3& own);
Vector3 own_place(const Solid& solid, const Vector3& point);

/// Rotation matrix Rz Ry Rx of angles in degrees.
Matrix3 solid_rotation(const Vector3& degrees);

/// Adds the corners of a regular polygon about the z axis. `phase`: angle of the first one, in sides.
void add_polygon(std::vector<Vector3>& points, std::uint32_t sides, double radius, double z,
                 double phase = 0);

/// Makes a capsule of radius `radius` (a length) from one solid to another, in the axes of their object. It
/// ends at their nearest points, shifted slightly towards their centres, so that it moves continuously with
/// the solids even where sides are parallel. It stores the ids of the two.
Solid bridge_between(const Solid& a, const Solid& b, double radius);

}  // namespace hariko
