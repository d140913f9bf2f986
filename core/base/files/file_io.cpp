#include "core/base/files/file_io.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <new>
#include <system_error>

#include "core/base/files/temporary_files.hpp"
#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {
namespace {

std::string reason_of(int error_number) {
  return std::generic_category().message(error_number);
}

std::string quoted(const std::filesystem::path& path) {
  return "\"" + sanitized_utf8(path.native()) + "\"";
}

/// File descriptor for reading, closed at the end of its scope.
class ReadDescriptor {
 public:
  explicit ReadDescriptor(const char* path)
      : descriptor_(::open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {}
  ~ReadDescriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  ReadDescriptor(const ReadDescriptor&) = delete;
  ReadDescriptor& operator=(const ReadDescriptor&) = delete;
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

Message open_error(const std::filesystem::path& path, const std::string& reason) {
  return make_error(e_file_open, quoted(path) + " cannot be opened: " + reason + ".",
                    "Check the name and whether you may read the file.");
}

Message size_error(const std::filesystem::path& path, std::uint64_t limit) {
  return make_error(
      e_limit, quoted(path) + " is larger than the " + std::to_string(limit) + " bytes that are accepted.",
      "Reduce the model before importing it.");
}

Message read_error(const std::filesystem::path& path, const std::string& reason) {
  return make_error(e_file_read, quoted(path) + " cannot be read: " + reason + ".",
                    "Copy the file to another disk and try again.");
}

/// Reads to the end of the file, which may have grown or shrunk since `expected` was taken.
Result<std::string> read_all(const std::filesystem::path& path, int descriptor, std::uint64_t expected,
                             std::uint64_t limit) {
  std::string bytes;
  bytes.resize(expected + 1);  // one more, so that the end shows without a second growth
  std::size_t size = 0;
  for (;;) {
    const ssize_t got = ::read(descriptor, bytes.data() + size, bytes.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return read_error(path, reason_of(errno));
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
    if (size > limit) return size_error(path, limit);
    if (size == bytes.size()) bytes.resize(size + std::max<std::size_t>(size / 2, 4096));
  }
  bytes.resize(size);
  return bytes;
}

Message write_error(const std::filesystem::path& path, const std::string& reason) {
  return make_error(e_file_write, quoted(path) + " cannot be written: " + reason + ".",
                    "Check free space and permissions, or save under another name.");
}

/// Target of `path` when symbolic links are followed; it need not exist.
Result<std::filesystem::path> follow_links(const std::filesystem::path& path) {
  std::filesystem::path target = path;
  for (int step = 0; step < 40; ++step) {  // the limit of Linux
    std::error_code error;
    if (!std::filesystem::is_symlink(target, error)) return target;
    const std::filesystem::path next = std::filesystem::read_symlink(target, error);
    if (error) return write_error(path, error.message());
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return write_error(path, reason_of(ELOOP));
}

/// Permission bits for the new file: those of the existing one, or -1 when there is none. Refuses targets
/// that a rename must not replace.
Result<int> existing_mode(const std::filesystem::path& path, const std::filesystem::path& target) {
  struct stat status {};
  if (::stat(target.c_str(), &status) != 0) {
    if (errno == ENOENT) return -1;
    return write_error(path, reason_of(errno));
  }
  if (S_ISDIR(status.st_mode)) return write_error(path, "it is a folder");
  if (!S_ISREG(status.st_mode)) return write_error(path, "it is not a regular file");
  // Renaming needs no write permission on the file itself, but the user's write protection is respected.
  if (::access(target.c_str(), W_OK) != 0) return write_error(path, reason_of(errno));
  return static_cast<int>(status.st_mode & 07777U);
}

int write_all(FileLayer& layer, int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const std::int64_t written = layer.write(descriptor, bytes.data(), bytes.size());
    if (written == -EINTR) continue;
    if (written < 0) return static_cast<int>(written);
    if (written == 0) return -ENOSPC;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// Flushes a file. File systems that cannot flush answer EINVAL or ENOTSUP, which counts as success.
int sync_if_supported(FileLayer& layer, int descriptor) {
  const int result = layer.sync(descriptor);
  return result == -EINVAL || result == -ENOTSUP ? 0 : result;
}

/// Writes and flushes the open temporary file and closes it in any case. Returns 0 or a negative errno.
int fill_temporary(FileLayer& layer, int descriptor, std::string_view bytes, int mode) {
  int result = mode < 0 ? 0 : layer.set_mode(descriptor, static_cast<unsigned>(mode));
  if (result >= 0) result = write_all(layer, descriptor, bytes);
  if (result >= 0) result = sync_if_supported(layer, descriptor);
  const int closed = layer.close(descriptor);
  if (result < 0) return result;
  return closed == -EINTR ? 0 : std::min(closed, 0);
}

/// Makes the rename itself durable.
int sync_directory(FileLayer& layer, const std::filesystem::path& directory) {
  const int descriptor = layer.open_directory(directory.empty() ? "." : directory.native());
  if (descriptor == -EACCES) return 0;  // a folder may be writable without being readable
  if (descriptor < 0) return descriptor;
  const int result = sync_if_supported(layer, descriptor);
  layer.close(descriptor);
  return std::min(result, 0);
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path, std::uint64_t size_limit) {
  const ReadDescriptor file(path.c_str());
  if (file.get() < 0) return open_error(path, reason_of(errno));
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return open_error(path, reason_of(errno));
  if (S_ISDIR(status.st_mode)) return open_error(path, "it is a folder");
  if (!S_ISREG(status.st_mode)) return open_error(path, "it is not a regular file");
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > size_limit) return size_error(path, size_limit);
  try {
    return read_all(path, file.get(), size, size_limit);
  } catch (const std::bad_alloc&) {
    return read_error(path, reason_of(ENOMEM));
  }
}

int SystemFileLayer::create(const std::string& path, unsigned mode) {
  const int result =
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, static_cast<mode_t>(mode));
  if (result < 0) return -errno;
  // The lock tells other processes, also on other machines, that the writer is alive; without locks the file
  // is written all the same.
  (void)::flock(result, LOCK_EX | LOCK_NB);
  return result;
}

int SystemFileLayer::set_mode(int descriptor, unsigned mode) {
  return ::fchmod(descriptor, static_cast<mode_t>(mode)) < 0 ? -errno : 0;
}

std::int64_t SystemFileLayer::write(int descriptor, const char* data, std::size_t size) {
  // Linux writes at most 2 GiB - 4 KiB at once.
  const ssize_t result = ::write(descriptor, data, std::min<std::size_t>(size, std::size_t{1} << 30));
  return result < 0 ? -errno : result;
}

int SystemFileLayer::sync(int descriptor) {
  return ::fsync(descriptor) < 0 ? -errno : 0;
}

int SystemFileLayer::close(int descriptor) {
  return ::close(descriptor) < 0 ? -errno : 0;
}

int SystemFileLayer::rename(const std::string& from, const std::string& to) {
  return std::rename(from.c_str(), to.c_str()) < 0 ? -errno : 0;
}

int SystemFileLayer::remove(const std::string& path) {
  return ::unlink(path.c_str()) < 0 ? -errno : 0;
}

int SystemFileLayer::open_directory(const std::string& path) {
  const int result = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  return result < 0 ? -errno : result;
}

Result<Done> write_file_atomic(const std::filesystem::path& path, std::string_view bytes, FileLayer& layer) {
  const Result<std::filesystem::path> followed = follow_links(path);
  if (!followed) return followed.error();
  const std::filesystem::path& target = *followed;
  if (!target.has_filename()) return write_error(path, "it is not the name of a file");
  const Result<int> mode = existing_mode(path, target);
  if (!mode) return mode.error();

  std::string temporary;
  int descriptor = -EEXIST;
  for (int attempt = 0; descriptor == -EEXIST && attempt < 1000; ++attempt) {
    temporary = (target.parent_path() / temporary_name(attempt)).native();
    // Nobody else may read the copy before it has the old file's permissions.
    descriptor = layer.create(temporary, *mode < 0 ? 0666U : 0600U);
  }
  if (descriptor == -ENOENT)
    return make_error(e_file_write, quoted(path) + " cannot be written: its folder does not exist.",
                      "Create the folder, or choose another one.");
  if (descriptor < 0) return write_error(path, reason_of(-descriptor));

  int result = fill_temporary(layer, descriptor, bytes, *mode);
  if (result >= 0) result = layer.rename(temporary, target.native());
  if (result < 0) {
    layer.remove(temporary);
    return write_error(path, reason_of(-result));
  }
  const int flushed = sync_directory(layer, target.parent_path());
  if (flushed < 0)
    return make_error(e_file_write,
                      quoted(path) + " was written, but its folder could not be flushed to the disk (" +
                          reason_of(-flushed) + "): after a power failure the old file may be back.",
                      "Save again, or save under another name on another disk.");
  return Done{};
}

Result<Done> write_file_atomic(const std::filesystem::path& path, std::string_view bytes) {
  SystemFileLayer layer;
  return write_file_atomic(path, bytes, layer);
}

}  // namespace hariko
