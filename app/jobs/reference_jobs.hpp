#pragma once

// ReferenceJobs: adds, packs, unpacks and relinks reference pictures, reading files off the main thread.

#include <filesystem>
#include <functional>
#include <vector>

#include "app/jobs/background_work.hpp"
#include "core/document/edits/edit_pictures.hpp"

namespace hariko {

/// Jobs on reference pictures; each makes one undoable step. For the main thread.
class ReferenceJobs {
 public:
  using Log = std::function<void(const char* what, const std::filesystem::path&)>;
  /// `log`: receives "picture_added", "picture_packed", "picture_unpacked", "pictures_found".
  ReferenceJobs(Editor& editor, BackgroundWork& work, Log log)
      : editor_(editor), work_(work), log_(std::move(log)) {}

  /// Adds linked pictures side by side in the plane of the active view, and selects the first. Starts a
  /// document where none is open. Reports files that are not pictures.
  void add(const std::vector<std::filesystem::path>& files);
  /// Packs the bytes of linked pictures into the document.
  void pack(const std::vector<ObjectId>& pictures);
  /// Writes the bytes of a packed picture to a file and links the picture to it.
  void unpack(ObjectId picture, const std::filesystem::path& file);
  /// Links a picture to another file.
  void replace(ObjectId picture, const std::filesystem::path& file);
  /// Links the first missing picture to this file, and others to files of their names beside it.
  void find(const std::filesystem::path& file);

 private:
  struct Read {
    std::filesystem::path path;
    Result<PictureFile> file = PictureFile{};
  };
  static Read read(const std::filesystem::path& path, bool keep_bytes);
  void take(const std::vector<Read>& files, const Camera& camera, PixelSize view);
  void take_files(const std::vector<std::pair<ObjectId, Read>>& files, const std::string& step,
                  const char* log);

  Editor& editor_;
  BackgroundWork& work_;
  Log log_;
};

}  // namespace hariko
