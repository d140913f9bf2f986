#pragma once

// HARIKO_ADDRESS_SANITIZER: defined in builds with the address sanitizer, which replaces the allocator and
// reports crashes.

#if defined(__SANITIZE_ADDRESS__)
#define HARIKO_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define HARIKO_ADDRESS_SANITIZER
#endif
#endif
