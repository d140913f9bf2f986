#include "ui/files/file_dialogs.hpp"

#include <utility>

#include "core/base/files/file_ending.hpp"
#include "core/base/files/file_io.hpp"
#include "core/cad/kernel/cad_file.hpp"
#include "render/reference_image.hpp"
#include "ui/files/key_file.hpp"
#include "ui/files/mesh_options.hpp"
#include "ui/view/viewport.hpp"

namespace hariko {

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

FileDialogs::FileDialogs(Editor& editor, const Viewport& viewport, Marks& marks, const Metrics& metrics,
                         ApplicationServices& application)
    : editor_(editor), viewport_(viewport), marks_(marks), metrics_(metrics), application_(application) {}

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

void FileDialogs::export_triangles() {
  const std::filesystem::path proposal = export_proposal(".obj");
  show("triangles", {translatable("Export the surfaces as triangles"),
                     translatable("Export"),
                     true,
                     {".obj", ".stl", ".3mf", ".ply", ".glb", ".gltf", ".off"},
                     proposal,
                     [this](const auto& path) { application_.export_file(path, export_options_.settings()); },
                     [this](const std::filesystem::path& name) {
                       if (export_options_.draw(editor_, marks_, metrics_, name))
                         application_.count_export(name, export_options_.settings());
                     }});
  export_options_.begin(editor_, proposal);
  application_.count_export(proposal, export_options_.settings());
  counting_ = true;
}

void FileDialogs::export_cad() {
  const std::filesystem::path proposal = export_proposal(".step");
  show("cad", {translatable("Export the surfaces for CAD"),
               translatable("Export"),
               true,
               {".step", ".stp", ".iges", ".igs"},
               proposal,
               [this](const auto& path) { application_.export_cad(path, cad_options_.settings()); },
               [this](const std::filesystem::path& name) {
                 if (cad_options_.draw(editor_, marks_, metrics_, name))
                   application_.count_cad(cad_options_.settings());
               }});
  cad_options_.begin(editor_);
  application_.count_cad(cad_options_.settings());
  counting_ = true;
}

void FileDialogs::export_control() {
  const std::filesystem::path proposal = export_proposal(" control.obj");
  show("control", {translatable("Export the control meshes of skins"),
                   translatable("Export"),
                   true,
                   {".obj"},
                   proposal,
                   [this](const auto& path) { application_.export_control(path); }});
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
  std::filesystem::path proposal = name_proposal();
  proposal.replace_extension(turntable ? ".png" : picture_ending_);
  FileDialog::Request request;
  request.title =
      turntable ? translatable("Export a turntable as pictures") : translatable("Export a picture");
  request.action = translatable("Export");
  request.saving = true;
  request.extensions = {".png"};
  if (!turntable) request.extensions.push_back(".svg");
  request.proposal = proposal;
  request.accept = [this, turntable](const auto& path) { write_picture(path, turntable); };
  request.options = [this, turntable](const std::filesystem::path& name) {
    if (!turntable && lower_ending(name) == ".svg") return drawing_options_.draw(editor_, marks_, metrics_);
    draw_picture_options(editor_, marks_, metrics_, picture_settings_, turntable);
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
                folder_proposal(), std::move(accept),
                [this](const auto&) { draw_mesh_options(editor_, marks_, metrics_); }});
}

void FileDialogs::import() {
  show("import",
       {translatable("Import"), translatable("Import"), false, importable_endings(!why_no_cad_files()),
        folder_proposal(), [this](const auto& path) { application_.import_file(path); },
        [this](const auto&) { draw_mesh_options(editor_, marks_, metrics_); }});
}

namespace {

FileDialog::Request picture_request(std::string title, std::filesystem::path folder,
                                    std::function<void(const std::filesystem::path&)> accept) {
  const auto endings = reference_endings();
  return {std::move(title),  translatable("Choose"), false, {endings.begin(), endings.end()},
          std::move(folder), std::move(accept)};
}

}  // namespace

void FileDialogs::add_picture() {
  show("reference", picture_request(translatable("Add reference picture"), folder_proposal(),
                                    [this](const auto& path) { application_.add_pictures({path}); }));
}

