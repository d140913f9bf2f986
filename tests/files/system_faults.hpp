#pragma once

// The system calls of this program, of which one fails, so that every way of writing files meets it: ours,
// and that of a library that would write by itself.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace hariko::test {

/// While it lives: of the calls that make, write, flush, close, rename and remove files in `folder`, call
/// number `failing` (from 0) fails with `error_number`, and writes are cut into pieces of at most `piece`
/// bytes. One at a time, for writers on the calling thread.
class SystemFaults {
 public:
  SystemFaults(const std::filesystem::path& folder, int failing, int error_number, std::size_t piece);
  ~SystemFaults();
  SystemFaults(const SystemFaults&) = delete;
  SystemFaults& operator=(const SystemFaults&) = delete;

  int calls() const;
  /// Files in the folder that were opened for writing under their own names, where a failure leaves a half.
  const std::vector<std::string>& exposed() const;
};

}  // namespace hariko::test
