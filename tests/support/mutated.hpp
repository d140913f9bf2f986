#pragma once

// Damaged files for robustness tests.

#include <algorithm>
#include <string>

#include "tests/support/random.hpp"

namespace hariko::test {

/// Copy with one to four random faults: changed bytes and bits, deleted or duplicated parts, truncation,
/// enlarged numbers.
inline std::string mutated(std::mt19937_64& rng, std::string bytes) {
  for (int k = uniform_int(rng, 1, 4); k > 0 && !bytes.empty(); --k) {
    const auto at = [&] { return std::size_t(rng() % bytes.size()); };
    const std::size_t begin = at(), length = 1 + rng() % std::min<std::size_t>(64, bytes.size() - begin);
    switch (uniform_int(rng, 0, 6)) {
      case 0:
        bytes[begin] = char(rng());
        break;
      case 1:
        bytes[begin] = char(bytes[begin] ^ (1 << rng() % 8));
        break;
      case 2:
        bytes.erase(begin, length);
        break;
      case 3:
        bytes.insert(at(), bytes.substr(begin, length));
        break;
      case 4:
        bytes.resize(begin);
        break;
      case 5:
        if (const std::size_t digit = bytes.find_first_of("0123456789", begin); digit != std::string::npos)
          bytes.insert(digit, chance(rng, 0.5) ? "999999999" : "-");
        break;
      default:
        bytes.replace(begin, length, std::string(length, chance(rng, 0.5) ? char(0xff) : char(0)));
    }
  }
  return bytes;
}

}  // namespace hariko::test
