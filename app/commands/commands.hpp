#pragma once

// Commands with parsed arguments. Each returns its exit code.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/files/model_facets.hpp"
#include "app/files/reading.hpp"
#include "core/approximation/mesh_options.hpp"
#include "core/document/display.hpp"
#include "core/document/format/cad_choices.hpp"
#include "core/document/format/file_choices.hpp"
#include "core/drawing/section_set.hpp"
#include "core/drawing/write_drawing_svg.hpp"
#include "core/gaussmap/outlines/outline_settings.hpp"
#include "core/network/shaping.hpp"
#include "core/offset/offset_surface.hpp"
#include "core/unfolding/unfolding.hpp"
#include "render/camera.hpp"
#include "render/scene.hpp"

namespace hariko {

/// Exit codes of the program.
inline constexpr int exit_fine = 0, exit_failed = 1, exit_usage = 2;

/// Choices for all outlines, instead of the document's own (`OutlineSettings`).
struct OutlineConstruction {
  std::optional<GaussMode> method;
  bool method_replaced = false;  ///< see `OutlineSettings::mode_replaced`
  std::optional<CurvatureSign> sign;
  std::optional<double> radius, gap;
  std::optional<Index> most_points;
  friend bool operator==(const OutlineConstruction&, const OutlineConstruction&) = default;
};

/// Choices for all surfaces round solids, instead of the document's own (`EnvelopeSettings`).
struct SolidsConstruction {
  std::optional<EnvelopeMethod> method;
  std::optional<double> ball_radius;  ///< infinite: the convex hull
  std::optional<double> rounding;
  std::optional<bool> on_faces, finer_patches;
  std::optional<double> bridge_radius;  ///< radius of the balls between bridged solids
  friend bool operator==(const SolidsConstruction&, const SolidsConstruction&) = default;
};

/// Construction of all surfaces, instead of the document's own, and reading of meshes.
struct Construction {
  std::optional<Mode> mode;                 ///< mode of polyhedra, and of outlines where it is `fair` or `g2`
  std::optional<Frames> frames = {};        ///< frames of polyhedra and outlines
  std::optional<bool> merge_coplanar = {};  ///< merging of coplanar faces of polyhedra
  OutlineConstruction outlines = {};
  SolidsConstruction solids = {};
  Reading reading = {};
  friend bool operator==(const Construction&, const Construction&) = default;
};

/// Objects to write, and the unit and placement of their coordinates.
struct FileArguments {
  FileChoices choices;
  std::vector<std::string> only;  ///< names of objects; empty: all visible objects
  Wall wall = {};                 ///< distance and thickness, in the document's unit
};

/// Arguments of `hariko info`.
struct InfoArguments {
  std::filesystem::path file;
  std::optional<std::filesystem::path> against;  ///< document to compare surfaces with
  bool json = false;
  Construction construction;
};
/// Describes a file's objects.
int run_info(const InfoArguments& arguments);

/// Arguments of `hariko export`.
struct ExportArguments {
  std::filesystem::path file, out;
  int density = 8;       ///< 1 .. 256
  bool control = false;  ///< writes the control meshes of skins instead of triangles
  FileArguments file_arguments;
  CadChoices cad;  ///< for STEP and IGES
  Construction construction;
};
/// Writes a document's surfaces in a format of other programs.
int run_export(const ExportArguments& arguments);

/// Arguments of `hariko render` for pictures.
struct RenderArguments {
  std::filesystem::path file, out;
  int width = 1280, height = 960;
  StandardView view = StandardView::iso;
  std::string saved_view;  ///< name of a saved view, instead of `view`; empty for none
  SurfaceMap map = SurfaceMap::shaded;
  MapRange range;
  bool polyhedron = false, network = false, marks = false, combs = false, tensions = false;
  PatchWire wire = PatchWire::none;
  std::optional<Material> material;  ///< instead of each object's own
  std::optional<Colour> colour;      ///< instead of each object's own
  Background background = Background::dark;
  std::optional<SectionPlane> section;
  Construction construction;
  int stripes = 9;
  std::string environment;  ///< word of an EnvironmentKind, or a file; empty: materials in their studio
  double environment_turn = 0, exposure = 0;  ///< degrees and stops
  bool colour_blind_safe = false;
  // For maps of making; nothing or empty: as the document has it.
  std::optional<Vector3> pull;  ///< not zero
  std::optional<double> limit;  ///< degrees, or a length in the document's unit
  std::string reference;        ///< name of an object
};
/// Draws a picture of a document.
int run_render(const RenderArguments& arguments);

/// Arguments of `hariko mesh`.
struct MeshArguments {
  std::filesystem::path file, out;
  MeshOptions options;           ///< lengths in the document's unit
  std::filesystem::path errors;  ///< file for the error maps; empty: none
  FileArguments file_arguments;
  bool json = false;
  Construction construction;
};
/// Writes a document's surfaces as triangles under tolerances.
int run_mesh(const MeshArguments& arguments);

/// Arguments of `hariko evaluate`.
struct EvaluateArguments {
  std::filesystem::path file;
  Construction construction;
  std::optional<std::filesystem::path> tension;
};
/// Prints the numbers of surfaces as JSON, for checks against other implementations.
int run_evaluate(const EvaluateArguments& arguments);

/// Real size of the model along an axis: 0 width (x), 1 depth (y), 2 height (z).
struct PaperModelSize {
  int axis = 2;
  double millimetres = 0;
};

/// Arguments of `hariko unfold`.
struct UnfoldArguments {
  std::filesystem::path file;
  std::vector<std::filesystem::path> outs;
  FacetOptions facets;  ///< for a document's surfaces
  Reading reading;
  std::optional<PaperModelSize> size;  ///< nothing: lengths as in the file
  bool fit = false;        ///< chooses the largest scale at which no facet is larger than the page
  PaperSettings settings;  ///< the scale in it is ignored
  UnfoldOptions options;
  bool json = false;
};
/// Unfolds a model to sheets of paper.
int run_unfold(const UnfoldArguments& arguments);

/// Arguments of `hariko run`.
struct ScriptArguments {
  std::filesystem::path file;                    ///< the script
  std::optional<std::filesystem::path> in, out;  ///< documents to begin with and to save at the end
  Reading reading;                               ///< choices for all files that it opens
};
/// Runs a script. What is wrong with its steps is found before the first of them runs where that is possible.
int run_script(const ScriptArguments& arguments);
/// Prints the commands that scripts may run.
int run_command_list(bool json);

/// Draws the pictures of the samples in `assets` into the folder `out`, for the build. Without OpenGL it
/// draws none, prints a note and succeeds: the program then draws them when it shows them.
int run_sample_pictures(const std::filesystem::path& assets, const std::filesystem::path& out);

/// Line drawing of the same objects and view as `run_render`.
struct DrawingArguments {
  std::filesystem::path file, out;
  double width = 1280, height = 960;  ///< pixels of 1/96 inch
  PageUnit unit = PageUnit::pixel;    ///< unit of the file
  StandardView view = StandardView::iso;
  std::string saved_view;  ///< name of a saved view, instead of `view`; empty for none
  std::optional<SectionPlane> section;
  LineDrawingSettings lines;
  Construction construction;
};
/// Writes a line drawing of a document.
int run_drawing(const DrawingArguments& arguments);

/// Arguments of `hariko sections`.
struct SectionsArguments {
  std::filesystem::path file, out;       ///< `out`: *.svg or *.dxf
  Vector3 direction = Vector3::UnitX();  ///< not zero
  std::optional<double> first, spacing;  ///< document's unit; missing ones spread the planes over the model
  int count = 7;
  SectionCombs combs;
  std::vector<std::string> only;  ///< names of objects; empty: all visible objects
  bool json = false;
  Construction construction;
};
/// Writes the curves in which planes cut a document's surfaces and reference facets.
int run_sections(const SectionsArguments& arguments);

}  // namespace hariko
