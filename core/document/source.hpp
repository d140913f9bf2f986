#pragma once

// Sources: what an object is made from. Authored data only, nothing derived.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/document/attachment.hpp"
#include "core/document/kept_members.hpp"
#include "core/document/mirror.hpp"
#include "core/document/picture_source.hpp"
#include "core/document/preparation.hpp"
#include "core/document/shared.hpp"
#include "core/envelope/solid.hpp"
#include "core/gaussmap/outline_settings.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polygon_mesh.hpp"
#include "core/polyhedron/polyhedron.hpp"
#include "core/skinning/skin.hpp"
#include "core/surface/bezier_patch.hpp"

namespace hariko {

inline constexpr Code e_patch_grid{"E_PATCH_GRID"};

/// A polyhedron with tensions, which becomes a surface. A point of the object is origin + position.
struct PolyhedronSource {
  Vector3 origin = Vector3::Zero();
  Polyhedron polyhedron;  ///< positions relative to origin
  Shared<Shaping> shaping;
  Mode mode = Mode::fair;
  Shared<KeptMembers> kept;
  /// The polyhedron is one half; the surface is made from both (core/modeling/mirrored.hpp).
  std::optional<Mirror> mirror = {};
  Preparation preparation = {};
  /// Border edges that are joined to patches. An entry whose edge is gone or inside now means nothing.
  Shared<Attachments> attachments = {};
  /// Mode PAPER keeps it, but has equal frames.
  Frames frames = Frames::equal;

  /// Takes a mesh with absolute positions, chooses the origin (`origin_for`) and subtracts it. Errors: those
  /// of `Polyhedron::build`; elements are dense indices, which are also the new ids.
  static Result<PolyhedronSource> from_mesh(PolygonMesh mesh);

  friend bool operator==(const PolyhedronSource& a, const PolyhedronSource& b);
};

/// As new objects and imported ones are made: frames by measure, faces in one plane merged, concave ones cut.
PolyhedronSource as_new(PolyhedronSource source);

/// An imported mesh kept as reference: facets only, no surface, not necessarily manifold. Positions are
/// finite and relative to origin; faces have at least three corners with indices in range.
struct MeshSource {
  Vector3 origin = Vector3::Zero();
  Shared<PolygonMesh> mesh;
  Shared<KeptMembers> kept;

  /// Takes a mesh with absolute positions. Errors: E_NONFINITE, E_NO_FACES, E_INDEX_RANGE, E_FACE_TOO_SMALL.
  static Result<MeshSource> from_mesh(PolygonMesh mesh);

  friend bool operator==(const MeshSource& a, const MeshSource& b);
};

/// A grid of bicubic Bezier patches. The control points are the vertices 0, 1, 2, ... of a net of quads, so
/// that they can be selected and moved as those of a polyhedron.
struct PatchSource {
  Vector3 origin = Vector3::Zero();
  Index columns = 0, rows = 0;
  Polyhedron net;  ///< (3 columns + 1) x (3 rows + 1) points relative to origin, row by row
  Shared<KeptMembers> kept;

  static constexpr Index max_patches = 1'000'000;

  /// Takes a net with absolute points. Errors: E_NONFINITE, E_PATCH_GRID (no patches, too many, or not as
  /// many points as they need).
  static Result<PatchSource> from_net(const BicubicNet& net);
  /// As above with points relative to `origin`.
  static Result<PatchSource> from_net(const Vector3& origin, const BicubicNet& net);
  /// The control points, relative to origin.
  BicubicNet control_net() const { return {columns, rows, net.positions()}; }

  friend bool operator==(const PatchSource& a, const PatchSource& b);
};

/// Bezier patches of any degree, polynomial or rational, that become one surface where their sides meet
/// (`weld_patches`). They are shown, analysed and meshed as they are; no control points are edited.
struct BezierSource {
  Vector3 origin = Vector3::Zero();
  Shared<std::vector<BezierPatch>> patches;  ///< relative to origin; at least one, all pass `check_patch`
  Shared<KeptMembers> kept;

  static constexpr std::size_t max_patches = 100'000;

  /// Takes patches with absolute points. Errors: E_PATCH_POINTS where there are none or too many, those of
  /// `check_patch`.
  static Result<BezierSource> from_patches(std::vector<BezierPatch> patches);
  /// As above with points relative to `origin`.
  static Result<BezierSource> from_patches(const Vector3& origin, std::vector<BezierPatch> patches);

  friend bool operator==(const BezierSource&, const BezierSource&) = default;
};

/// Placed solids, round which a smooth surface goes (core/envelope).
struct SolidsSource {
  Shared<EnvelopeInput> input;  ///< passes `check_envelope`
  Shared<KeptMembers> kept;

  friend bool operator==(const SolidsSource&, const SolidsSource&) = default;
};

/// Sections along a path, over which a subdivision surface goes (core/skinning). Where they cannot be
/// skinned, the surface says so; the source may be anything whose ids are unique.
struct SkinSource {
  Shared<Skin> skin;
  Shared<KeptMembers> kept;

  friend bool operator==(const SkinSource&, const SkinSource&) = default;
};

/// Closed loops with normals, inside of which a surface goes (core/gaussmap). The outline may be unfinished:
/// what is wrong with it is an error of its surface.
struct OutlineSource {
  Shared<Outline> outline;  ///< one normal a point; at most `max_outline_points` points
  OutlineSettings settings;
  Shared<KeptMembers> kept;

  friend bool operator==(const OutlineSource&, const OutlineSource&) = default;
};

/// A kind of object that this version of the program does not know: kept, and written back as it was.
struct UnknownSource {
  std::string kind;
  Shared<std::string> json;  ///< the text of the whole source value, byte for byte
  friend bool operator==(const UnknownSource&, const UnknownSource&) = default;
};

using Source = std::variant<PolyhedronSource, MeshSource, PatchSource, BezierSource, SolidsSource, SkinSource,
                            OutlineSource, PictureSource, UnknownSource>;

/// "polyhedron", "mesh", "patches", "bezier", "solids", "skin", "outline", "picture", or the kind's name in
/// the file.
std::string_view kind_of(const Source& source);

}  // namespace hariko
