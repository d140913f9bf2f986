#include "app/commands/tension_file.hpp"

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {

namespace {

class Reader {
 public:
  Reader(const Polyhedron& polyhedron, Shaping& shaping) : polyhedron_(polyhedron), shaping_(shaping) {}

  std::optional<Message> read(const nlohmann::json& file) {
    if (!file.is_object()) return error("The tension file is not a JSON object.");
    for (const auto& [key, value] : file.items()) {
      std::optional<Message> failed;
      if (key == "beta" || key == "alpha")
        failed = read_numbers(key, value);
      else if (key == "crease")
        failed = read_creases(value);
      else if (key == "corner" || key == "smooth")
        failed = read_tags(key, value);
      else
        failed = error("The tension file has the unknown member \"" + shortened(key, 120) + "\".");
      if (failed) return failed;
    }
    return std::nullopt;
  }

 private:
  static Message error(const std::string& text) {
    return make_error(e_tension_file, text,
                      "See the section on tension files of the command line's documentation.");
  }
  static std::optional<VertexId> parse_vertex(std::string_view text) {
    VertexId id;
    const auto end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data(), end, id.value);
    return status == std::errc() && stop == end ? std::optional(id) : std::nullopt;
  }
  std::optional<VertexId> vertex(const nlohmann::json& value) const {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= no_index) return std::nullopt;
    const VertexId id{value.get<std::uint32_t>()};
    return known(id) ? std::optional(id) : std::nullopt;
  }
  bool known(VertexId id) const { return polyhedron_.find(id) != no_index; }
  bool known(EdgeId id) const { return polyhedron_.find(id) != no_index; }

  std::optional<Message> read_numbers(const std::string& member, const nlohmann::json& values) {
    if (!values.is_object()) return error("\"" + member + "\" of the tension file is not an object.");
    for (const auto& [key, value] : values.items()) {
      const std::string name = "\"" + member + "\": {\"" + shortened(key, 120) + "\"} of the tension file";
      if (!value.is_number()) return error(name + " is not a number.");
      if (member == "alpha") {
        const auto id = parse_vertex(key);
        if (!id || !known(*id)) return error(name + " does not name a vertex of the polyhedron.");
        shaping_.alpha.set(*id, value.get<double>());
        continue;
      }
      const std::size_t dash = key.find('-');
      const auto a = parse_vertex(std::string_view(key).substr(0, dash));
      const auto b =
          dash == std::string::npos ? std::nullopt : parse_vertex(std::string_view(key).substr(dash + 1));
      if (!a || !b || *a == *b || !known(EdgeId::of(*a, *b)))
        return error(name + " does not name an edge of the polyhedron.");
      shaping_.beta.set(EdgeId::of(*a, *b), value.get<double>());
    }
    return std::nullopt;
  }

  std::optional<Message> read_creases(const nlohmann::json& values) {
    if (!values.is_array()) return error("\"crease\" of the tension file is not an array.");
    for (std::size_t i = 0; i < values.size(); ++i) {
      const nlohmann::json& pair = values[i];
      const auto a = pair.is_array() && pair.size() == 2 ? vertex(pair[0]) : std::nullopt;
      const auto b = a ? vertex(pair[1]) : std::nullopt;
      if (!b || *a == *b || !known(EdgeId::of(*a, *b)))
        return error("\"crease\"[" + std::to_string(i) +
                     "] of the tension file is not an edge of the polyhedron.");
      shaping_.crease.set(EdgeId::of(*a, *b), true);
    }
    return std::nullopt;
  }

  std::optional<Message> read_tags(const std::string& member, const nlohmann::json& values) {
    if (!values.is_array()) return error("\"" + member + "\" of the tension file is not an array.");
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto id = vertex(values[i]);
      if (!id)
        return error("\"" + member + "\"[" + std::to_string(i) +
                     "] of the tension file is not a vertex of the polyhedron.");
      shaping_.tag.set(*id, member == "corner" ? VertexTag::corner : VertexTag::smooth);
    }
    return std::nullopt;
  }

  const Polyhedron& polyhedron_;
  Shaping& shaping_;
};

}  // namespace

Result<Shaping> read_tensions(std::string_view text, const Polyhedron& polyhedron, Shaping shaping) {
  const nlohmann::json file = nlohmann::json::parse(text, nullptr, false);
  if (file.is_discarded())
    return make_error(e_tension_file, "The tension file is not JSON.",
                      "Check that it is complete and saved as text.");
  if (auto failed = Reader(polyhedron, shaping).read(file)) return *failed;
  return shaping;
}

}  // namespace hariko
