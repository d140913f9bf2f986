#pragma once

// Sources: the authored data that objects are made from; nothing derived.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/flat_map.hpp"
#include "core/base/ids.hpp"
#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/document/format/kept_members.hpp"
#include "core/document/history/shared.hpp"
#include "core/document/mirror.hpp"
#include "core/document/picture_source.hpp"
#include "core/envelope/solid.hpp"
#include "core/gaussmap/outlines/outline_settings.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/polyhedron/polyhedron.hpp"
#include "core/skinning/skin.hpp"
#include "core/surface/bezier_patch.hpp"
#include "core/surface/bicubic_patch.hpp"

namespace hariko {

inline constexpr Code e_patch_grid{"E_PATCH_GRID"};
inline constexpr Code e_automatic_tension_range{"E_AUTOMATIC_TENSION_RANGE"};

/// Preparation: automatic steps between a polyhedron and its surface, beside the designer's own settings. The
/// polyhedron stays as it is; only the input of the surface changes.
struct Preparation {
  /// Concave faces are cut into convex ones (core/modeling/surfacing/convex_faces.hpp).
  bool split_concave = false;
  /// Coplanar triangles are merged (core/modeling/surfacing/merged_faces.hpp), before concave faces are cut.
  bool merge_coplanar = false;
  /// 0 (off) .. 1: the tension of every edge is multiplied by (mean length / its length) to this power
  /// (core/modeling/surfacing/automatic_tension.hpp).
  double automatic_tension = 0;
  friend bool operator==(const Preparation&, const Preparation&) = default;
};
/// Checks a preparation. E_AUTOMATIC_TENSION_RANGE: automatic tension is not a number from 0 to 1.
Result<Done> check_preparation(const Preparation& preparation);

/// The side of a join that is changed to make the surfaces tangent.
enum class Adapts : std::uint8_t {
  surface,  ///< the polyhedron's surface takes the patch's tangent planes
  patch     ///< the patch's second row of control points takes the surface's tangent planes
};

/// Copy of a side whose patch object was deleted: its points relative to the polyhedron's origin, in the
/// direction of the half-edge.
struct FrozenSide {
  std::array<Vector3, 4> curve, row;
  friend bool operator==(const FrozenSide&, const FrozenSide&) = default;
};

/// Attachment: join of one border edge of a polyhedron to one side of a patch object or to a frozen side
/// (kuriyama.md section 8). core/modeling/surfacing/object_surfacer.hpp makes joins from it.
struct Attachment {
  ObjectId patch;  ///< ignored when frozen
  NetSide side;
  /// Whether the edge's half-edge runs against the side's direction, as it does where both surfaces have the
  /// same orientation.
  bool reversed = true;
  Continuity continuity = Continuity::g1;  ///< G0 or G1
  Adapts adapts = Adapts::surface;         ///< used with G1 only
  std::optional<FrozenSide> frozen = {};
  friend bool operator==(const Attachment&, const Attachment&) = default;
};

using Attachments = FlatMap<EdgeId, Attachment>;

/// Polyhedron with tensions, from which a surface is made. A point of the object is origin + position.
struct PolyhedronSource {
  static constexpr std::string_view kind = "polyhedron";
  Vector3 origin = Vector3::Zero();
  Polyhedron polyhedron;  ///< positions relative to origin
  Shared<Shaping> shaping;
  Mode mode = Mode::fair;
  Shared<KeptMembers> kept;
  /// Live mirror: the polyhedron is one half; the surface is made from both
  /// (core/modeling/surfacing/mirrored.hpp).
  std::optional<Mirror> mirror = {};
  Preparation preparation = {};
  /// Border edges that are joined to patches. An entry whose edge no longer exists or is no longer a border
  /// edge is ignored.
  Shared<Attachments> attachments = {};
  /// Frames of the network; mode PAPER stores them but always uses equal frames.
  Frames frames = Frames::equal;

  /// Makes a source from a mesh with absolute positions: chooses the origin (`origin_for`) and subtracts it.
  /// Errors: those of `Polyhedron::build`; elements are dense indices, which are also the new ids.
  static Result<PolyhedronSource> from_mesh(PolygonMesh mesh);

  friend bool operator==(const PolyhedronSource& a, const PolyhedronSource& b);
};

/// Returns the source with the settings of new and imported objects: frames by measure, coplanar faces
/// merged, concave ones cut.
PolyhedronSource as_new(PolyhedronSource source);

/// Imported mesh kept as a reference: facets only, no surface, not necessarily manifold. Positions are finite
/// and relative to origin; faces have at least three corners with indices in range.
struct MeshSource {
  static constexpr std::string_view kind = "mesh";
  Vector3 origin = Vector3::Zero();
  Shared<PolygonMesh> mesh;
  Shared<KeptMembers> kept;

