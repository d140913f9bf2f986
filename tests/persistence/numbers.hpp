#pragma once

// Documents that are told apart by a number, which is their first object's name.

#include <cstdint>
#include <string>

#include "core/document/document.hpp"

namespace hariko::test {

inline std::uint64_t number_of(const Document& document) {
  return std::stoull(document.objects.at(0)->name);
}

}  // namespace hariko::test
