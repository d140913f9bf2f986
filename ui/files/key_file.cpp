#include "ui/files/key_file.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "ui/base/language.hpp"

namespace hariko {

namespace {

using Json = nlohmann::json;

constexpr const char* key_format = "hariko-keys";
constexpr int version = 1;

Message refused(const char* sentence) {
  return make_error(e_key_file, sentence,
                    translatable("Choose a file that Hariko exported from Preferences, Keys."));
}

}  // namespace

std::string write_key_file(const KeyOverrides& keys) {
  const Json json{{"format", key_format}, {"version", version}, {"keys", keys}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<KeyOverrides> read_key_file(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("format", Json()) != key_format)
    return refused(translatable("This is not a file of keys."));
  if (json.value("version", Json()) != version)
    return refused(translatable("This file of keys was written by another version of Hariko."));
  const Json keys = json.value("keys", Json());
  if (!keys.is_object()) return refused(translatable("This file of keys names no keys."));
  KeyOverrides overrides;
  for (const auto& [id, chords] : keys.items()) {
    if (!chords.is_string())
      return refused(translatable("This file of keys has an entry that is not a text."));
    overrides[id] = chords.get<std::string>();
  }
  take_present_ids(overrides);
  return overrides;
}

void take_present_ids(KeyOverrides& keys) {
  constexpr std::array<std::pair<const char*, const char*>, 5> changed{{
      {"property.preferences.turning", "property.preferences.trackball"},
      {"property.preferences.autosave", "property.preferences.autosave_seconds"},
      {"property.preferences.colours", "property.preferences.colour_blind_maps"},
      {"help.english", "language.english"},
      {"help.japanese", "language.japanese"},
  }};
  for (const auto& [before, now] : changed)
    if (auto node = keys.extract(before)) {
      node.key() = now;
      keys.insert(std::move(node));
    }
}

}  // namespace hariko
