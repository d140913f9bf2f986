// Formatting of ObjectInfo as JSON and as text.

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include "app/commands/object_info.hpp"
#include "core/base/text/json_writer.hpp"
#include "core/polyhedron/message_summary.hpp"

namespace hariko {

namespace {

struct InfoMember;
using InfoMembers = std::vector<InfoMember>;

/// Value of a report, formatted with the same keys for JSON and for text.
struct InfoValue {
  std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<double>,
               std::shared_ptr<const InfoMembers>>
      state;

  InfoValue() = default;
  template <class T>
  InfoValue(const T& value) {  // NOLINT: implicit on purpose
    if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>)
      state = static_cast<std::int64_t>(value);
    else if constexpr (std::is_convertible_v<T, const char*>)
      state = std::string(value);
    else if constexpr (std::is_same_v<T, InfoMembers>)
      state = std::make_shared<const InfoMembers>(value);
    else
      state = value;
  }
  template <class T>
  InfoValue(const std::optional<T>& value) {  // NOLINT: implicit on purpose
    if (value) *this = InfoValue(*value);
  }
};

struct InfoMember {
  std::string key;
  InfoValue value;
};

InfoValue range_of(const std::optional<CurvatureRange>& range) {
  if (!range) return {};
  return std::vector<double>{range->least, range->greatest};
}

InfoMembers members_of(const SurfaceComparison& comparison) {
  return {{"patches", comparison.patches},
          {"unchanged", comparison.unchanged},
          {"changed", comparison.changed},
          {"unmatched", comparison.unmatched},
          {"largest_distance", comparison.largest_distance}};
}

InfoMembers members_of(const OutlineInfo& outline) {
  return {{"method", outline.method},
          {"loops", outline.loops},
          {"points", outline.points},
          {"inserted", outline.inserted},
          {"gap", outline.gap}};
}

InfoMembers members_of(const EnvelopeInfo& envelope) {
  InfoMembers out = {
      {"solids", envelope.solids}, {"method", envelope.method},     {"enclosed", envelope.enclosed},
      {"worst", envelope.worst},   {"tested", envelope.tested},     {"outside", envelope.outside},
      {"folds", envelope.folds},   {"crossing", envelope.crossing}, {"coarse", envelope.coarse},
      {"rounds", envelope.rounds}, {"symmetry", envelope.symmetry}};
  if (envelope.sticks_out) out.push_back({"sticks_out", *envelope.sticks_out});
  if (envelope.symmetry != "none") {
    out.push_back({"images", envelope.images});
    out.push_back({"symmetric", envelope.symmetric});
  }
  return out;
}

InfoMembers members_of(const SkinInfo& skin) {
  InfoMembers extraordinary;
  for (const auto& [kind, count] : skin.extraordinary) extraordinary.push_back({kind, count});
  return {{"sections", skin.sections},
          {"method", skin.method},
          {"rows", skin.rows},
          {"columns", skin.columns > 0 ? InfoValue(skin.columns) : InfoValue()},
          {"extraordinary", extraordinary},
          {"creases", skin.creases},
          {"regular_faces", skin.regular_faces},
          {"condition", skin.condition},
          {"section_miss", skin.section_miss}};
}

/// All members but the messages and the times, in the order of the report.
InfoMembers members_of(const ObjectInfo& info) {
  InfoMembers out = {{"name", info.name},
                     {"kind", info.kind},
                     {"vertices", info.vertices},
                     {"edges", info.edges},
                     {"faces", info.faces},
                     {"patches", info.patches},
                     {"components", info.components},
                     {"genus", info.genus},
                     {"boundary_loops", info.boundary_loops},
                     {"area", info.area},
                     {"volume", info.volume},
                     {"bending", info.bending},
                     {"largest_gap", info.largest_gap},
                     {"largest_normal_jump", info.largest_normal_jump},
                     {"rms_curvature_jump", info.rms_curvature_jump},
                     {"gauss_range", range_of(info.gauss_range)},
                     {"mean_range", range_of(info.mean_range)},
                     {"degenerate_samples", info.degenerate_samples},
                     {"folded_samples", info.folded_samples}};
  if (info.places) out.push_back({"places", *info.places});
  if (info.envelope) out.push_back({"envelope", members_of(*info.envelope)});
  if (info.skin) out.push_back({"skin", members_of(*info.skin)});
  if (info.outline) out.push_back({"outline", members_of(*info.outline)});
  if (info.against)
    out.push_back({"against", *info.against ? InfoValue(members_of(**info.against)) : InfoValue()});
  return out;
}

InfoMembers times_of(const ObjectInfo& info) {
  InfoMembers out;
  for (const auto& [step, time] : info.milliseconds) out.push_back({step, time});
  return out;
}

void write(JsonWriter& json, const InfoMembers& members);

void write(JsonWriter& json, const InfoValue& value) {
  std::visit(
      [&](const auto& state) {
        using T = std::decay_t<decltype(state)>;
        if constexpr (std::is_same_v<T, std::monostate>)
          json.value(nullptr);
        else if constexpr (std::is_same_v<T, std::shared_ptr<const InfoMembers>>)
          write(json, *state);
        else
          json.value(state);
      },
      value.state);
}

void write(JsonWriter& json, const InfoMembers& members) {
  json.object([&] {
    for (const InfoMember& member : members) {
      json.key(member.key);
      write(json, member.value);
    }
  });
}

void write(JsonWriter& json, const Message& message) {
  const std::string element = to_string(message.element);
  json.object([&] {
    json.member("code", message.code.name);
    json.member("severity", message.severity == Severity::error ? "error" : "warning");
    json.member("element", element.empty() ? std::nullopt : std::optional(element));
    json.member("text", message.remedy.empty() ? message.text : message.text + " " + message.remedy);
  });
}

void write(JsonWriter& json, const GroupInfo& info) {
  json.object([&] {
    json.member("id", info.id);
    json.member("name", info.name);
    json.member("parent", info.parent);
    json.member("visible", info.visible);
    json.member("locked", info.locked);
    json.member("objects", info.objects);
  });
}

void write(JsonWriter& json, const DimensionInfo& info) {
  json.object([&] {
    json.member("kind", info.kind);
    json.member("value", info.value);
    if (!info.radii.empty()) json.member("radii", info.radii);
    json.member("points", info.points);
    json.member("anchors", info.anchors);
  });
}

/// Value as text, with six significant digits; the JSON has all digits.
std::string readable(const InfoValue& value) {
  if (std::holds_alternative<std::monostate>(value.state)) return "-";
  const double* real = std::get_if<double>(&value.state);
  if (!real) {
    JsonWriter json;
    write(json, value);
    return json.take();
  }
  return rounded_text(*real, 6);
}

std::string line(const InfoMember& member) {
  std::string text;
  if (const auto* words = std::get_if<std::string>(&member.value.state)) {
    text = *words;
  } else if (const auto* range = std::get_if<std::vector<double>>(&member.value.state)) {
    text = readable(range->front()) + " .. " + readable(range->back());
  } else if (const auto* members = std::get_if<std::shared_ptr<const InfoMembers>>(&member.value.state)) {
    for (const InfoMember& inner : **members)
      text += (text.empty() ? "" : ", ") + inner.key + " " + readable(inner.value);
  } else {
    text = readable(member.value);
  }
  std::string label = member.key;
  std::replace(label.begin(), label.end(), '_', ' ');
  return info_line(std::move(label), text);
}

std::string text_of(const Message& message) {
  std::string out = message.severity == Severity::error ? "error " : "warning ";
  out += message.code.name;
  if (const std::string element = to_string(message.element); !element.empty()) out += " (" + element + ")";
  out += ": " + message.text;
  return message.remedy.empty() ? out + "\n" : out + " " + message.remedy + "\n";
}

}  // namespace

