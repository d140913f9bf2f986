#include "app/persistence/settings_file.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "core/base/file_io.hpp"
#include "core/base/printable.hpp"

namespace hariko {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uint64_t largest_file = 1 << 20;  // bytes

template <class Value>
using Names = std::initializer_list<std::pair<const char*, Value>>;

/// The one list of members: `visitor` reads them from JSON or writes them to it.
template <class AnySettings, class Visitor>
void visit(AnySettings& s, Visitor& visitor) {
  visitor.choice("theme", s.theme, Names<ThemeId>{{"dark", ThemeId::dark}, {"light", ThemeId::light}});
  visitor.choice("language", s.language,
                 Names<LanguageId>{{"english", LanguageId::english}, {"japanese", LanguageId::japanese}});
  visitor.number("interface_scale", s.interface_scale, 0.5, 3);
  visitor.flag("colour_blind_maps", s.colour_blind_maps);
  visitor.choice(
      "unit", s.unit,
      Names<Unit>{
          {"mm", Unit::millimetre}, {"cm", Unit::centimetre}, {"m", Unit::metre}, {"in", Unit::inch}});
  visitor.choice("navigation", s.navigation,
                 Names<NavigationPreset>{{"hariko", NavigationPreset::hariko},
                                         {"blender", NavigationPreset::blender},
                                         {"maya", NavigationPreset::maya},
                                         {"rhino", NavigationPreset::rhino},
                                         {"trackpad", NavigationPreset::trackpad}});
  visitor.flag("trackball", s.trackball);
  visitor.flag("zoom_to_cursor", s.zoom_to_cursor);
  visitor.flag("invert_wheel", s.invert_wheel);
  visitor.flag("orbit_selection", s.orbit_selection);
  visitor.number("orbit_speed", s.orbit_speed, 0.05, 20);
  visitor.number("zoom_speed", s.zoom_speed, 0.05, 20);
  visitor.number("autosave_seconds", s.autosave_seconds, 1, Settings::most_autosave_seconds);
  visitor.texts("keys", s.keys);
  visitor.number("side_width", s.side_width, 100, 2000);
}

/// Takes what is right and remembers the names of what is not.
class Reader {
 public:
  explicit Reader(const Json& json) : json_(json) {}
  const std::string& wrong() const { return wrong_; }

  void flag(const char* name, bool& value) {
    const Json* json = find(name);
    if (json && json->is_boolean())
      value = json->get<bool>();
    else if (json)
      refuse(name);
  }
  template <class Number>
  void number(const char* name, Number& value, double least, double most) {
    const Json* json = find(name);
    const double number = json && json->is_number() ? json->get<double>() : std::nan("");
    if (number >= least && number <= most)
      value = static_cast<Number>(number);
    else if (json)
      refuse(name);
  }
  template <class Value>
  void choice(const char* name, Value& value, Names<Value> names) {
    const Json* json = find(name);
    if (!json) return;
    for (const auto& [text, choice] : names)
      if (*json == text) {
        value = choice;
        return;
      }
    refuse(name);
  }
  void texts(const char* name, std::map<std::string, std::string>& value) {
    const Json* json = find(name);
    if (!json) return;
    if (!json->is_object()) return refuse(name);
    for (const auto& [key, text] : json->items())
      if (text.is_string())
        value[key] = text.get<std::string>();
      else
        refuse(name + ("." + printable(key, 60)));
  }

 private:
  const Json* find(const char* name) const {
    const auto it = json_.find(name);
    return it == json_.end() ? nullptr : &*it;
  }
  void refuse(const std::string& name) { wrong_ += (wrong_.empty() ? "" : ", ") + name; }

  const Json& json_;
  std::string wrong_;
};

class Writer {
 public:
  explicit Writer(Json& json) : json_(json) {}
  void flag(const char* name, bool value) { json_[name] = value; }
  template <class Number>
  void number(const char* name, Number value, double, double) {
    json_[name] = value;
  }
  template <class Value>
  void choice(const char* name, Value value, Names<Value> names) {
    for (const auto& [text, choice] : names)
      if (choice == value) json_[name] = text;
  }
  void texts(const char* name, const std::map<std::string, std::string>& value) { json_[name] = value; }

 private:
  Json& json_;
};

/// Where a broken file is kept: the first free name.
fs::path aside(const fs::path& file) {
  std::error_code unknown;
  for (int i = 1;; ++i) {
    const fs::path name = fs::path(file).replace_extension(".broken-" + std::to_string(i) + ".json");
    if (i == 1000 || !fs::exists(name, unknown)) return name;
  }
}

}  // namespace

std::string settings_text(const Settings& settings) {
  Json json = Json::object();
  Writer writer(json);
  visit(settings, writer);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Settings settings_of(std::string_view text) {
  Settings settings;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return settings;
  Reader reader(json);
  visit(settings, reader);
  return settings;
}

SettingsFile::Loaded SettingsFile::load() {
  Loaded loaded;
  const auto text = read_file(file_, largest_file);
  if (!text) {
    std::error_code unknown;
    if (fs::exists(file_, unknown)) loaded.problems.push_back(text.error());
    return loaded;
  }
  const Json json = Json::parse(*text, nullptr, false);
  if (!json.is_object()) {
    const fs::path kept = aside(file_);
    std::error_code error;
    fs::rename(file_, kept, error);
    loaded.problems.push_back(make_warning(
        w_settings_broken,
        "The settings in " + printable(file_.string()) + " cannot be read. The defaults are used.",
        error ? std::string() : "The broken file is kept as " + printable(kept.filename().string()) + "."));
    return loaded;
  }
  kept_ = *text;
  Reader reader(json);
  visit(loaded.settings, reader);
  if (!reader.wrong().empty())
    loaded.problems.push_back(make_warning(
        w_settings_value,
        "Some settings have values that are not possible: " + reader.wrong() + ". Their defaults are used."));
  return loaded;
}

Result<Done> SettingsFile::save(const Settings& settings) const {
  Json json = Json::parse(kept_, nullptr, false);
  if (!json.is_object()) json = Json::object();
  Writer writer(json);
  visit(settings, writer);
  std::error_code unknown;  // writing says what is wrong
  fs::create_directories(file_.parent_path(), unknown);
  return write_file_atomic(file_, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace hariko
