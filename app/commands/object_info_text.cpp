// ObjectInfo as JSON and as text.

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "app/commands/object_info.hpp"

namespace hariko {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json value_or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json range_or_null(const std::optional<CurvatureRange>& range) {
  return range ? Json::array({range->least, range->greatest}) : Json(nullptr);
}

Json to_json(const Message& message) {
  const std::string element = to_string(message.element);
  return {{"code", std::string(message.code.name)},
          {"severity", message.severity == Severity::error ? "error" : "warning"},
          {"element", element.empty() ? Json(nullptr) : Json(element)},
          {"text", message.remedy.empty() ? message.text : message.text + " " + message.remedy}};
}

Json to_json(const std::optional<SurfaceComparison>& comparison) {
  if (!comparison) return nullptr;
  return {{"patches", comparison->patches},
          {"unchanged", comparison->unchanged},
          {"changed", comparison->changed},
          {"unmatched", comparison->unmatched},
          {"largest_distance", value_or_null(comparison->largest_distance)}};
}

Json to_json(const OutlineInfo& outline) {
  return {{"method", outline.method},
          {"loops", outline.loops},
          {"points", outline.points},
          {"inserted", outline.inserted},
          {"gap", outline.gap}};
}

Json to_json(const EnvelopeInfo& envelope) {
  Json out = {
      {"solids", envelope.solids},     {"method", envelope.method},    {"level", envelope.level},
      {"enclosed", envelope.enclosed}, {"worst", envelope.worst},      {"tested", envelope.tested},
      {"outside", envelope.outside},   {"folds", envelope.folds},      {"crossing", envelope.crossing},
      {"builds", envelope.builds},     {"symmetry", envelope.symmetry}};
  if (envelope.symmetry != "none") {
    out["images"] = envelope.images;
    out["symmetric"] = envelope.symmetric;
  }
  return out;
}

Json to_json(const SkinInfo& skin) {
  Json extraordinary = Json::object();
  for (const auto& [kind, count] : skin.extraordinary) extraordinary[kind] = count;
  return {{"sections", skin.sections},
          {"method", skin.method},
          {"rows", skin.rows},
          {"columns", skin.columns > 0 ? Json(skin.columns) : Json(nullptr)},
          {"extraordinary", extraordinary},
          {"creases", skin.creases},
          {"regular_faces", skin.regular_faces},
          {"condition", value_or_null(skin.condition)},
          {"section_miss", skin.section_miss}};
}

Json to_json(const ObjectInfo& info) {
  Json out = {{"name", info.name},
              {"kind", info.kind},
              {"vertices", value_or_null(info.vertices)},
              {"edges", value_or_null(info.edges)},
              {"faces", value_or_null(info.faces)},
              {"patches", value_or_null(info.patches)},
              {"components", value_or_null(info.components)},
              {"genus", value_or_null(info.genus)},
              {"boundary_loops", value_or_null(info.boundary_loops)},
              {"area", value_or_null(info.area)},
              {"volume", value_or_null(info.volume)},
              {"bending", value_or_null(info.bending)},
              {"largest_gap", value_or_null(info.largest_gap)},
              {"largest_normal_jump", value_or_null(info.largest_normal_jump)},
              {"rms_curvature_jump", value_or_null(info.rms_curvature_jump)},
              {"gauss_range", range_or_null(info.gauss_range)},
              {"mean_range", range_or_null(info.mean_range)},
              {"degenerate_samples", value_or_null(info.degenerate_samples)},
              {"folded_samples", value_or_null(info.folded_samples)}};
  if (info.envelope) out["envelope"] = to_json(*info.envelope);
  if (info.skin) out["skin"] = to_json(*info.skin);
  if (info.outline) out["outline"] = to_json(*info.outline);
  if (info.against) out["against"] = to_json(*info.against);
  out["messages"] = Json::array();
  for (const Message& message : info.messages) out["messages"].push_back(to_json(message));
  out["milliseconds"] = Json::object();
  for (const auto& [step, time] : info.milliseconds) out["milliseconds"][step] = time;
  return out;
}

Json all_to_json(const std::vector<ObjectInfo>& objects) {
  Json out = {{"objects", Json::array()}};
  for (const ObjectInfo& info : objects) out["objects"].push_back(to_json(info));
  return out;
}

std::string dump(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// Six significant digits are enough to read; the JSON has them all.
std::string readable(const Json& value) {
  if (!value.is_number_float()) return value.is_null() ? "-" : dump(value, -1);
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value.get<double>(),
                                 std::chars_format::general, 6);
  return {digits.data(), end.ptr};
}

std::string line(const std::string& key, const Json& value) {
  std::string text;
  if (value.is_string())
    text = value.get<std::string>();
  else if (value.is_array())
    text = readable(value[0]) + " .. " + readable(value[1]);
  else if (value.is_object())
    for (const auto& [step, time] : value.items())
      text += (text.empty() ? "" : ", ") + step + " " + readable(time);
  else
    text = readable(value);
  std::string label = key;
  std::replace(label.begin(), label.end(), '_', ' ');
  label.resize(std::max<std::size_t>(label.size() + 2, 22), ' ');
  return label + text + "\n";
}

}  // namespace

std::string info_json(const std::vector<ObjectInfo>& objects) {
  return dump(all_to_json(objects), 2) + "\n";
}

std::string info_text(const std::vector<ObjectInfo>& objects) {
  std::string out;
  const Json all = all_to_json(objects);
  for (const Json& object : all["objects"]) {
    if (!out.empty()) out += "\n";
    for (const auto& [key, value] : object.items())
      if (key != "messages") out += line(key, value);
    for (const Json& message : object["messages"]) {
      out += message["severity"].get<std::string>() + " " + message["code"].get<std::string>();
      if (!message["element"].is_null()) out += " (" + message["element"].get<std::string>() + ")";
      out += ": " + message["text"].get<std::string>() + "\n";
    }
  }
  return out.empty() ? "The document has no objects.\n" : out;
}

}  // namespace hariko
