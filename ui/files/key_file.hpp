#pragma once

// Key files: the keys that one has chosen, to take along to another machine or to give to others.

#include <map>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_key_file{"E_KEY_FILE"};

/// Id of a command → its keys as text ("Ctrl+B / F8"), for those whose keys are not the default ones: what
/// `Settings::keys` holds and `CommandTable::rebind` applies.
using KeyOverrides = std::map<std::string, std::string>;

/// JSON: {"format": "hariko-keys", "version": 1, "keys": {"mesh.knife": "F8"}}.
std::string write_key_file(const KeyOverrides& keys);

/// Refuses (E_KEY_FILE) what is no key file of a version that this program knows, as a whole. Unknown
/// commands, keys that are none and keys given twice are named by `CommandTable::rebind`.
Result<KeyOverrides> read_key_file(std::string_view text);

/// Gives keys of commands whose ids have changed the present ids. Keys of the present id stay.
void take_present_ids(KeyOverrides& keys);

}  // namespace hariko