std::string info_json(const std::vector<ObjectInfo>& objects, const std::vector<GroupInfo>& groups,
                      const std::vector<DimensionInfo>& dimensions) {
  JsonWriter json(2);
  json.object([&] {
    json.list("objects", objects, [&](const ObjectInfo& info) {
      json.object([&] {
        for (const InfoMember& member : members_of(info)) {
          json.key(member.key);
          write(json, member.value);
        }
        json.list("messages", info.messages, [&](const Message& message) { write(json, message); });
        json.key("milliseconds");
        write(json, times_of(info));
      });
    });
    json.list("groups", groups, [&](const GroupInfo& info) { write(json, info); });
    json.list("dimensions", dimensions, [&](const DimensionInfo& info) { write(json, info); });
  });
  return json.take() + "\n";
}

std::string info_head(const ObjectInfo& object) {
  std::string out;
  for (const InfoMember& member : members_of(object)) {
    if (std::holds_alternative<std::monostate>(member.value.state)) break;
    out += line(member);
  }
  return out;
}

std::string info_text(const std::vector<ObjectInfo>& objects) {
  std::string out;
  for (const ObjectInfo& info : objects) {
    if (!out.empty()) out += "\n";
    for (const InfoMember& member : members_of(info)) out += line(member);
    out += line({"milliseconds", times_of(info)});
    for (const MessageSummary& summary : summarised(info.messages)) out += text_of(one_message(summary));
  }
  return out.empty() ? "The document has no objects.\n" : out;
}

}  // namespace hariko
