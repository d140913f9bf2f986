#pragma once

// Requests and results of the meshing panel: triangles of the active object under tolerances, and maps of
// their errors. Values; the application makes the meshes on a worker.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/approximation/mesh_options.hpp"
#include "core/document/document.hpp"
#include "render/color_map.hpp"
#include "render/display_mesh.hpp"
#include "render/surface_lines.hpp"
#include "ui/base/job.hpp"
#include "ui/editor/view_layout.hpp"

namespace hariko {

/// In the order of the panel's rows.
enum class MeshCriterion : std::uint8_t { distance, normal, fold, luminance, edge, angle };
inline constexpr std::size_t mesh_criterion_count = 6;

struct MeshingSettings {
  struct Tolerance {
    bool on = false;
    double value = 0;  ///< in the document's unit, or degrees, or brightness
    friend bool operator==(const Tolerance&, const Tolerance&) = default;
  };
  std::array<Tolerance, mesh_criterion_count> tolerances{
      {{true, 0}, {false, 10}, {false, 15}, {false, 0.1}, {false, 0}, {false, 10}}};
  MeshStart start = MeshStart::patches;
  SplitRule split = SplitRule::midpoint;
  bool optimise = false, balanced = false;
  bool compare = false;  ///< also the meshes of distance alone and of normal angle alone

  Tolerance& of(MeshCriterion criterion) { return tolerances[std::size_t(criterion)]; }
  const Tolerance& of(MeshCriterion criterion) const { return tolerances[std::size_t(criterion)]; }
  /// Lengths are divided by `scale`, from the document's space to an object's.
  MeshOptions options(double scale) const;
  friend bool operator==(const MeshingSettings&, const MeshingSettings&) = default;
};

/// Quantity that colours the facets. The last three are kinds of error.
enum class MeshShown : std::uint8_t { facets, distance, normal, fold };
/// A distance or an angle with its unit. Three digits are enough for a glance.
std::string short_text(MeshShown shown, double value, Unit unit);
inline constexpr std::size_t mesh_error_count = 3;

/// One kind of error over a mesh, ready to be drawn. Numbers in the document's unit or degrees.
struct MeshErrors {
  std::shared_ptr<const DisplayMesh> mesh;  ///< values above the tolerance are undefined
  ValueRange range;                         ///< range of the colours: from 0 to the tolerance or the largest
  std::vector<float> histogram;             ///< over the range; the largest part is 1
  std::size_t beyond = 0;                   ///< facets above the tolerance
  bool limited = false;                     ///< the range ends at a tolerance
  double largest = 0, mean = 0;
  std::optional<double> bound;      ///< certain
  Vector3 place = Vector3::Zero();  ///< place of the largest, in the object's space
};

struct MeshPreview {
  std::size_t facets = 0, vertices = 0;
  std::shared_ptr<const DisplayMesh> mesh;  ///< without values
  std::shared_ptr<const FacetLines> edges;
  std::array<MeshErrors, mesh_error_count> errors;
  bool reached = true;
  double milliseconds = 0;
  std::vector<Message> warnings;

  const MeshErrors& of(MeshShown shown) const { return errors[std::size_t(shown) - 1]; }
};

/// Result of one request; immutable once it is made.
struct MeshingResult {
  std::shared_ptr<const Object> object;
  MeshingSettings settings;
  std::optional<Message> error;  ///< then there is no mesh
  MeshPreview mesh;
  /// The paper's comparison: made by distance, made by normal angle.
  std::optional<std::array<MeshPreview, 2>> compared;
};

/// The panel's state. One an editor.
struct Meshing {
  bool open = false;
  MeshingSettings settings;
  double size = 0;  ///< size of the object that lengths were chosen for
  MeshShown shown = MeshShown::facets;
  bool alone = false;                           ///< facets in the surface's place, not their edges over it
  std::shared_ptr<const MeshingResult> result;  ///< the last one, maybe of earlier settings
  std::shared_ptr<const Job> job;               ///< runs; null when nothing does
  bool stopped = false;                         ///< by the user, until something changes
  std::optional<ViewLayout> kept_layout;        ///< the views from before the comparison

  /// The result to draw in an object's place; null where there is none of it as it is now.
  const MeshingResult* shown_for(const std::shared_ptr<const Object>& object) const {
    return open && result && !result->error && result->object == object ? result.get() : nullptr;
  }
  /// Four pictures are shown.
  bool comparing() const { return open && settings.compare; }
};

/// The object that is meshed: the active one, else the first visible one that can be; null when there is
/// none.
std::shared_ptr<const Object> meshed_object(const Document& document, ObjectId active);

/// One of the four pictures, by view: the mesh made by distance or by normal angle, with either error.
struct ComparedPicture {
  std::size_t mesh = 0;
  MeshShown shown = MeshShown::distance;
};
ComparedPicture compared_picture(std::size_t place);

}  // namespace hariko
