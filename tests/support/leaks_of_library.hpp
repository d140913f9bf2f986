#pragma once

// LeaksOfLibrary: exemption of foreign libraries from the leak checker.

#include "core/base/sanitizer.hpp"

#ifdef HARIKO_ADDRESS_SANITIZER
#include <sanitizer/lsan_interface.h>
#endif

namespace hariko::test {

/// Disables the leak checker during its life, for a foreign library that never frees its memory.
class LeaksOfLibrary {
 public:
#ifdef HARIKO_ADDRESS_SANITIZER
  LeaksOfLibrary() {
    __lsan_disable();
  }
  ~LeaksOfLibrary() {
    __lsan_enable();
  }
#else
  LeaksOfLibrary() {}
  ~LeaksOfLibrary() {}
#endif
  LeaksOfLibrary(const LeaksOfLibrary&) = delete;
  LeaksOfLibrary& operator=(const LeaksOfLibrary&) = delete;
};

}  // namespace hariko::test
