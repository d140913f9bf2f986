#pragma once

// ScratchFolder: a temporary folder of the program.

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace hariko {

/// Temporary folder that is removed with this object. Its path is empty where none can be made.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code missing;  // TMPDIR may name what is no folder
    const std::filesystem::path folder = std::filesystem::temp_directory_path(missing);
    if (missing) return;
    std::string name = (folder / "hariko-XXXXXX").native();
    if (::mkdtemp(name.data())) path_ = name;
  }
  ~ScratchFolder() {
    std::error_code unknown;
    if (!path_.empty()) std::filesystem::remove_all(path_, unknown);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace hariko
