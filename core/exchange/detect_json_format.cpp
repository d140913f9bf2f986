#include "core/exchange/detect_json_format.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/files/file_io.hpp"
#include "core/exchange/imported_mesh.hpp"

namespace hariko {

namespace {

using Json = nlohmann::json;

struct Entry {
  JsonKind kind;
  std::string_view name;
  std::string_view format;   ///< value of the member "format"; empty for kinds without one
  std::string_view use;      ///< advice for kinds that cannot be opened
  std::string_view marks{};  ///< distinguishing members of kinds without a format, for messages
};
constexpr std::array entries{
    Entry{JsonKind::document, "a Hariko document", "hariko", ""},
    Entry{JsonKind::patches, "Bezier patches", "", "", "\"ctrl\": rows of points"},
    Entry{JsonKind::scene, "solids", "", "", "\"primitives\""},
    Entry{JsonKind::skin, "sections to skin", "", "", "\"path\" and \"sections\""},
    Entry{JsonKind::outline, "outlines with normals", "", "", "\"loops\""},
    Entry{JsonKind::keys, "key bindings", "hariko-keys", "Read it in Preferences, Keys."},
    Entry{JsonKind::layout, "a paper model's layout", "unfolding-1", "Open the model that it was made from."},
};

const Entry& entry_of(JsonKind kind) {
  return *std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.kind == kind; });
}

/// Collects the top-level members, the value of "format", and whether an object two levels down has "ctrl".
class Marks : public nlohmann::json_sax<Json> {
 public:
  std::string format;
  bool controls = false;
  bool primitives = false, path = false, sections = false, loops = false;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t& value) override {
    if (depth_ == 1 && key_ == "format") format = value;
    return true;
  }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return deeper(); }
  bool end_object() override { return shallower(); }
  bool start_array(std::size_t) override { return deeper(); }
  bool end_array() override { return shallower(); }
  bool key(string_t& name) override {
    if (depth_ == 1) note(name);
    controls = controls || (depth_ == 3 && name == "ctrl");
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  void note(const std::string& name) {
    key_ = name;
    primitives = primitives || name == "primitives";
    path = path || name == "path";
    sections = sections || name == "sections";
    loops = loops || name == "loops";
  }
  bool deeper() {
    ++depth_;
    return true;
  }
  bool shallower() {
    --depth_;
    return true;
  }
  std::size_t depth_ = 0;
  std::string key_;
};

std::string accepted() {
  std::string out;
  for (const Entry& entry : entries) {
    if (!entry.use.empty()) continue;
    if (!out.empty()) out += ", ";
    out += entry.name;
    out += entry.format.empty() ? " (" + std::string(entry.marks) + ")"
                                : " (\"format\": \"" + std::string(entry.format) + "\")";
  }
  return out;
}

}  // namespace

Result<JsonKind> json_kind(std::string_view text) {
  Marks marks;
  if (!Json::sax_parse(text, &marks))
    return make_error(e_parse, "The file is not JSON, or is cut off.",
                      "Files of " + accepted() + " can be opened.");
  for (const Entry& entry : entries)
    if (!entry.format.empty() && entry.format == marks.format) return entry.kind;
  if (marks.controls) return JsonKind::patches;
  if (marks.primitives) return JsonKind::scene;
  if (marks.path && marks.sections) return JsonKind::skin;
  if (marks.loops) return JsonKind::outline;
  return make_error(e_format_unknown, "The file is JSON of a kind that this program does not know.",
                    "Files of " + accepted() + " can be opened.");
}

std::string_view name_of(JsonKind kind) {
  return entry_of(kind).name;
}
std::string_view use_of(JsonKind kind) {
  return entry_of(kind).use;
}

}  // namespace hariko
