#pragma once

// ZipReader: parts of a zip archive in memory, unpacked piece by piece. Internal to core/exchange.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace hariko {

/// Reader of an archive with a limit on unpacked bytes, as an archive may unpack to far more than its size:
/// 64 MiB plus 100 bytes for each byte of the archive. Text of meshes compresses to a fifth, seldom to a
/// twentieth.
class ZipReader {
 public:
  /// Opens an archive. Borrows `bytes`. Errors: E_TRUNCATED where they are not a whole archive.
  static Result<ZipReader> open(std::string_view bytes);

  /// Receiver of unpacked bytes; returning false ends the unpacking.
  using Sink = std::function<bool(std::string_view piece)>;
  /// Whether the archive has a part of this name; names are case-insensitive, and a slash also stands for a
  /// backslash.
  bool has(const std::string& name) const;
  /// Unpacked size of the part as the archive gives it; 0 where it does not.
  std::uint64_t size(const std::string& name) const;
  /// Unpacks a whole part to `sink`, at most 64 KiB at once. Names as in `has`. Errors: E_PARSE
  /// where there is no such part or its data are damaged; E_LIMIT.
  Result<Done> unpack(const std::string& name, const Sink& sink);
  /// Bytes that were unpacked so far.
  std::uint64_t unpacked() const { return unpacked_; }

 private:
  std::int64_t locate(const std::string& name) const;

  struct Archive;
  struct Close {
    void operator()(Archive* archive) const;
  };
  std::unique_ptr<Archive, Close> archive_;
  std::uint64_t limit_ = 0, unpacked_ = 0;
};

}  // namespace hariko
