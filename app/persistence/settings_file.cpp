#include "app/persistence/settings_file.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <system_error>
#include <utility>

#include "core/base/files/file_io.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/words.hpp"
#include "core/drawing/write_drawing_svg.hpp"
#include "core/exchange/mesh_file.hpp"
#include "render/picture.hpp"
#include "ui/base/settings_members.hpp"
#include "ui/files/key_file.hpp"

namespace hariko {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::uint64_t largest_settings = 1 << 20;  // bytes
constexpr const char *exports_member = "exports", *cad_member = "cad", *picture_member = "picture",
                     *drawing_member = "drawing", *folders_member = "folders";

/// Visits the members of a triangle export's settings; lengths are in the document's unit.
template <class AnyExport, class Visitor>
void visit_export(AnyExport& e, Visitor& visitor) {
  constexpr double longest = 1e300;
  visitor.choice("by", e.by);
  visitor.number("distance", 0, longest, e.distance);
  visitor.number("angle", 0, std::numbers::pi / 2, e.angle);
  visitor.flag("optimise", e.optimise);
  visitor.number("density", 1, 64, e.density);
  visitor.choice("unit", e.choices.unit, "document");
  visitor.number("scale", 1e-6, 1e6, e.choices.scale);
  visitor.flag("y_up", e.choices.y_up);
  visitor.flag("ascii", e.choices.ascii);
  visitor.flag("to_zero", e.choices.to_zero);
}

template <class AnyChoices, class Visitor>
void visit_cad(AnyChoices& c, Visitor& visitor) {
  constexpr double longest = 1e300;
  visitor.number("tolerance", 0, longest, c.tolerance);
  visitor.number("angle", 0, 1, c.angle);
  visitor.choice("quality", c.quality);
  visitor.flag("exact", c.exact);
  visitor.flag("whole_faces", c.whole_faces);
  visitor.choice("unit", c.unit);
  visitor.number("scale", 1e-6, 1e6, c.scale);
  visitor.flag("ap242", c.ap242);
}

template <class AnyPicture, class Visitor>
void visit_picture(AnyPicture& p, Visitor& visitor) {
  visitor.choice("size", p.size);
  visitor.number("width", 1, max_picture_side, p.custom.width);
  visitor.number("height", 1, max_picture_side, p.custom.height);
  visitor.flag("transparent", p.transparent);
  visitor.flag("grid", p.grid);
  visitor.flag("selection", p.selection);
  visitor.flag("legend", p.legend);
  visitor.number("turntable_pictures", 1, most_turntable_pictures, p.turntable_pictures);
  visitor.flag("fit", p.fit);
}

template <class AnyDrawing, class Visitor>
void visit_drawing(AnyDrawing& d, Visitor& visitor) {
  visitor.number("width", least_page_side, most_page_side, d.width);
  visitor.flag("network", d.network);
  visitor.flag("hidden", d.hidden);
}

/// File ending of a format name, ".stl" for "stl"; nothing where that format is not written.
std::optional<std::string> written_ending(const std::string& name) {
  const std::string ending = "." + name;
  const fs::path file = "a" + ending;
  if (file.extension() != ending || !written_format(file)) return {};
  return ending;
}

/// Parsed JSON; discarded where it is invalid, or nested deeper than any settings, as writing it recurses as
/// deep.
Json parsed(std::string_view text) {
  constexpr int deepest = 32;
  bool too_deep = false;
  const auto shallow = [&](int depth, Json::parse_event_t, Json&) {
    too_deep = too_deep || depth > deepest;
    return !too_deep;
  };
  Json json = Json::parse(text, shallow, false);
  return too_deep ? Json(Json::value_t::discarded) : json;
}

/// Member as an object, replaced by an empty one where it is not.
Json& object_at(Json& json, const std::string& name) {
  Json& member = json[name];
  if (!member.is_object()) member = Json::object();
  return member;
}

/// Reads valid members and remembers the names of invalid ones.
class Reader {
 public:
  explicit Reader(const Json& json, std::string place = {}) : json_(json), place_(std::move(place)) {}
  const std::string& wrong() const { return wrong_; }

