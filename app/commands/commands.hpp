#pragma once

// The subcommands, with their arguments already parsed. Each returns its exit code.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/files/model_facets.hpp"
#include "app/files/reading.hpp"
#include "core/approximation/mesh_options.hpp"
#include "core/document/cad_choices.hpp"
#include "core/document/display.hpp"
#include "core/document/file_choices.hpp"
#include "core/gaussmap/outline_settings.hpp"
#include "core/network/shaping.hpp"
#include "core/unfolding/unfolding.hpp"
#include "render/camera.hpp"
#include "render/scene.hpp"

namespace hariko {

inline constexpr int exit_fine = 0, exit_failed = 1, exit_usage = 2;

/// What is chosen for all outlines, instead of what the document says (`OutlineSettings`).
struct OutlineConstruction {
  std::optional<GaussMode> method;
  std::optional<CurvatureSign> sign;
  std::optional<double> radius, gap;
  std::optional<Index> most_points;
  friend bool operator==(const OutlineConstruction&, const OutlineConstruction&) = default;
};

/// Choices for all surfaces round solids, instead of the document's own (`EnvelopeSettings`).
struct SolidsConstruction {
  std::optional<EnvelopeMethod> method;
  std::optional<double> ball_radius;  ///< infinite: the hull
  std::optional<double> rounding;
  std::optional<bool> on_faces, finer_patches;
  std::optional<double> bridge_radius;  ///< of the balls between bridged solids
  friend bool operator==(const SolidsConstruction&, const SolidsConstruction&) = default;
};

/// How surfaces are made, instead of what the document says, and from what.
struct Construction {
  std::optional<Mode> mode;                 ///< of polyhedra; of outlines, where it is `fair` or `g2`
  std::optional<Frames> frames = {};        ///< of polyhedra
  std::optional<bool> merge_coplanar = {};  ///< of polyhedra: faces in one plane
  OutlineConstruction outlines = {};
  SolidsConstruction solids = {};
  Reading reading = {};
  friend bool operator==(const Construction&, const Construction&) = default;
};

/// What of the document is written, and how its numbers stand there.
struct FileArguments {
  FileChoices choices;
  std::vector<std::string> only;  ///< names of objects; empty: all visible ones
};

struct InfoArguments {
  std::filesystem::path file;
  std::optional<std::filesystem::path> against;  ///< document to compare surfaces with
  bool json = false;
  Construction construction;
};
int run_info(const InfoArguments& arguments);

struct ExportArguments {
  std::filesystem::path file, out;
  int density = 8;       ///< 1 .. 256
  bool control = false;  ///< the control meshes of skins instead of triangles
  FileArguments file_arguments;
  CadChoices cad;  ///< of STEP and IGES
  Construction construction;
};
int run_export(const ExportArguments& arguments);

struct RenderArguments {
  std::filesystem::path file, out;
  int width = 1280, height = 960;
  StandardView view = StandardView::iso;
  SurfaceMap map = SurfaceMap::shaded;
  MapRange range;
  bool polyhedron = false, network = false, marks = false, combs = false, tensions = false;
  PatchWire wire = PatchWire::none;
  std::optional<Material> material;  ///< instead of each object's own
  std::optional<Colour> colour;      ///< likewise
  Background background = Background::dark;
  std::optional<SectionPlane> section;
  Construction construction;
  int stripes = 9;
  bool colour_blind_safe = false;
};
int run_render(const RenderArguments& arguments);

struct MeshArguments {
  std::filesystem::path file, out;
  MeshOptions options;           ///< lengths in the document's unit
  std::filesystem::path errors;  ///< where error maps are written; empty: nowhere
  FileArguments file_arguments;
  bool json = false;
  Construction construction;
};
int run_mesh(const MeshArguments& arguments);

struct EvaluateArguments {
  std::filesystem::path file;
  Construction construction;
  std::optional<std::filesystem::path> tension;
};
int run_evaluate(const EvaluateArguments& arguments);

/// Real size of the model along an axis: 0 width (x), 1 depth (y), 2 height (z).
struct PaperModelSize {
  int axis = 2;
  double millimetres = 0;
};

struct UnfoldArguments {
  std::filesystem::path file;
  std::vector<std::filesystem::path> outs;
  FacetOptions facets;  ///< of a document's surfaces
  Reading reading;
  std::optional<PaperModelSize> size;  ///< otherwise lengths are as in the file
  bool fit = false;                    ///< the largest model of which no facet is larger than the page
  PaperSettings settings;              ///< but for the scale
  UnfoldOptions options;
  bool json = false;
};
int run_unfold(const UnfoldArguments& arguments);

/// For the build: pictures of the samples in `assets`, in the folder `out`. Without OpenGL there are none,
/// which is said and is no failure: the program draws them when it shows them.
int run_sample_pictures(const std::filesystem::path& assets, const std::filesystem::path& out);

}  // namespace hariko
