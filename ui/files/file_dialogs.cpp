#include "ui/files/file_dialogs.hpp"

#include <imgui.h>

#include <array>
#include <utility>

#include "core/base/files/file_ending.hpp"
#include "core/base/files/file_io.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "render/reference_image.hpp"
#include "ui/files/key_file.hpp"
#include "ui/view/viewport.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/option_fields.hpp"

namespace hariko {

namespace {

/// Options of meshes that are read: what they become. Marks: "import.use", "import.use.<number>",
/// "import.creases", "import.crease_angle".
void draw_mesh_options(PanelContext& context, const std::filesystem::path&) {
  const Language& tr = context.tr;
  MeshImport& choice = context.editor.mesh_import;
  option_label(context, "Meshes");
  const std::array<std::string, 3> uses{tr("Cage, asked about above 5,000 faces"), tr("Cage"),
                                        tr("Reference facets")};
  if (const auto chosen =
          option_list(context, "import.use", 300, uses, static_cast<std::size_t>(choice.use), {},
                      "A cage gets a surface. Reference facets are to be traced and measured."))
    choice.use = static_cast<MeshUse>(*chosen);
  option_label(context, "");
  option_check(context, "import.creases", "Crease edges above",
               "Edges where faces meet at more than this angle become sharp edges of the surface.",
               choice.creases);
  ImGui::SameLine();
  number_input(context.marks, "import.crease_angle", context.metrics.px(70), {0, 180, "%.4g\u00b0"},
               choice.crease_degrees);
  if (ImGui::IsItemDeactivatedAfterEdit()) choice.creases = true;
}

}  // namespace

std::vector<std::string> importable_endings(bool cad) {
  std::vector<std::string> out{".obj", ".off", ".ply", ".stl", ".glb", ".gltf", ".3mf", ".bpt", ".json"};
  if (cad) out.insert(out.end(), {".step", ".stp", ".iges", ".igs"});
  return out;
}

std::vector<std::string> openable_endings(bool cad) {
  std::vector<std::string> out = importable_endings(cad);
  out.insert(out.begin(), ".hariko");
  return out;
}

FileDialogs::FileDialogs(Editor& editor, const Viewport& viewport, ApplicationServices& application)
    : editor_(editor), viewport_(viewport), application_(application) {}

void FileDialogs::draw(PanelContext& context) {
  dialog_.draw(context);
  if (!dialog_.is_open() && std::exchange(counting_, false)) application_.cancel_count();
}

ExportMemory FileDialogs::remembered() const {
  return {export_options_.remembered(), cad_options_.settings().choices, picture_settings_,
          drawing_options_.settings(), folders_};
}

void FileDialogs::remember(ExportMemory memory) {
  export_options_.remember(std::move(memory.formats));
  cad_options_.remember(memory.cad);
  picture_settings_ = memory.picture;
  drawing_options_.remember(memory.drawing);
  folders_ = std::move(memory.folders);
}

void FileDialogs::forget_choices() {
  dialog_ = {};
  export_options_ = {};
  cad_options_ = {};
  picture_settings_ = {};
  drawing_options_ = {};
  folders_.clear();
}

void FileDialogs::show(const std::string& kind, FileDialog::Request request) {
  std::error_code unknown;
  if (const auto last = folders_.find(kind);
      last != folders_.end() && std::filesystem::is_directory(last->second, unknown))
    request.proposal =
        request.saving ? last->second / request.proposal.filename() : std::filesystem::path(last->second);
  request.accept = [this, kind, saving = request.saving,
                    accept = std::move(request.accept)](const auto& path) {
    const std::filesystem::path folder = path.parent_path();
    // A file that is written beside the document stays beside it.
    if (saving && editor_.path && folder == editor_.path->parent_path())
      folders_.erase(kind);
    else
      folders_[kind] = folder.string();
    accept(path);
  };
  dialog_.open(std::move(request));
}

void FileDialogs::save_as(std::function<void()> then) {
  dialog_.open({translatable("Save as"),
                translatable("Save"),
                true,
                {".hariko"},
                name_proposal(),
                [this, then = std::move(then)](const auto& path) { application_.save(path, then); }});
}

void FileDialogs::save_copy() {
  const std::filesystem::path name = name_proposal();
  std::filesystem::path copy = fill(editor_.language("{0} copy"), {name.stem().string()});
  copy += name.extension();
  dialog_.open({translatable("Save a copy"),
                translatable("Save"),
                true,
                {".hariko"},
                name.parent_path() / copy,
                [this](const auto& path) { application_.save_copy(path); }});
}

void FileDialogs::save(const std::string& kind, std::string title, const char* action,
                       std::vector<std::string> endings, std::filesystem::path proposal, TakePath accept,
                       DrawOptions options) {
  show(kind, {std::move(title), action, true, std::move(endings), std::move(proposal), std::move(accept),
              std::move(options)});
}

void FileDialogs::choose(const std::string& kind, std::string title, const char* action,
                         std::vector<std::string> endings, TakePath accept, DrawOptions options) {
  show(kind, {std::move(title), action, false, std::move(endings), folder_proposal(), std::move(accept),
              std::move(options)});
}

void FileDialogs::export_triangles() {
  const std::filesystem::path proposal = export_proposal(".obj");
  save(
      "triangles", translatable("Export the surfaces as triangles"), translatable("Export"),
      {".obj", ".stl", ".3mf", ".ply", ".glb", ".gltf", ".off"}, proposal,
      [this](const auto& path) { application_.export_file(path, export_options_.settings()); },
      [this](PanelContext& context, const std::filesystem::path& name) {
        if (export_options_.draw(context, name)) application_.count_export(name, export_options_.settings());
      });
  export_options_.begin(editor_, proposal);
  application_.count_export(proposal, export_options_.settings());
  counting_ = true;
}

void FileDialogs::export_cad() {
  save(
      "cad", translatable("Export the surfaces for CAD"), translatable("Export"),
      {".step", ".stp", ".iges", ".igs"}, export_proposal(".step"),
      [this](const auto& path) { application_.export_cad(path, cad_options_.settings()); },
      [this](PanelContext& context, const std::filesystem::path& name) {
        if (cad_options_.draw(context, name)) application_.count_cad(cad_options_.settings());
      });
  cad_options_.begin(editor_);
  application_.count_cad(cad_options_.settings());
  counting_ = true;
}

void FileDialogs::export_control() {
  save("control", translatable("Export the control meshes of skins"), translatable("Export"), {".obj"},
       export_proposal(" control.obj"), [this](const auto& path) { application_.export_control(path); });
}

void FileDialogs::write_picture(const std::filesystem::path& path, bool turntable) {
  if (!turntable) picture_ending_ = lower_ending(path);
  if (!turntable && picture_ending_ == ".svg") {
    auto order = order_drawing(editor_, viewport_.scene(), drawing_options_.settings(), path);
    if (!order) return editor_.notify(order.error());
    return application_.export_drawing(std::move(order).value());
  }
  auto order = turntable ? order_turntable(editor_, viewport_.scene(), picture_settings_, path)
                         : order_picture(editor_, viewport_.scene(), picture_settings_, path);
  if (!order) return editor_.notify(order.error());
  application_.export_pictures(std::move(order).value());
}

void FileDialogs::picture(bool turntable) {
  FileDialog::Request request;
  request.title =
      turntable ? translatable("Export a turntable as pictures") : translatable("Export a picture");
  request.action = translatable("Export");
  request.saving = true;
  request.extensions = {".png"};
  if (!turntable) request.extensions.push_back(".svg");
  request.proposal = name_proposal(turntable ? ".png" : picture_ending_.c_str());
  request.accept = [this, turntable](const auto& path) { write_picture(path, turntable); };
  request.options = [this, turntable](PanelContext& context, const std::filesystem::path& name) {
    if (!turntable && lower_ending(name) == ".svg") return drawing_options_.draw(context);
    draw_picture_options(context, picture_settings_, turntable);
  };
  if (turntable)
    request.replaces = [this](const std::filesystem::path& path) -> std::optional<std::filesystem::path> {
      std::error_code unknown;
      for (const auto& file : series_files(path, picture_settings_.turntable_pictures))
        if (std::filesystem::exists(file, unknown)) return file;
      return {};
    };
  show("picture", std::move(request));
}

void FileDialogs::open(std::function<void(const std::filesystem::path&)> accept) {
  dialog_.open({translatable("Open"), translatable("Open"), false, openable_endings(!why_no_cad_files()),
                folder_proposal(), std::move(accept), draw_mesh_options});
}

void FileDialogs::import() {
  choose(
      "import", translatable("Import"), translatable("Import"), importable_endings(!why_no_cad_files()),
      [this](const auto& path) { application_.import_file(path); }, draw_mesh_options);
}

void FileDialogs::choose_picture(std::string title, TakePath accept) {
  const auto endings = reference_endings();
  choose("reference", std::move(title), translatable("Choose"), {endings.begin(), endings.end()},
         std::move(accept));
}

void FileDialogs::add_picture() {
  choose_picture(translatable("Add reference picture"),
                 [this](const auto& path) { application_.add_pictures({path}); });
}

void FileDialogs::replace_picture(ObjectId picture) {
  choose_picture(translatable("Choose another picture"),
                 [this, picture](const auto& path) { application_.replace_picture(picture, path); });
}

void FileDialogs::find_pictures(const std::string& name) {
  editor_.show_text(name);
  choose_picture(fill(editor_.language("Where is {0}?"), {name}),
                 [this](const auto& path) { application_.find_pictures(path); });
}

void FileDialogs::unpack_picture(ObjectId picture) {
  const Object* object = editor_.document().find(picture);
  if (!object || !object->picture()) return;
  const std::filesystem::path name(object->picture()->path);
  save("reference", translatable("Save the picture as a file"), translatable("Save"),
       {is_reference_file(name) ? lower_ending(name) : std::string(".png")},
       folder_proposal() / name.filename(),
       [this, picture](const auto& path) { application_.unpack_picture(picture, path); });
}

void FileDialogs::choose_environment() {
  const auto endings = environment_endings();
  choose("environment", translatable("Choose an environment"), translatable("Choose"),
         {endings.begin(), endings.end()}, [this](const auto& path) {
           std::error_code unknown;
           const auto whole = std::filesystem::absolute(path, unknown);
           editor_.settings.environment.file = (unknown ? path : whole).string();
           editor_.show_environment(EnvironmentKind::file);
         });
}

void FileDialogs::export_keys() {
  save("keys", translatable("Export keys"), translatable("Export"), {".json"},
       folder_proposal() / "hariko-keys.json", [this](const auto& path) {
         const auto done = write_file_atomic(path, write_key_file(editor_.settings.keys));
         if (!done.ok()) return editor_.notify(done.error());
         editor_.inform({"Exported {0}.", {path.filename().string()}});
       });
}

void FileDialogs::import_keys() {
  choose("keys", translatable("Import keys"), translatable("Import"), {".json"}, [this](const auto& path) {
    constexpr std::size_t largest = 1 << 20;  // bytes; a file of keys has some kilobytes
    const auto text = read_file(path, largest);
    if (!text) return editor_.notify(text.error());
    const auto keys = read_key_file(*text);
    if (!keys) return editor_.notify(keys.error());
    editor_.settings.keys = *keys;
    editor_.inform({"The keys of {0} are in use.", {path.filename().string()}});
  });
}

void FileDialogs::export_pages() {
  save("pages", translatable("Export the pages of the paper model"), translatable("Export"),
       {".pdf", ".svg", ".dxf", ".png"}, name_proposal(".pdf"),
       [this](const auto& path) { application_.export_pages(path); });
}

void FileDialogs::export_sections() {
  save("sections", translatable("Export the section curves"), translatable("Export"), {".svg", ".dxf"},
       export_proposal(" sections.svg"), [this](const auto& path) {
         auto order = order_sections(editor_, path);
         if (!order) return editor_.notify(order.error());
         application_.export_sections(std::move(order).value());
       });
}

void FileDialogs::record() {
  save("replay", translatable("Record a replay"), translatable("Record"), {".jsonl"}, name_proposal(".jsonl"),
       [this](const auto& path) { application_.record(path); });
}

void FileDialogs::record_script() {
  save("script", translatable("Record a script"), translatable("Record"), {".json"}, name_proposal(".json"),
       [this](const auto& path) { application_.record_script(path); });
}

std::filesystem::path FileDialogs::name_proposal() const {
  if (editor_.path) return *editor_.path;
  return editor_.title() + ".hariko";
}

std::filesystem::path FileDialogs::name_proposal(const char* ending) const {
  return name_proposal().replace_extension(ending);
}

std::filesystem::path FileDialogs::export_proposal(const char* ending) const {
  const std::string stem =
      editor_.path ? editor_.path->stem().string() : std::string(editor_.language("Untitled"));
  std::filesystem::path out = folder_proposal() / stem;
  out += ending;
  return out;
}

std::filesystem::path FileDialogs::folder_proposal() const {
  return editor_.path ? editor_.path->parent_path() : std::filesystem::path();
}

}  // namespace hariko
