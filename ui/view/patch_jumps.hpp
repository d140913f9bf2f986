#pragma once

// PatchJumps: when surfaces round solids get other patches while something is dragged. Pictures are faded
// then.

#include <cstdint>
#include <map>

#include "ui/editor/editor.hpp"

namespace hariko {

class PatchJumps {
 public:
  /// Looks at the surfaces that are ready.
  void update(const Editor& editor);
  /// Rises by one with each update that found other patches, in a drag or at its end.
  std::uint64_t count() const { return count_; }

 private:
  struct Known {
    std::shared_ptr<const DisplayMesh> mesh;
    std::uint64_t patches = 0;  ///< number of the way in which patches hang together
    Quality quality = Quality::final;
  };
  std::map<ObjectId, Known> known_;
  std::uint64_t documents_ = 0, count_ = 0;
};

/// The same number for surfaces whose patches hang together in the same way, whatever their shape. O(seams).
std::uint64_t patch_connection(const Surface& surface);

}  // namespace hariko
