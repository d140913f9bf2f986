#pragma once

// ReferenceJobs: reference pictures come into the document, are packed, unpacked and found again, off the
// main thread as far as files are read.

#include <filesystem>
#include <functional>
#include <vector>

#include "app/jobs/background_work.hpp"
#include "core/document/edit_pictures.hpp"
#include "ui/files/file_actions.hpp"

namespace hariko {

/// For the main thread. Each makes one step.
class ReferenceJobs {
 public:
  using Log = std::function<void(const char* what, const std::filesystem::path&)>;
  /// `log`: told "picture_added", "picture_packed", "picture_unpacked", "pictures_found".
  ReferenceJobs(Editor& editor, BackgroundWork& work, Log log)
      : editor_(editor), work_(work), log_(std::move(log)) {}

  /// Side by side where the active view looks, linked; the first is chosen then. Begins a document where
  /// none is open. Files that are no pictures are told.
  void add(const std::vector<std::filesystem::path>& files);
  /// Takes the bytes of linked pictures into the document.
  void pack(const std::vector<ObjectId>& pictures);
  /// Writes the bytes of a packed picture to a file, which it is linked to from then on.
  void unpack(ObjectId picture, const std::filesystem::path& file);
  /// Gives a picture another file.
  void replace(ObjectId picture, const std::filesystem::path& file);
  /// The first missing picture is this file; the others are looked for under their names beside it.
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

/// Has these jobs do what the interface asks for; they must outlive it.
void connect(FileActions& actions, ReferenceJobs& jobs);

}  // namespace hariko
