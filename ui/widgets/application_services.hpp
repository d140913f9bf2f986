#pragma once

// ApplicationServices: requests of the interface to the application: work on files and other work that takes
// long.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/document/document.hpp"
#include "ui/base/samples.hpp"

namespace hariko {

struct CadSettings;
struct DrawingOrder;
struct ExportSettings;
struct PictureOrder;
struct SectionOrder;

/// Interface of the application to the panels, dialogs and commands of one window. None of these functions
/// blocks.
class ApplicationServices {
 public:
  virtual ~ApplicationServices() = default;

  /// Replaces the document.
  virtual void open(const std::filesystem::path& path) = 0;
  /// Adds a file to the document.
  virtual void import_file(const std::filesystem::path& path) = 0;
  /// Takes files as if they had been dropped on the window, in the next frame.
  virtual void drop_files(const std::vector<std::filesystem::path>& files) = 0;
  /// Saves the committed document; `then` runs after success.
  virtual void save(const std::filesystem::path& path, std::function<void()> then) = 0;
  /// Saves a copy; the document keeps its file.
  virtual void save_copy(const std::filesystem::path& path) = 0;
  /// Restores the content of the document's file.
  virtual void revert() = 0;

  /// Opens work that an earlier session left behind.
  virtual void recover(const std::string& id) = 0;
  /// Throws away work that an earlier session left behind.
  virtual void discard_recovery(const std::string& id) = 0;
  /// Dismisses the report of the crash that is offered: it was seen.
  virtual void dismiss_crash() = 0;
  /// Shows the folder with the log and reports of crashes, in the desktop's file manager.
  virtual void show_log_folder() = 0;

  /// Writes surfaces as triangles.
  virtual void export_file(const std::filesystem::path& path, const ExportSettings& settings) = 0;
  /// Finds out what the triangles in a file of this name would be like; ends in
  /// `FileDialogs::take_export_count`. Only the last one asked for counts.
  virtual void count_export(const std::filesystem::path& path, const ExportSettings& settings) = 0;
  /// Writes surfaces as STEP or IGES.
  virtual void export_cad(const std::filesystem::path& path, const CadSettings& settings) = 0;
  /// Likewise for the faces; ends in `FileDialogs::take_cad_count`.
  virtual void count_cad(const CadSettings& settings) = 0;
  /// Cancels either count.
  virtual void cancel_count() = 0;
  /// Draws and writes pictures.
  virtual void export_pictures(PictureOrder order) = 0;
  /// Computes and writes a line drawing.
  virtual void export_drawing(DrawingOrder order) = 0;
  /// Computes and writes section curves.
  virtual void export_sections(SectionOrder order) = 0;
  /// Writes the control meshes of the visible skins.
  virtual void export_control(const std::filesystem::path& path) = 0;
  /// Writes the pages of the paper model that is shown.
  virtual void export_pages(const std::filesystem::path& path) = 0;

  /// Adds reference pictures where the active view looks.
  virtual void add_pictures(const std::vector<std::filesystem::path>& files) = 0;
  /// Takes the bytes of linked pictures into the document.
  virtual void pack_pictures(const std::vector<ObjectId>& pictures) = 0;
  /// Writes a packed picture to a file, and links it.
  virtual void unpack_picture(ObjectId picture, const std::filesystem::path& file) = 0;
  /// Links a picture to another file.
  virtual void replace_picture(ObjectId picture, const std::filesystem::path& file) = 0;
  /// Takes this file for the first of the missing pictures; the others are looked for beside it.
  virtual void find_pictures(const std::filesystem::path& file) = 0;

  /// Makes a polyhedron of a skin or of solids, which are hidden then. Only the last one asked for counts.
  virtual void convert(ObjectId object) = 0;
  /// Adds a section to a skin, taken from its surface at a place of the path, 0 .. 1: a step when it is
  /// there.
  virtual void add_section(ObjectId skin, double place) = 0;

  /// Records what the user does from now on as a replay, until it is told to stop.
  virtual void record(const std::filesystem::path& path) = 0;
  /// Ends the recording.
  virtual void stop_recording() = 0;

  /// Writes what is done from now on as a script, until it is told to stop.
  virtual void record_script(const std::filesystem::path& path) = 0;
  /// Ends that, and writes the file.
  virtual void stop_script() = 0;

  /// Gives a sample its picture, now or later.
  virtual void give_picture(Sample& sample) = 0;
  /// Ends the program, without a question.
  virtual void quit() = 0;
};

}  // namespace hariko
