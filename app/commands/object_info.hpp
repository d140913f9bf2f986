#pragma once

// Report of `hariko info` on objects and groups.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/dimension_info.hpp"
#include "app/files/open_file.hpp"
#include "core/analysis/statistics.hpp"
#include "core/document/document.hpp"
#include "core/patching/compare_surfaces.hpp"

namespace hariko {

/// A group with the objects that it contains at any depth, in the order of the list.
struct GroupInfo {
  std::uint32_t id = 0;
  std::string name;
  std::optional<std::uint32_t> parent;  ///< id of the group that it lies in
  bool visible = true, locked = false;  ///< with the groups round it
  std::vector<std::string> objects;     ///< names
};

/// All groups by ascending id. O(n log n).
std::vector<GroupInfo> inspect_groups(const Document& document);

/// Report as text: their number, then a line for each. Empty where there are none.
std::string groups_text(const std::vector<GroupInfo>& groups);

/// Figures of a surface round solids.
struct EnvelopeInfo {
  std::size_t solids = 0;
  std::string symmetry;              ///< "none", or the axis perpendicular to the mirror plane
  std::size_t images = 0;            ///< number of mirror images of solids
  bool symmetric = false;            ///< the surface equals its mirror image
  std::string method;                ///< "ball" or "network"
  bool enclosed = false;             ///< all solids are enclosed, to 1e-4 of the diagonal
  std::optional<double> sticks_out;  ///< largest protrusion, a length; only where faces lie on the solids
  /// Largest distance of a test point outside the surface, by an independent check, relative to the diagonal.
  double worst = 0;
  std::size_t tested = 0, outside = 0;
  std::size_t folds = 0;
  std::size_t crossing = 0;  ///< patches inside another part of the surface
  std::size_t coarse = 0;    ///< patches of the ball surface that miss its shape
  int rounds = 0;            ///< rounds of halving the cubes below patches of the ball surface
};

/// Figures of a skin: its control mesh, and its distance from the sections.
struct SkinInfo {
  std::size_t sections = 0;
  std::string method;                        ///< "smooth", "anchored" or "pleat"
  std::size_t rows = 0, columns = 0;         ///< size of the control mesh; columns only for a regular grid
  std::map<std::string, int> extraordinary;  ///< as in `ControlMeshFigures`
  std::size_t creases = 0, regular_faces = 0;
  std::optional<double> condition;   ///< condition number of the limit matrix; nothing where it is singular
  std::vector<double> section_miss;  ///< largest distance of the surface's curve from each section
};

/// Figures of an outline: its inner control points.
struct OutlineInfo {
  std::string method;
  std::size_t loops = 0, points = 0, inserted = 0;
  double gap = 0;  ///< see `ControlPoints`
};

/// Figures of an object. Members that do not exist, or are unknown because of an error, are empty. Lengths
/// are in the document's unit, after the object's transform.
struct ObjectInfo {
  std::string name, kind;
  std::optional<std::size_t> vertices, edges, faces, patches, components, genus, boundary_loops;
  std::optional<double> area, volume, bending, largest_gap, largest_normal_jump, rms_curvature_jump;
  std::optional<CurvatureRange> gauss_range, mean_range;
  std::optional<std::size_t> degenerate_samples, folded_samples;
  /// Number of places, where there are live copies; area, volume and bending are those of all of them.
  std::optional<std::size_t> places;
  std::optional<EnvelopeInfo> envelope;
  std::optional<SkinInfo> skin;
  std::optional<OutlineInfo> outline;
  /// Comparison with another document's object, present where it was requested; empty inside where that
  /// document has no such object, or one of the two has no surface.
  std::optional<std::optional<SurfaceComparison>> against;
  std::vector<Message> messages;
  std::vector<std::pair<std::string, double>> milliseconds;  ///< step and time

  /// Whether there is an error among the messages.
  bool failed() const;
};

/// Measures an object. `against`: document whose object of the same id it is compared with, or null.
ObjectInfo inspect(const Document& document, const Object& object, const Document* against = nullptr);
/// Figures that need no measuring: name, kind, and the counts of polyhedra and nets.
ObjectInfo inspect_at_once(const Object& object);
/// Figures of a mesh file that makes no polyhedron.
ObjectInfo inspect_broken(const OpenedFile& input);

/// Report as JSON, {"objects": [...], "groups": [...], "dimensions": [...]}, with the keys of docs/cli.md.
std::string info_json(const std::vector<ObjectInfo>& objects, const std::vector<GroupInfo>& groups,
                      const std::vector<DimensionInfo>& dimensions);
/// Report as text, one line for each value.
std::string info_text(const std::vector<ObjectInfo>& objects);
/// First lines of an object's text report, up to the first value that is not known yet.
std::string info_head(const ObjectInfo& object);

}  // namespace hariko
