#pragma once

// Present time as locks, recovery copies and the list of recent files keep it.

#include <chrono>
#include <cstdint>

namespace hariko {

/// Seconds since 1970, UTC.
inline std::int64_t unix_seconds() {
  using namespace std::chrono;
  return duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace hariko
