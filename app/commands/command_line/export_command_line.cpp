#include "app/commands/command_line/subcommand_lines.hpp"

#include <CLI/CLI.hpp>
#include <numbers>

#include "app/commands/command_line/checks.hpp"
#include "core/base/files/file_ending.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "core/exchange/mesh_file.hpp"

namespace hariko {

void ExportCommandLine::add_to(CLI::App& app) {
  command_ =
      app.add_subcommand("export", "Writes the surfaces of the visible objects, as triangles or for CAD");
  command_->add_option("FILE", arguments_.file, "Document or mesh")->required();
  command_
      ->add_option(
          "OUT", arguments_.out,
          "File to write: *.obj, *.off, *.ply, *.stl, *.3mf, *.glb, *.gltf, *.step, *.stp, *.iges or *.igs")
      ->required();
  density_ =
      command_->add_option("--density", arguments_.density, "Of triangles: intervals a patch side, 1 to 256")
          ->check(CLI::Range(1, 256))
          ->capture_default_str();
  cad_options_ = {
      command_
          ->add_option("--tolerance", arguments_.cad.tolerance,
                       "Of STEP and IGES: between the surface and faces that cannot be exact, in the "
                       "document's unit; as --quality says otherwise")
          ->check(positive_number()),
      command_
          ->add_option(
              "--angle", angle_,
              "Of STEP and IGES: between faces along smooth edges, degrees; as --quality says otherwise")
          ->check(CLI::Range(0.001, 10.0)),
      command_
          ->add_option(
              "--quality", quality_,
              "Of STEP and IGES: light (0.05 mm, 0.2 degrees), balanced (0.01 mm, 0.1 degrees) or fine "
              "(0.001 mm, 0.02 degrees); more where an object is larger than 100 mm")
          ->check(CLI::IsMember(enum_word_list<CadQuality>())),
      command_->add_flag(
          "--exact", arguments_.cad.exact,
          "Of STEP and IGES: what is a spline stays it, also where fewer control points would do"),
      command_->add_flag(
          "--whole-faces", arguments_.cad.whole_faces,
          "Of STEP and IGES: a face of a polyhedron with four sides stays one face, also where "
          "several weigh less"),
      command_->add_flag("--ap242", arguments_.cad.ap242, "STEP in the newer schema AP242, not AP214")};
  command_->add_flag("--control", arguments_.control,
                     "Writes the control meshes of skins, with creases, as OBJ instead");
  file_options_.add_to(command_);
}

void ExportCommandLine::check() const {
  const bool cad = cad_format_of(arguments_.out).has_value();
  if (!cad && !written_format(arguments_.out))
    throw CLI::ValidationError("OUT", "the name must end in " + std::string(written_mesh_endings) +
                                          ", or in " + std::string(cad_endings));
  check_distinct(arguments_.file, arguments_.out);
  file_options_.check(arguments_.out);
  if (cad && *density_)
    throw CLI::ValidationError("--density", "is for triangles; STEP and IGES have a --tolerance");
  if (cad && file_options_.arguments().choices.y_up)
    throw CLI::ValidationError("--up", "z is up in STEP and IGES");
  for (const CLI::Option* option : cad_options_)
    if (!cad && *option) throw CLI::ValidationError(option->get_name(), "is for STEP and IGES");
  if (arguments_.control && lower_ending(arguments_.out) != ".obj")
    throw CLI::ValidationError("--control", "the name must end in .obj");
  if (arguments_.control && !file_options_.arguments().wall.none())
    throw CLI::ValidationError("--control", "control meshes have no --offset and no --thickness");
}

ExportArguments ExportCommandLine::arguments(const Construction& construction) const {
  ExportArguments out = arguments_;
  out.cad.quality = enum_value<CadQuality>(quality_).value_or(CadQuality::balanced);
  out.cad.angle = angle_ * std::numbers::pi / 180;
  out.file_arguments = file_options_.arguments();
  out.construction = construction;
  return out;
}

}  // namespace hariko
