#pragma once

// Assertions for programmers' errors. They stay on in every build: bad input of users is a Result instead.

namespace hariko::detail {
[[noreturn]] void assertion_failed(const char* condition, const char* message, const char* file, int line);
}

#define HARIKO_ASSERT(condition, message) \
  ((condition) ? void(0) : ::hariko::detail::assertion_failed(#condition, message, __FILE__, __LINE__))
