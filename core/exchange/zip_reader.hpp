#pragma once

// ZipReader: parts of a zip archive in memory, unpacked piece by piece. Internal to core/exchange.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace hariko {

/// An archive may promise much more than it holds. All that is unpacked of it is at most 64 MiB and 100 bytes
/// for each byte of the archive; text of meshes is packed to a fifth, seldom to a twentieth.
class ZipReader {
 public:
  /// Borrows `bytes`. Errors: E_TRUNCATED where they are no whole archive.
  static Result<ZipReader> open(std::string_view bytes);

  /// Takes the next bytes; false ends the unpacking.
  using Sink = std::function<bool(std::string_view piece)>;
  bool has(const std::string& name) const;
  /// What the archive says that the part unpacks to; 0 where it does not.
  std::uint64_t size(const std::string& name) const;
  /// Gives the whole part to `sink`, at most 64 KiB at once. Names differ by more than the case of letters.
  /// Errors: E_PARSE where there is no such part, or it cannot be unpacked, or is not what was packed;
  /// E_LIMIT.
  Result<Done> unpack(const std::string& name, const Sink& sink);
  /// Bytes that were unpacked so far.
  std::uint64_t unpacked() const { return unpacked_; }

 private:
  struct Archive;
  struct Close {
    void operator()(Archive* archive) const;
  };
  std::unique_ptr<Archive, Close> archive_;
  std::uint64_t limit_ = 0, unpacked_ = 0;
};

}  // namespace hariko
