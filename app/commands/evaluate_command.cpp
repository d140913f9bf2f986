#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <variant>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "app/commands/evaluation.hpp"
#include "core/base/files/file_io.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "ui/base/text_number.hpp"

namespace hariko {

namespace {

constexpr Code e_not_one_polyhedron{"E_NOT_ONE_POLYHEDRON"};
constexpr Code e_tension_file{"E_TENSION_FILE"};
constexpr std::uint64_t tension_file_limit = std::uint64_t{64} << 20;  // bytes

/// Reads a tension file: {"beta": {"a-b": 10}, "alpha": {"a": 10}, "crease": [[a, b]], "corner": [a],
/// "smooth": [a]}.
class TensionReader {
 public:
  TensionReader(const Polyhedron& polyhedron, Shaping& shaping)
      : polyhedron_(polyhedron), shaping_(shaping) {}

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
        const auto id = number_in<std::uint32_t>(key);
        if (!id || !known(VertexId{*id})) return error(name + " does not name a vertex of the polyhedron.");
        shaping_.alpha.set(VertexId{*id}, value.get<double>());
        continue;
      }
      const auto ids = numbers_in<std::uint32_t, 2>(key, '-').value_or(std::array<std::uint32_t, 2>{});
      const EdgeId edge = EdgeId::of(VertexId{ids[0]}, VertexId{ids[1]});
      if (ids[0] == ids[1] || !known(edge)) return error(name + " does not name an edge of the polyhedron.");
      shaping_.beta.set(edge, value.get<double>());
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

/// Adds a file's settings to `shaping`. Vertices are named by their ids, which for mesh files are the
/// positions in the file from 0. Every member may be missing. Errors: E_TENSION_FILE for other texts and for
/// elements that the polyhedron does not have. O(size log elements).
Result<Shaping> read_tensions(std::string_view text, const Polyhedron& polyhedron, Shaping shaping) {
  const nlohmann::json file = nlohmann::json::parse(text, nullptr, false);
  if (file.is_discarded())
    return make_error(e_tension_file, "The tension file is not JSON.",
                      "Check that it is complete and saved as text.");
  if (auto failed = TensionReader(polyhedron, shaping).read(file)) return *failed;
  return shaping;
}

/// Numbers of an object of any kind but a polyhedron, which takes tensions and may stand beside others.
/// Nothing for kinds without any.
struct OtherNumbers {
  const Document& document;
  const Object& object;
  using Numbers = std::optional<Result<std::string>>;
  Numbers operator()(const SolidsSource& source) const { return solids_json(source); }
  Numbers operator()(const SkinSource& source) const { return skin_evaluation_json(*source.skin); }
  Numbers operator()(const OutlineSource& source) const { return outline_json(source); }
  Numbers operator()(const BezierSource&) const { return patch_evaluation_json(document, object); }
  Numbers operator()(const PatchSource&) const { return patch_evaluation_json(document, object); }
  Numbers operator()(const PolyhedronSource&) const { return {}; }
  Numbers operator()(const MeshSource&) const { return {}; }
  Numbers operator()(const PictureSource&) const { return {}; }
  Numbers operator()(const UnknownSource&) const { return {}; }
};

}  // namespace

int run_evaluate(const EvaluateArguments& arguments) {
  const auto document = read_document_or_report(arguments.file, arguments.construction);
  if (!document) return exit_failed;
  const auto answer = [&](const Result<std::string>& json) {
    if (!json.ok()) return failure(arguments.file, json.error());
    return print(*json) ? exit_fine : exit_failed;
  };
  if (document->objects.size() == 1) {
    const Object& only = *document->objects[0];
    if (const auto numbers = std::visit(OtherNumbers{*document, only}, only.source)) return answer(*numbers);
  }
  const PolyhedronSource* found = nullptr;
  int count = 0;
  for (const auto& object : document->objects)
    if (const PolyhedronSource* polyhedron = object->polyhedron()) {
      found = polyhedron;
      ++count;
    }
  if (count != 1)
    return failure(arguments.file, make_error(e_not_one_polyhedron,
                                              "The file has " + std::to_string(count) +
                                                  " polyhedra, but exactly one can be evaluated.",
                                              "Save the polyhedron to evaluate in a file of its own."));

  PolyhedronSource source = *found;
  if (arguments.tension) {
    const auto text = read_file(*arguments.tension, tension_file_limit);
    if (!text.ok()) return failure(*arguments.tension, text.error());
    auto shaping = read_tensions(*text, source.polyhedron, *source.shaping);
    if (!shaping.ok()) return failure(*arguments.tension, shaping.error());
    source.shaping = std::move(shaping).value();
  }
  return answer(evaluation_json(source));
}

}  // namespace hariko
