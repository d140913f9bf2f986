#pragma once

// What `hariko info` tells about an object.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/files/open_file.hpp"
#include "core/analysis/statistics.hpp"
#include "core/document/document.hpp"
#include "core/patching/compare_surfaces.hpp"

namespace hariko {

/// Of solids: how the surface round them was made.
struct EnvelopeInfo {
  std::size_t solids = 0;
  std::string symmetry;              ///< "none", or the axis across the plane
  std::size_t images = 0;            ///< of solids, in that plane
  bool symmetric = false;            ///< the surface is its own image
  std::string method;                ///< "ball" or "network"
  bool enclosed = false;             ///< to 1e-4 of the diagonal
  std::optional<double> sticks_out;  ///< length; only where faces lie on the solids
  double worst = 0;  ///< farthest test point outside, by the independent check, over the diagonal
  std::size_t tested = 0, outside = 0;
  std::size_t folds = 0;
  std::size_t crossing = 0;  ///< patches inside of another part of the surface
  std::size_t coarse = 0;    ///< patches of the ball that miss its shape
  int rounds = 0;            ///< in which cubes below patches of the ball were halved
};

/// Of skins: the control mesh and how near the surface is to the sections.
struct SkinInfo {
  std::size_t sections = 0;
  std::string method;                        ///< "smooth", "anchored" or "pleat"
  std::size_t rows = 0, columns = 0;         ///< of the control mesh; columns only of a regular grid
  std::map<std::string, int> extraordinary;  ///< as `ControlMeshFigures`
  std::size_t creases = 0, regular_faces = 0;
  std::optional<double> condition;   ///< of the limit matrix; nothing where it is singular
  std::vector<double> section_miss;  ///< largest distance of the surface's curve from each section
};

/// Of an outline: the control points inside.
struct OutlineInfo {
  std::string method;
  std::size_t loops = 0, points = 0, inserted = 0;
  double gap = 0;  ///< see `ControlPoints`
};

/// What does not exist, or is not known because of an error, is empty. Lengths are in the document's unit,
/// after the object's transform.
struct ObjectInfo {
  std::string name, kind;
  std::optional<std::size_t> vertices, edges, faces, patches, components, genus, boundary_loops;
  std::optional<double> area, volume, bending, largest_gap, largest_normal_jump, rms_curvature_jump;
  std::optional<CurvatureRange> gauss_range, mean_range;
  std::optional<std::size_t> degenerate_samples, folded_samples;
  std::optional<EnvelopeInfo> envelope;
  std::optional<SkinInfo> skin;
  std::optional<OutlineInfo> outline;
  /// Present when the object was compared with another document's; empty inside where that one has no such
  /// object, or one of the two has no surface.
  std::optional<std::optional<SurfaceComparison>> against;
  std::vector<Message> messages;
  std::vector<std::pair<std::string, double>> milliseconds;  ///< step, time

  bool failed() const;
};

/// `against`: the document whose object of the same id it is compared with, or null.
ObjectInfo inspect(const Document& document, const Object& object, const Document* against = nullptr);
/// Information that needs no measuring: the name, the kind, and the counts of polyhedra and nets.
ObjectInfo inspect_at_once(const Object& object);
/// Of a mesh file that makes no polyhedron.
ObjectInfo inspect_broken(const OpenedFile& input);

/// {"objects": [...]} with the keys of docs/cli.md.
std::string info_json(const std::vector<ObjectInfo>& objects);
/// The same for people, one line a value.
std::string info_text(const std::vector<ObjectInfo>& objects);
/// The first lines of that for an object, up to what is not known.
std::string info_head(const ObjectInfo& object);

}  // namespace hariko