  /// Makes a source from a mesh with absolute positions. Errors: E_NONFINITE, E_NO_FACES, E_INDEX_RANGE,
  /// E_FACE_TOO_SMALL.
  static Result<MeshSource> from_mesh(PolygonMesh mesh);

  friend bool operator==(const MeshSource& a, const MeshSource& b);
};

/// Grid of bicubic Bezier patches. The control points are the vertices 0, 1, 2, ... of a net of quads, so
/// that they can be selected and moved like those of a polyhedron.
struct PatchSource {
  static constexpr std::string_view kind = "patches";
  Vector3 origin = Vector3::Zero();
  Index columns = 0, rows = 0;
  Polyhedron net;  ///< (3 columns + 1) x (3 rows + 1) points relative to origin, row by row
  Shared<KeptMembers> kept;

  static constexpr Index max_patches = 1'000'000;

  /// Makes a source from a net with absolute points. Errors: E_NONFINITE, E_PATCH_GRID (no patches, too many,
  /// or a wrong number of points).
  static Result<PatchSource> from_net(const BicubicNet& net);
  /// Makes a source from a net with points relative to `origin`. Errors as above.
  static Result<PatchSource> from_net(const Vector3& origin, const BicubicNet& net);
  /// Control points, relative to origin.
  BicubicNet control_net() const { return {columns, rows, net.positions()}; }

  friend bool operator==(const PatchSource& a, const PatchSource& b);
};

/// Bezier patches of any degree, polynomial or rational, that become one surface where their sides meet
/// (`weld_patches`). They are shown, analysed and meshed as they are; their control points are not editable.
struct BezierSource {
  static constexpr std::string_view kind = "bezier";
  Vector3 origin = Vector3::Zero();
  Shared<std::vector<BezierPatch>> patches;  ///< relative to origin; at least one, all pass `check_patch`
  Shared<KeptMembers> kept;

  static constexpr std::size_t max_patches = 100'000;

  /// Makes a source from patches with absolute points. Errors: E_PATCH_POINTS where there are none or too
  /// many, those of `check_patch`.
  static Result<BezierSource> from_patches(std::vector<BezierPatch> patches);
  /// Makes a source from patches with points relative to `origin`. Errors as above.
  static Result<BezierSource> from_patches(const Vector3& origin, std::vector<BezierPatch> patches);

  friend bool operator==(const BezierSource&, const BezierSource&) = default;
};

/// Placed solids with a smooth envelope surface (core/envelope).
struct SolidsSource {
  static constexpr std::string_view kind = "solids";
  Shared<EnvelopeInput> input;  ///< passes `check_envelope`
  Shared<KeptMembers> kept;

  friend bool operator==(const SolidsSource&, const SolidsSource&) = default;
};

/// Sections along a path, skinned by a subdivision surface (core/skinning). Sections that cannot be skinned
/// are an error of the surface; the source only needs unique ids.
struct SkinSource {
  static constexpr std::string_view kind = "skin";
  Shared<Skin> skin;
  Shared<KeptMembers> kept;

  friend bool operator==(const SkinSource&, const SkinSource&) = default;
};

/// Closed loops with normals, filled by a surface (core/gaussmap). The outline may be unfinished: its faults
/// are errors of its surface.
struct OutlineSource {
  static constexpr std::string_view kind = "outline";
  Shared<Outline> outline;  ///< one normal per point; at most `max_outline_points` points
  OutlineSettings settings;
  Shared<KeptMembers> kept;

  friend bool operator==(const OutlineSource&, const OutlineSource&) = default;
};

/// Source of a kind that this version of the program does not know, kept and written back unchanged.
struct UnknownSource {
  std::string kind;
  Shared<std::string> json;  ///< text of the whole source value, byte for byte
  friend bool operator==(const UnknownSource&, const UnknownSource&) = default;
};

using Source = std::variant<PolyhedronSource, MeshSource, PatchSource, BezierSource, SolidsSource, SkinSource,
                            OutlineSource, PictureSource, UnknownSource>;

/// Frames that a source stores; nothing for kinds without them.
std::optional<Frames> stored_frames(const Source& source);
/// Frames that a source's surface is made in, where they can be chosen: nothing for kinds without them and
/// for polyhedra of mode PAPER.
std::optional<Frames> surface_frames(const Source& source);

/// Mode that a source stores; nothing for kinds without it.
std::optional<Mode> stored_mode(const Source& source);

/// Name of a source's kind in files.
inline std::string_view kind_of(const Source& source) {
  return std::visit([](const auto& one) -> std::string_view { return one.kind; }, source);
}

}  // namespace hariko
