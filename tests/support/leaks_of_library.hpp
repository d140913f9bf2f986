#pragma once

#include "core/base/sanitizer.hpp"

#ifdef HARIKO_ADDRESS_SANITIZER
#include <sanitizer/lsan_interface.h>
#endif

namespace hariko::test {

/// As long as it lives, what a foreign library allocates may be left behind: the leak checker looks away.
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
