#pragma once

#include <cstddef>

namespace hariko {

/// Bytes that are allocated by operator new in this test program and not freed yet.
std::size_t live_bytes();

}  // namespace hariko