  void flag(const char* name, bool& value) {
    const Json* json = find(name);
    if (json && json->is_boolean())
      value = json->get<bool>();
    else if (json)
      refuse(name);
  }
  template <class Number>
  void number(const char* name, double least, double most, Number& value) {
    const Json* json = find(name);
    const double number = json && json->is_number() ? json->get<double>() : std::nan("");
    if (number >= least && number <= most)
      value = static_cast<Number>(number);
    else if (json)
      refuse(name);
  }
  template <class Enum>
  void choice(const char* name, Enum& value) {
    const std::string* word = find_word(name);
    if (!word) return;
    const auto read = enum_value<Enum>(*word);
    read ? void(value = *read) : refuse(name);
  }
  /// `none`: the word for no choice.
  template <class Enum>
  void choice(const char* name, std::optional<Enum>& value, const char* none) {
    const std::string* word = find_word(name);
    if (!word) return;
    const auto read = enum_value<Enum>(*word);
    read || *word == none ? void(value = read) : refuse(name);
  }
  void text(const char* name, std::string& value) {
    if (const std::string* read = find_word(name)) value = *read;
  }
  void texts(const char* name, std::map<std::string, std::string>& value) {
    const Json* json = find(name);
    if (!json) return;
    if (!json->is_object()) return refuse(name);
    Reader inner(*json, place_ + name + ".");
    inner.entries(value);
    if (!inner.wrong_.empty()) wrong_ += (wrong_.empty() ? "" : ", ") + inner.wrong_;
  }
  /// All members are texts.
  void entries(std::map<std::string, std::string>& value) {
    for (const auto& [key, text] : json_.items())
      if (text.is_string())
        value[key] = text.get<std::string>();
      else
        refuse(shortened(key, 120));
  }
  /// Reads the choices for formats that this version writes.
  void exports(ExportMemory& memory) {
    const Json* json = find(exports_member);
    if (!json) return;
    if (!json->is_object()) return refuse(exports_member);
    for (const auto& [name, item] : json->items()) {
      const auto ending = written_ending(name);
      if (!ending && name != cad_member && name != picture_member && name != drawing_member &&
          name != folders_member)
        continue;
      const std::string place = exports_member + ("." + name);
      if (!item.is_object()) {
        refuse(place);
        continue;
      }
      Reader inner(item, place + ".");
      if (ending)
        visit_export(memory.formats[*ending], inner);
      else if (name == folders_member)
        inner.entries(memory.folders);
      else if (name == cad_member)
        visit_cad(memory.cad, inner);
      else if (name == picture_member)
        visit_picture(memory.picture, inner);
      else
        visit_drawing(memory.drawing, inner);
      if (!inner.wrong_.empty()) wrong_ += (wrong_.empty() ? "" : ", ") + inner.wrong_;
    }
  }

 private:
  const Json* find(const char* name) const {
    const auto it = json_.find(name);
    return it == json_.end() ? nullptr : &*it;
  }
  /// Text of a member; refused where it is something else.
  const std::string* find_word(const char* name) {
    const Json* json = find(name);
    if (json && !json->is_string()) refuse(name);
    return json ? json->get_ptr<const std::string*>() : nullptr;
  }
  void refuse(const std::string& name) { wrong_ += (wrong_.empty() ? "" : ", ") + place_ + name; }

  const Json& json_;
  std::string place_;  ///< prefix of the members' names
  std::string wrong_;
};

class Writer {
 public:
  explicit Writer(Json& json) : json_(json) {}
  void flag(const char* name, bool value) { json_[name] = value; }
  template <class Number>
  void number(const char* name, double, double, Number value) {
    json_[name] = value;
  }
  template <class Enum>
  void choice(const char* name, Enum value) {
    json_[name] = enum_word(value);
  }
  template <class Enum>
  void choice(const char* name, std::optional<Enum> value, const char* none) {
    json_[name] = value ? enum_word(*value) : none;
  }
  void text(const char* name, const std::string& value) { json_[name] = value; }
  void texts(const char* name, const std::map<std::string, std::string>& value) { json_[name] = value; }
  void exports(const ExportMemory& memory) {
    Json& json = object_at(json_, exports_member);
    for (const auto& [ending, settings] : memory.formats) {
      Writer inner(object_at(json, ending.substr(1)));
      visit_export(settings, inner);
    }
    // One after the other: a new member may move the others in memory.
    Writer picture(object_at(json, picture_member));
    visit_picture(memory.picture, picture);
    Writer drawing(object_at(json, drawing_member));
    visit_drawing(memory.drawing, drawing);
    if (!memory.folders.empty() || json.contains(folders_member)) json[folders_member] = memory.folders;
    if (memory.cad == CadChoices{}) return;
    Writer cad(object_at(json, cad_member));
    visit_cad(memory.cad, cad);
  }

 private:
  Json& json_;
};

/// Name for keeping a broken file: the first free one.
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
  visit_settings(writer, settings);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Settings settings_of(std::string_view text) {
  Settings settings;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return settings;
  Reader reader(json);
  visit_settings(reader, settings);
  return settings;
}

SettingsFile::Loaded SettingsFile::load() {
  Loaded loaded;
  const auto text = read_file(file_, largest_settings);
  if (!text) {
    std::error_code unknown;
    if (fs::exists(file_, unknown)) loaded.problems.push_back(text.error());
    return loaded;
  }
  const Json json = parsed(*text);
  if (!json.is_object()) {
    const fs::path kept = aside(file_);
    std::error_code error;
    fs::rename(file_, kept, error);
    loaded.problems.push_back(make_warning(
        w_settings_broken,
        "The settings in " + sanitized_utf8(file_.string()) + " cannot be read. The defaults are used.",
        error ? std::string()
              : "The broken file is kept as " + sanitized_utf8(kept.filename().string()) + "."));
    return loaded;
  }
  kept_ = *text;
  Reader reader(json);
  visit_settings(reader, loaded.settings);
  take_present_ids(loaded.settings.keys);
  reader.exports(loaded.exports);
  if (!reader.wrong().empty())
    loaded.problems.push_back(make_warning(
        w_settings_value,
        "Some settings have values that are not possible: " + reader.wrong() + ". Their defaults are used."));
  return loaded;
}

Result<Done> SettingsFile::save(const Settings& settings, const ExportMemory& exports) {
  Json json = parsed(kept_);
  if (!json.is_object()) json = Json::object();
  Writer writer(json);
  visit_settings(writer, settings);
  writer.exports(exports);
  std::error_code unknown;  // a failure shows when the file is written
  fs::create_directories(file_.parent_path(), unknown);
  kept_ = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  return write_file_atomic(file_, kept_);
}

}  // namespace hariko