void FileDialogs::replace_picture(ObjectId picture) {
  show("reference",
       picture_request(translatable("Choose another picture"), folder_proposal(),
                       [this, picture](const auto& path) { application_.replace_picture(picture, path); }));
}

void FileDialogs::find_pictures(const std::string& name) {
  editor_.show_text(name);
  show("reference", picture_request(fill(editor_.language("Where is {0}?"), {name}), folder_proposal(),
                                    [this](const auto& path) { application_.find_pictures(path); }));
}

void FileDialogs::unpack_picture(ObjectId picture) {
  const Object* object = editor_.document().find(picture);
  if (!object || !object->picture()) return;
  const std::filesystem::path name(object->picture()->path);
  show("reference", {translatable("Save the picture as a file"),
                     translatable("Save"),
                     true,
                     {is_reference_file(name) ? lower_ending(name) : std::string(".png")},
                     folder_proposal() / name.filename(),
                     [this, picture](const auto& path) { application_.unpack_picture(picture, path); }});
}

void FileDialogs::choose_environment() {
  const auto endings = environment_endings();
  show("environment", {translatable("Choose an environment"),
                       translatable("Choose"),
                       false,
                       {endings.begin(), endings.end()},
                       folder_proposal(),
                       [this](const auto& path) {
                         std::error_code unknown;
                         const auto whole = std::filesystem::absolute(path, unknown);
                         editor_.settings.environment.file = (unknown ? path : whole).string();
                         editor_.show_environment(EnvironmentKind::file);
                       }});
}

void FileDialogs::export_keys() {
  show("keys", {translatable("Export keys"),
                translatable("Export"),
                true,
                {".json"},
                folder_proposal() / "hariko-keys.json",
                [this](const auto& path) {
                  const auto done = write_file_atomic(path, write_key_file(editor_.settings.keys));
                  if (!done.ok()) return editor_.notify(done.error());
                  editor_.notify(Notice::Kind::info,
                                 fill(editor_.language("Exported {0}."), {path.filename().string()}));
                }});
}

void FileDialogs::import_keys() {
  show("keys", {translatable("Import keys"),
                translatable("Import"),
                false,
                {".json"},
                folder_proposal(),
                [this](const auto& path) {
                  constexpr std::size_t largest = 1 << 20;  // bytes; a file of keys has some kilobytes
                  const auto text = read_file(path, largest);
                  if (!text) return editor_.notify(text.error());
                  const auto keys = read_key_file(*text);
                  if (!keys) return editor_.notify(keys.error());
                  editor_.settings.keys = *keys;
                  editor_.notify(Notice::Kind::info, fill(editor_.language("The keys of {0} are in use."),
                                                          {path.filename().string()}));
                }});
}

void FileDialogs::export_pages() {
  std::filesystem::path proposal = name_proposal();
  proposal.replace_extension(".pdf");
  show("pages", {translatable("Export the pages of the paper model"),
                 translatable("Export"),
                 true,
                 {".pdf", ".svg", ".dxf", ".png"},
                 proposal,
                 [this](const auto& path) { application_.export_pages(path); }});
}

void FileDialogs::export_sections() {
  const std::filesystem::path proposal = export_proposal(" sections.svg");
  show("sections", {translatable("Export the section curves"),
                    translatable("Export"),
                    true,
                    {".svg", ".dxf"},
                    proposal,
                    [this](const auto& path) {
                      auto order = order_sections(editor_, path);
                      if (!order) return editor_.notify(order.error());
                      application_.export_sections(std::move(order).value());
                    }});
}

void FileDialogs::record() {
  std::filesystem::path proposal = name_proposal();
  proposal.replace_extension(".jsonl");
  show("replay", {translatable("Record a replay"),
                  translatable("Record"),
                  true,
                  {".jsonl"},
                  proposal,
                  [this](const auto& path) { application_.record(path); }});
}

void FileDialogs::record_script() {
  std::filesystem::path proposal = name_proposal();
  proposal.replace_extension(".json");
  show("script", {translatable("Record a script"),
                  translatable("Record"),
                  true,
                  {".json"},
                  proposal,
                  [this](const auto& path) { application_.record_script(path); }});
}

std::filesystem::path FileDialogs::name_proposal() const {
  if (editor_.path) return *editor_.path;
  return editor_.title() + ".hariko";
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
