#pragma once

// Letters that open menus: with Alt where no command has the chord, and alone while a menu is open.

#include <string>
#include <vector>

namespace hariko {

/// A letter for each menu, in capitals: the first of its English name that no earlier menu has; 0 where none
/// is left.
std::vector<char> menu_letters(const std::vector<std::string>& menus);

/// The menu that a key means, by its letter; null for none.
const std::string* menu_of_letter(const std::vector<std::string>& menus, int key);

}  // namespace hariko
