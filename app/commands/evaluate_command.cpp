#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "app/commands/evaluation.hpp"
#include "app/commands/outline_evaluation.hpp"
#include "app/commands/patch_evaluation.hpp"
#include "app/commands/skin_evaluation.hpp"
#include "app/commands/solids_evaluation.hpp"
#include "app/commands/tension_file.hpp"
#include "core/base/files/file_io.hpp"

namespace hariko {

namespace {

constexpr Code e_not_one_polyhedron{"E_NOT_ONE_POLYHEDRON"};
constexpr std::uint64_t tension_file_limit = std::uint64_t{64} << 20;  // bytes

int fail(const std::filesystem::path& file, const Message& message) {
  report(file.string(), message);
  return exit_failed;
}

}  // namespace

int run_evaluate(const EvaluateArguments& arguments) {
  const auto document = read_document_or_report(arguments.file, arguments.construction);
  if (!document) return exit_failed;
  const auto answer = [&](const Result<std::string>& json) {
    if (!json.ok()) return fail(arguments.file, json.error());
    return print(*json) ? exit_fine : exit_failed;
  };
  if (document->objects.size() == 1) {
    const Object& only = *document->objects[0];
    if (const SolidsSource* solids = only.solids()) return answer(solids_json(*solids));
    if (const SkinSource* skin = only.skin()) return answer(skin_evaluation_json(*skin->skin));
    if (const OutlineSource* outline = only.outline()) return answer(outline_json(*outline));
    if (only.bezier() || only.patches()) return answer(patch_evaluation_json(*document, only));
  }
  const PolyhedronSource* found = nullptr;
  int count = 0;
  for (const auto& object : document->objects)
    if (const PolyhedronSource* polyhedron = object->polyhedron()) {
      found = polyhedron;
      ++count;
    }
  if (count != 1)
    return fail(arguments.file, make_error(e_not_one_polyhedron,
                                           "The file has " + std::to_string(count) +
                                               " polyhedra, but exactly one can be evaluated.",
                                           "Save the polyhedron to evaluate in a file of its own."));

  PolyhedronSource source = *found;
  if (arguments.tension) {
    const auto text = read_file(*arguments.tension, tension_file_limit);
    if (!text.ok()) return fail(*arguments.tension, text.error());
    auto shaping = read_tensions(*text, source.polyhedron, *source.shaping);
    if (!shaping.ok()) return fail(*arguments.tension, shaping.error());
    source.shaping = std::move(shaping).value();
  }
  return answer(evaluation_json(source));
}

}  // namespace hariko
