#include "ui/base/menu_letters.hpp"

#include <algorithm>
#include <cctype>

namespace hariko {

std::vector<char> menu_letters(const std::vector<std::string>& menus) {
  std::vector<char> letters;
  for (const std::string& menu : menus) {
    char own = 0;
    for (const char c : menu) {
      const auto letter = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      if (letter < 'A' || letter > 'Z' || std::find(letters.begin(), letters.end(), letter) != letters.end())
        continue;
      own = letter;
      break;
    }
    letters.push_back(own);
  }
  return letters;
}

const std::string* menu_of_letter(const std::vector<std::string>& menus, int key) {
  const std::vector<char> letters = menu_letters(menus);
  const auto found = std::find(letters.begin(), letters.end(), static_cast<char>(key));
  if (key < 'A' || key > 'Z' || found == letters.end()) return nullptr;
  return &menus[static_cast<std::size_t>(found - letters.begin())];
}

}  // namespace hariko
