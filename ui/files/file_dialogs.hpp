#pragma once

// FileDialogs: the dialogs that ask for a file, with what each offers, its options, and what was chosen last.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ui/files/cad_options.hpp"
#include "ui/files/export_memory.hpp"
#include "ui/files/export_options.hpp"
#include "ui/files/file_dialog.hpp"
#include "ui/files/picture_options.hpp"
#include "ui/widgets/application_services.hpp"

namespace hariko {

class Viewport;

/// Endings of the files that can be added to a document. `cad`: STEP and IGES can be read
/// (`why_no_cad_files`).
std::vector<std::string> importable_endings(bool cad);
/// The same and documents.
std::vector<std::string> openable_endings(bool cad);

class FileDialogs {
 public:
  /// All are borrowed.
  FileDialogs(Editor& editor, const Viewport& viewport, ApplicationServices& application);

  /// Any kind of file.
  void open(std::function<void(const std::filesystem::path&)> accept);
  void import();
  /// Files of reference pictures: a new one, another one for a picture, the first of the missing ones, where
  /// a packed one goes.
  void add_picture();
  void replace_picture(ObjectId picture);
  void find_pictures(const std::string& name);
  void unpack_picture(ObjectId picture);
  /// The picture of an environment, which is shown then.
  void choose_environment();
  /// `then` runs after success.
  void save_as(std::function<void()> then);
  void save_copy();
  void export_triangles();
  void export_cad();
  /// For the control meshes of skins.
  void export_control();
  /// Exports the active view: one picture or line drawing, or a series that turns round the model.
  void picture(bool turntable);
  /// For the pages of the paper model.
  void export_pages();
  /// For the section curves that are shown.
  void export_sections();
  void export_keys();
  void import_keys();
  void record();
  void record_script();

  void draw(PanelContext& context);
  bool is_open() const { return dialog_.is_open(); }
  void close() { dialog_.close(); }

  void take_export_count(const ExportSettings& settings, const Result<ExportCount>& count) {
    export_options_.take(settings, count);
  }
  void take_cad_count(const CadSettings& settings, const Result<CadTotals>& count) {
    cad_options_.take(settings, count);
  }

  /// Choices in the dialogs that export, as made last, which they begin with.
  ExportMemory remembered() const;
  void remember(ExportMemory memory);
  void forget_choices();

 private:
  /// Opens the dialog in the folder that files of this kind were taken from or written to last, where it is
  /// still there.
  void show(const std::string& kind, FileDialog::Request request);
  using TakePath = std::function<void(const std::filesystem::path&)>;
  using DrawOptions = decltype(FileDialog::Request::options);
  /// The same for a file that is written. `action`: on the button; `options`: as those of a request.
  void save(const std::string& kind, std::string title, const char* action, std::vector<std::string> endings,
            std::filesystem::path proposal, TakePath accept, DrawOptions options = {});
  /// The same for a file that is read.
  void choose(const std::string& kind, std::string title, const char* action,
              std::vector<std::string> endings, TakePath accept, DrawOptions options = {});
  void choose_picture(std::string title, TakePath accept);
  void write_picture(const std::filesystem::path& path, bool turntable);
  std::filesystem::path export_proposal(const char* ending) const;
  std::filesystem::path folder_proposal() const;
  std::filesystem::path name_proposal() const;
  std::filesystem::path name_proposal(const char* ending) const;

  Editor& editor_;
  const Viewport& viewport_;
  ApplicationServices& application_;
  FileDialog dialog_;
  bool counting_ = false;  ///< something may be counted for the dialog
  ExportOptions export_options_;
  CadOptions cad_options_;
  PictureSettings picture_settings_;
  DrawingOptions drawing_options_;
  std::string picture_ending_ = ".png";         ///< ending of the last picture
  std::map<std::string, std::string> folders_;  ///< folder of the last file, by kind of file
};

}  // namespace hariko
