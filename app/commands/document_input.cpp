#include "app/commands/document_input.hpp"

#include <cmath>
#include <variant>

#include "app/commands/console.hpp"
#include "app/files/reading.hpp"
#include "core/document/edits/edit_objects.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "ui/editor/selected_items.hpp"

namespace hariko {

namespace {

constexpr Code w_kept_as_facets{"W_KEPT_AS_FACETS"};

// Sources of kinds that have nothing to be chosen for their construction.
void choose(MeshSource&, const Construction&) {}
void choose(PatchSource&, const Construction&) {}
void choose(BezierSource&, const Construction&) {}
void choose(SkinSource&, const Construction&) {}
void choose(PictureSource&, const Construction&) {}
void choose(UnknownSource&, const Construction&) {}

void choose(PolyhedronSource& source, const Construction& construction) {
  source.mode = construction.mode.value_or(source.mode);
  source.frames = construction.frames.value_or(source.frames);
  bool& merges = source.preparation.merge_coplanar;
  merges = construction.merge_coplanar.value_or(merges);
}

void choose(OutlineSource& source, const Construction& construction) {
  OutlineSettings& settings = source.settings;
  const OutlineConstruction& chosen = construction.outlines;
  if (chosen.method) settings.mode_replaced = chosen.method_replaced;
  settings.mode = chosen.method.value_or(settings.mode);
  settings.sign = chosen.sign.value_or(settings.sign);
  settings.radius = chosen.radius.value_or(settings.radius);
  settings.most_points = chosen.most_points.value_or(settings.most_points);
  if (chosen.gap) settings.gap = chosen.gap;
  if (construction.mode == Mode::fair || construction.mode == Mode::g2)
    settings.curvature_continuous = construction.mode == Mode::g2;
  settings.frames = construction.frames.value_or(settings.frames);
}

void choose(SolidsSource& source, const Construction& construction) {
  const SolidsConstruction& chosen = construction.solids;
  EnvelopeInput input = *source.input;
  EnvelopeSettings& settings = input.settings;
  if (chosen.method == EnvelopeMethod::ball && !(settings.rounding > 0)) choose_ball(input);
  settings.method = chosen.method.value_or(settings.method);
  settings.rounding = chosen.rounding.value_or(settings.rounding);
  if (chosen.ball_radius) settings.ball_radius = chosen.ball_radius;
  if (settings.ball_radius && std::isinf(*settings.ball_radius)) settings.ball_radius.reset();
  settings.on_faces = chosen.on_faces.value_or(settings.on_faces);
  settings.finer_patches = chosen.finer_patches.value_or(settings.finer_patches);
  if (chosen.bridge_radius)
    for (Solid& solid : input.solids)
      if (solid.bridge) solid.bridge->ball_radius = chosen.bridge_radius;
  source.input = std::move(input);
}

}  // namespace

OpenedFile open_as_asked(const std::filesystem::path& file, const Reading& reading) {
  const ProgressLine line(file, "reading");
  OpenedFile opened = open_file(file, {}, line.progress(), join_choice(reading));
  if (opened.document && reading.repair) turn_outwards(opened);
  if (auto warning = inside_out_message(opened)) opened.messages.push_back(*std::move(warning));
  if (opened.document || !opened.broken_mesh) return opened;
  const bool repairs = reading.repair && opened.repaired;
  if (repairs || (reading.reference && opened.reference)) {
    std::erase_if(opened.messages,
                  [](const Message& message) { return message.severity == Severity::error; });
    opened.messages.push_back(
        repairs ? repaired_message(opened.repair)
                : make_warning(w_kept_as_facets,
                               "The mesh makes no polyhedron and was kept as facets, without a surface."));
    opened.document = repairs ? opened.repaired : opened.reference;
    return opened;
  }
  const std::string changes = repair_text(opened.repair), list = changes.empty() ? "" : " (" + changes + ")",
                    repair = opened.repaired ? "--repair mends it" + list : "",
                    reference = opened.reference ? "--reference keeps its facets" : "";
  if (!repair.empty() || !reference.empty())
    opened.messages.push_back(make_warning(
        w_can_be_opened, "The mesh can be opened: " + repair +
                             (repair.empty() || reference.empty() ? "" : ", ") + reference + "."));
  return opened;
}

std::optional<Document> read_document_or_report(const std::filesystem::path& file,
                                                const Construction& construction) {
  OpenedFile opened = open_as_asked(file, construction.reading);
  report(file.string(), opened.messages);
  if (!opened.document) return std::nullopt;
  return with_construction(*std::move(opened.document), construction);
}

Document with_construction(Document document, const Construction& construction) {
  if (construction == Construction()) return document;
  for (auto& object : document.objects) {
    auto changed = std::make_shared<Object>(*object);
    std::visit([&](auto& source) { choose(source, construction); }, changed->source);
    object = std::move(changed);
  }
  return document;
}

Result<Document> with_only(const Document& document, const std::vector<std::string>& only) {
  if (only.empty()) return document;
  const auto objects = objects_named(document, only);
  if (!objects) return objects.error();
  return showing_only(document, *objects);
}

}  // namespace hariko
