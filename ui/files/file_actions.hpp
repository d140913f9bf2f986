#pragma once

// FileActions: what the interface asks the application to do.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/document/document.hpp"
#include "ui/base/samples.hpp"
#include "ui/files/drawing_order.hpp"
#include "ui/files/export_settings.hpp"
#include "ui/files/picture_order.hpp"

namespace hariko {

/// Work on files and other work that takes long, done by the application. None of these blocks.
struct FileActions {
  std::function<void(const std::filesystem::path&)> open;         ///< replaces the document
  std::function<void(const std::filesystem::path&)> import_file;  ///< adds to the document
  /// Saves the committed document; `then` runs after success.
  std::function<void(const std::filesystem::path&, std::function<void()> then)> save;
  std::function<void(const std::filesystem::path&)> save_copy;
  std::function<void()> revert;  ///< to what the file holds
  std::function<void(const std::filesystem::path&, const ExportSettings&)> export_file;
  /// Finds out what the triangles in a file of this name would be like; ends in
  /// `FileDialogs::take_export_count`. Only the last one asked for counts.
  std::function<void(const std::filesystem::path&, const ExportSettings&)> count_export;
  /// The same of faces, and `FileDialogs::take_cad_count`.
  std::function<void(const CadSettings&)> count_cad;
  std::function<void()> cancel_count;  ///< of either
  std::function<void(const std::filesystem::path&, const CadSettings&)> export_cad;
  std::function<void(PictureOrder)> export_pictures;
  std::function<void(DrawingOrder)> export_drawing;
  /// Adds reference pictures where the active view looks.
  std::function<void(const std::vector<std::filesystem::path>&)> add_pictures;
  /// Takes the bytes of linked pictures into the document.
  std::function<void(const std::vector<ObjectId>&)> pack_pictures;
  /// Writes a packed picture to a file, and links it.
  std::function<void(ObjectId, const std::filesystem::path&)> unpack_picture;
  std::function<void(ObjectId, const std::filesystem::path&)> replace_picture;
  /// This is the first of the missing pictures; the others are looked for beside it.
  std::function<void(const std::filesystem::path&)> find_pictures;
  /// Writes the control meshes of the visible skins.
  std::function<void(const std::filesystem::path&)> export_control;
  /// Makes a polyhedron of a skin or of solids, which are hidden then. Only the last one asked for counts.
  std::function<void(ObjectId)> convert;
  /// Adds a section to a skin, at a place of its path: a step when it is there.
  std::function<void(ObjectId, double place)> add_section;
  /// Writes the pages of the paper model that is shown.
  std::function<void(const std::filesystem::path&)> export_pages;
  /// Opens work that an earlier session left behind, or throws it away.
  std::function<void(const std::string&id)> recover, discard_recovery;
  /// The report of the crash that is offered was seen.
  std::function<void()> dismiss_crash;
  /// Shows the folder with the log and reports of crashes, in the desktop's file manager.
  std::function<void()> show_log_folder;
  /// Records what the user does from now on as a replay, until it is told to stop.
  std::function<void(const std::filesystem::path&)> record;
  std::function<void()> stop_recording;
  std::function<void(Sample&)> picture;  ///< gets a sample its picture, at once or later
  std::function<void()> quit;            ///< at once
};

}  // namespace hariko
