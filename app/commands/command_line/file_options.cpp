#include "app/commands/command_line/file_options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>

#include "core/document/words.hpp"
#include "core/exchange/mesh_file.hpp"

namespace hariko {

void FileOptions::add_to(CLI::App* command) {
  command
      ->add_option("--unit", unit_, "Of the numbers in the file: mm, cm, m or in, instead of the document's")
      ->check(CLI::IsMember(enum_word_list<Unit>()));
  command->add_option("--scale", scale_, "Multiplies all lengths")->capture_default_str();
  command->add_option("--up", up_, "Axis of the file that points up: z (default) or y")
      ->check(CLI::IsMember({"y", "z"}));
  command
      ->add_option("--origin", origin_,
                   "zero: moves the middle of all that is written to zero; own (default): coordinates stay")
      ->check(CLI::IsMember({"own", "zero"}));
  command->add_flag("--ascii", ascii_, "STL and PLY as text instead of binary");
  command
      ->add_option("--only", only_, "Name of an object to write instead of all visible ones; may be repeated")
      ->type_size(1)
      ->allow_extra_args(false);
  command->add_option(
      "--offset", wall_.offset,
      "Writes the surfaces at this distance instead, in the document's unit; below 0: inside");
  command->add_option("--thickness", wall_.thickness,
                      "Writes closed bodies with walls of this thickness instead, in the document's unit");
  command
      ->add_option("--side", side_,
                   "Of the surface where the thickness is: inside (default), outside or both")
      ->check(CLI::IsMember(enum_word_list<WallSide>()));
}

void FileOptions::check(const std::filesystem::path& out) const {
  if (!(scale_ > 0) || !std::isfinite(scale_))
    throw CLI::ValidationError("--scale", "must be a number above 0");
  if (!std::isfinite(wall_.offset)) throw CLI::ValidationError("--offset", "must be a number");
  if (!(wall_.thickness >= 0) || !std::isfinite(wall_.thickness))
    throw CLI::ValidationError("--thickness", "must be a number above 0");
  if (!side_.empty() && wall_.thickness == 0) throw CLI::ValidationError("--side", "is for a --thickness");
  const auto format = written_format(out);
  if (ascii_ && !(format && format->encoding)) throw CLI::ValidationError("--ascii", "is for STL and PLY");
  if (!format) return;
  if (!unit_.empty() && !format->unit)
    throw CLI::ValidationError("--unit", "glTF files are always in metres");
  if (!up_.empty() && !format->up)
    throw CLI::ValidationError("--up", "the format says which axis is up: y in glTF, z in 3MF");
}

FileArguments FileOptions::arguments() const {
  FileArguments out;
  out.choices.unit = enum_value<Unit>(unit_);
  out.choices.scale = scale_;
  out.choices.y_up = up_ == "y";
  out.choices.ascii = ascii_;
  out.choices.to_zero = origin_ == "zero";
  out.only = only_;
  out.wall = wall_;
  out.wall.side = enum_value<WallSide>(side_).value_or(WallSide::inside);
  return out;
}

}  // namespace hariko
