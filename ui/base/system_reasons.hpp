#pragma once

// Reasons that the system gives where a file or a folder refuses something.

#include <array>
#include <cerrno>

#include "ui/base/language.hpp"

namespace hariko {

/// Number of an error of the system, and its sentence as `std::error_code::message` gives it.
struct SystemReason {
  int number;
  const char* text;
};

/// Reasons that a designer meets. Messages and notices hold the sentence, and translate it as what stands in
/// a place of theirs; others stay as the system gives them.
inline constexpr std::array system_reasons{
    SystemReason{EACCES, translatable("Permission denied")},
    SystemReason{EPERM, translatable("Operation not permitted")},
    SystemReason{ENOENT, translatable("No such file or directory")},
    SystemReason{EEXIST, translatable("File exists")},
    SystemReason{EISDIR, translatable("Is a directory")},
    SystemReason{ENOTDIR, translatable("Not a directory")},
    SystemReason{ENAMETOOLONG, translatable("File name too long")},
    SystemReason{ELOOP, translatable("Too many levels of symbolic links")},
    SystemReason{ENOSPC, translatable("No space left on device")},
    SystemReason{EDQUOT, translatable("Disk quota exceeded")},
    SystemReason{EFBIG, translatable("File too large")},
    SystemReason{EROFS, translatable("Read-only file system")},
    SystemReason{EBUSY, translatable("Device or resource busy")},
    SystemReason{EIO, translatable("Input/output error")},
    SystemReason{ENOMEM, translatable("Cannot allocate memory")},
    SystemReason{ENOLCK, translatable("No locks available")}};

}  // namespace hariko
