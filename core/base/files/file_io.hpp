#pragma once

// Whole files: reading with a size limit, and atomic writing, so that a file is always either the old or the
// new one.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_file_open{"E_FILE_OPEN"};    ///< does not exist, is not a file, or may not be read
inline constexpr Code e_file_read{"E_FILE_READ"};    ///< failed while reading
inline constexpr Code e_file_write{"E_FILE_WRITE"};  ///< failed while writing
inline constexpr Code e_limit{"E_LIMIT"};            ///< larger than this program accepts
/// Text that the format does not allow; readers give the line or offset.
inline constexpr Code e_parse{"E_PARSE"};

inline constexpr std::uint64_t default_file_size_limit = std::uint64_t{4} << 30;  ///< bytes

/// Reads a regular file. Errors: E_FILE_OPEN, E_FILE_READ, and E_LIMIT above `size_limit` bytes; the text
/// names the file and the reason. Never blocks on pipes or devices: these are refused.
Result<std::string> read_file(const std::filesystem::path& path,
                              std::uint64_t size_limit = default_file_size_limit);

/// System calls of write_file_atomic, so that tests can make any of them fail. Every call returns a
/// non-negative number, or a negative errno.
class FileLayer {
 public:
  virtual ~FileLayer() = default;
  /// Creates a file that must not exist yet, and returns its descriptor.
  virtual int create(const std::string& path, unsigned mode) = 0;
  /// Gives the file the permission bits of an existing one.
  virtual int set_mode(int descriptor, unsigned mode) = 0;
  virtual std::int64_t write(int descriptor, const char* data, std::size_t size) = 0;
  virtual int sync(int descriptor) = 0;
  virtual int close(int descriptor) = 0;
  virtual int rename(const std::string& from, const std::string& to) = 0;
  virtual int remove(const std::string& path) = 0;
  virtual int open_directory(const std::string& path) = 0;
};

/// FileLayer of the operating system (POSIX).
class SystemFileLayer final : public FileLayer {
 public:
  int create(const std::string& path, unsigned mode) override;
  int set_mode(int descriptor, unsigned mode) override;
  std::int64_t write(int descriptor, const char* data, std::size_t size) override;
  int sync(int descriptor) override;
  int close(int descriptor) override;
  int rename(const std::string& from, const std::string& to) override;
  int remove(const std::string& path) override;
  int open_directory(const std::string& path) override;
};

/// Replaces the file at `path` by `bytes`, or creates it: a temporary file in the same folder is written,
/// flushed to the disk and renamed over the target, then the folder is flushed. On any failure (E_FILE_WRITE)
/// the old file is intact and the temporary one removed; the one exception is a failure to flush the folder,
/// where the complete new file is already in place and the text says so. Keeps the permission bits of an
/// existing file; a symbolic link stays and its target is replaced. Folders, devices and write-protected
/// files are refused.
Result<Done> write_file_atomic(const std::filesystem::path& path, std::string_view bytes, FileLayer& layer);
Result<Done> write_file_atomic(const std::filesystem::path& path, std::string_view bytes);

}  // namespace hariko
