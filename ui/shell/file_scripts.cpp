// Files by their names, as scripts open, save and export them.

#include <limits>
#include <numbers>
#include <utility>

#include "core/base/files/file_ending.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "core/document/words.hpp"
#include "core/exchange/mesh_file.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/files/export_settings.hpp"
#include "ui/shell/shell_commands.hpp"
#include "ui/widgets/application_services.hpp"

namespace hariko {

namespace {

constexpr const char* list_remedy = "`hariko run --list` says what each command takes.";
constexpr double least_factor = 1e-9, most_factor = 1e9;
constexpr int usual_density = 8, most_density = 256;

std::vector<std::string> units() {
  return enum_word_list<Unit>();
}

Unit unit_named(const std::string& word) {
  return enum_value<Unit>(word).value_or(Unit::millimetre);
}

Message wrong_ending(const std::string& path, std::string_view endings) {
  return make_error(e_argument, "\"" + path + "\" must end in " + std::string(endings) + ".", list_remedy);
}

/// Arguments of all exports.
std::vector<ArgumentSpec> arguments_to_export(std::vector<ArgumentSpec> own) {
  own.insert(own.begin(), path_argument("path", "of the file; its ending says the format"));
  own.push_back(optional(word_argument("unit", "of the numbers in the file", units(), {})));
  own.push_back(number_argument("scale", "multiplies all lengths", 1, least_factor, most_factor));
  own.push_back(on_off_argument("selected", "the chosen objects only", false));
  own.push_back(length_argument("thickness", "of walls, which make closed bodies", 0, 0));
  own.push_back(
      word_argument("side", "of the surface on which walls are", enum_word_list<WallSide>(), "inside"));
  own.push_back(length_argument("offset", "moves the surface first, outwards", 0));
  return own;
}

Wall wall_of(const Arguments& given) {
  return {given.number("offset"), given.number("thickness"),
          enum_value<WallSide>(given.text("side")).value_or(WallSide::inside)};
}

/// Message about choices that the format of the file does not leave open; nothing where it does.
std::optional<Message> unfit(const std::filesystem::path& path, const FileChoices& choices) {
  const auto format = written_format(path);
  if (!format) return wrong_ending(path.string(), written_mesh_endings);
  if (choices.ascii && !format->encoding)
    return make_error(e_argument, "\"ascii\" is for STL and PLY.", list_remedy);
  if (choices.unit && !format->unit)
    return make_error(e_argument, "glTF files are always in metres.", list_remedy);
  if (choices.y_up && !format->up)
    return make_error(e_argument, "The format says which axis is up.", list_remedy);
  return {};
}

void export_triangles(CommandHost& host, const Arguments& given) {
  ExportSettings settings;
  settings.by = given.has("distance") ? ExportSettings::By::tolerance : ExportSettings::By::density;
  if (given.has("distance")) settings.distance = given.number("distance");
  if (given.has("angle")) settings.angle = given.number("angle") * std::numbers::pi / 180;
  settings.density = given.has("density") ? given.whole("density") : usual_density;
  if (given.has("density") && given.has("distance"))
    return host.editor.notify(make_error(
        e_argument, "Triangles are made by \"density\" or by \"distance\", not by both.", list_remedy));
  if (given.has("angle") && !given.has("distance"))
    return host.editor.notify(
        make_error(e_argument, "\"angle\" is for triangles by \"distance\".", list_remedy));
  FileChoices& choices = settings.choices;
  if (given.has("unit")) choices.unit = unit_named(given.text("unit"));
  choices.scale = given.number("scale");
  choices.y_up = given.text("up") == "y";
  choices.to_zero = given.text("origin") == "zero";
  choices.ascii = given.on("ascii");
  settings.only_selected = given.on("selected");
  settings.wall = wall_of(given);
  if (const auto why = unfit(given.text("path"), choices)) return host.editor.notify(*why);
  host.application.export_file(given.text("path"), settings);
}

void export_for_cad(CommandHost& host, const Arguments& given) {
  const std::string& path = given.text("path");
  if (!cad_format_of(path)) return host.editor.notify(wrong_ending(path, cad_endings));
  CadSettings settings;
  CadChoices& choices = settings.choices;
  choices.quality = enum_value<CadQuality>(given.text("quality")).value_or(CadQuality::balanced);
  if (given.has("tolerance")) choices.tolerance = given.number("tolerance");
  if (given.has("angle")) choices.angle = given.number("angle") * std::numbers::pi / 180;
  if (given.has("unit")) choices.unit = unit_named(given.text("unit"));
  choices.scale = given.number("scale");
  choices.exact = given.on("exact");
  choices.whole_faces = given.on("whole_faces");
  choices.ap242 = given.on("ap242");
  settings.only_selected = given.on("selected");
  settings.wall = wall_of(given);
  host.application.export_cad(path, settings);
}

void save_document_as(CommandHost& host, const std::string& path, bool copy) {
  constexpr std::string_view ending = ".hariko";
  if (lower_ending(path) != ending)
    return host.editor.notify(make_error(e_argument, "\"" + path + "\" must end in .hariko.",
                                         "Other formats are written by file.export."));
  if (copy) return host.application.save_copy(path);
  host.application.save(path, {});
}

/// Saves under the name that is written, else under the document's own.
void save_as_written(CommandHost& host, const Arguments& given) {
  if (given.has("path")) return save_document_as(host, given.text("path"), false);
  if (!host.editor.path)
    return host.editor.notify(
        make_error(e_argument, "The document has no file yet: \"path\" is needed.", list_remedy));
  host.application.save(*host.editor.path, {});
}

void begin_new(Editor& editor, const Arguments& given) {
  Document document;
  document.unit = unit_named(given.text("unit"));
  editor.open(std::move(document), std::nullopt);
}

void use_exports(CommandHost& host) {
  constexpr double least = std::numeric_limits<double>::min();
  host.table.use_in_scripts(
      "file.export",
      {.arguments = arguments_to_export(
           {optional(whole_argument("density", "intervals a patch side; 8 without a distance", {}, 1,
                                    most_density)),
            optional(length_argument("distance", "largest between surface and triangles", {}, least)),
            optional(angle_argument("angle", "largest between their normals, with a distance", {})),
            word_argument("up", "axis of the file that points up", {"z", "y"}, "z"),
            word_argument("origin", "zero: the middle of all goes to zero", {"own", "zero"}, "own"),
            on_off_argument("ascii", "STL and PLY as text", false)}),
       .run = [&host](const Arguments& given) { export_triangles(host, given); }});
  host.table.use_in_scripts(
      "file.export_cad",
      {.arguments = arguments_to_export(
           {word_argument("quality", "of faces that cannot be exact", enum_word_list<CadQuality>(),
                          "balanced"),
            optional(length_argument("tolerance", "largest distance, instead of the quality's", {}, least)),
            optional(angle_argument("angle", "largest between faces, instead of the quality's", {})),
            on_off_argument("exact", "what is a spline stays it", false),
            on_off_argument("whole_faces", "faces with four sides stay one face", false),
            on_off_argument("ap242", "the newer schema of STEP", false)}),
       .run = [&host](const Arguments& given) { export_for_cad(host, given); }});
  host.table.use_in_scripts(
      "file.export_control",
      {.arguments = {path_argument("path", "of the file: *.obj")}, .run = [&host](const Arguments& given) {
         const std::string& path = given.text("path");
         if (lower_ending(path) != ".obj") return host.editor.notify(wrong_ending(path, ".obj"));
         host.application.export_control(path);
       }});
}

}  // namespace

void use_files_in_scripts(CommandHost& host) {
  CommandTable& table = host.table;
  table.use_in_scripts("file.new",
                       {.arguments = {word_argument("unit", "of the document", units(), "mm")},
                        .run = [&host](const Arguments& given) { begin_new(host.editor, given); }});
  table.use_in_scripts(
      "file.open", {.arguments = {path_argument("path", "of a document or a mesh")},
                    .run = [&host](const Arguments& given) { host.application.open(given.text("path")); }});
  table.use_in_scripts("file.import", {.arguments = {path_argument("path", "of a document or a mesh")},
                                       .run = [&host](const Arguments& given) {
                                         host.application.import_file(given.text("path"));
                                       }});
  table.use_in_scripts("file.save",
                       {.arguments = {optional(path_argument("path", "instead of the document's own file"))},
                        .run = [&host](const Arguments& given) { save_as_written(host, given); }});
  table.use_in_scripts("file.save_as", {.arguments = {path_argument("path", "of the document from now on")},
                                        .run = [&host](const Arguments& given) {
                                          save_document_as(host, given.text("path"), false);
                                        }});
  table.use_in_scripts("file.save_copy", {.arguments = {path_argument("path", "of the copy")},
                                          .run = [&host](const Arguments& given) {
                                            save_document_as(host, given.text("path"), true);
                                          }});
  use_exports(host);
}

}  // namespace hariko
