#include "app/jobs/conversion_jobs.hpp"

#include <utility>

#include "core/document/edits/edits.hpp"
#include "core/modeling/surfacing/convert_object.hpp"
#include "core/modeling/surfacing/skin_polyhedron.hpp"
#include "render/color_map.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

ConversionJobs::Work ConversionJobs::work_on(const std::shared_ptr<const Object>& object) const {
  const double scale = object->transform.scale;
  const auto length = [scale](double value) { return format_number(value * scale, 3); };
  if (object->skin())
    return [object, length](const CancelToken& cancel, const Progress& progress) -> Result<Made> {
      auto made = skin_polyhedron(*object->skin()->skin, cancel, progress);
      if (!made) return made.error();
      return Made{std::move(made->source),
                  fill(translatable("The surface of the polyhedron is at most {0} from the skin."),
                       {length(made->distance)}),
                  std::move(made->warnings)};
    };
  if (!object->solids()) return {};
  return [object, length](const CancelToken& cancel, const Progress& progress) -> Result<Made> {
    auto made = solids_polyhedron(*object->solids(), cancel, progress);
    if (!made) return made.error();
    const std::string note =
        made->outside > 0
            ? fill(translatable(
                       "The surface of the polyhedron is at most {0} from that round the solids, which stick "
                       "out of it by up to {1}."),
                   {length(made->distance), length(made->outside)})
            : fill(translatable(
                       "The surface of the polyhedron is at most {0} from that round the solids; none of "
                       "them sticks out of it."),
                   {length(made->distance)});
    return Made{std::move(made->source), note, {}};
  };
}

void ConversionJobs::convert(ObjectId id) {
  const auto object = editor_.history.current().find_shared(id);
  const Work work = object ? work_on(object) : Work();
  if (!work) return;
  if (converting_) converting_->cancel.cancel();
  work_.run_cancellable(
      Phrase(translatable("Converting {0}"), {object->name}), work,
      [this, object, number = ++conversions_, documents = editor_.documents](const Result<Made>& made) {
        if (number == conversions_ && documents == editor_.documents) take(*object, made);
      });
  converting_ = editor_.jobs.back();
}

void ConversionJobs::take(const Object& object, const Result<Made>& made) {
  if (!made.ok()) {
    if (made.error().code != e_cancelled) editor_.notify(made.error());
    return;
  }
  const Object* now = editor_.history.current().find(object.id);
  if (!now) return;
  if (!(now->source == object.source))
    return editor_.warn("The object was changed while it was converted. Convert it again.");
  if (editor_.history.in_gesture()) editor_.cancel_preview();
  DisplaySettings display = now->display;
  display.polyhedron = true;
  display.points = false;  // a hundred and more, close to each other
  const Document& document = editor_.history.current();
  auto added =
      add_object(document, free_name(document, now->name), Source(made->source), now->transform, display);
  if (!added) return editor_.notify(added.error());
  const auto placed = set_copies(added->document, added->id, *now->copies);
  if (!placed) return editor_.notify(placed.error());
  if (!editor_.commit(set_visible(*placed, object.id, false), translatable("Convert to polyhedron"))) return;
  editor_.selection.clear_objects();
  editor_.selection.active = added->id;
  for (const Message& warning : made->warnings) editor_.notify(warning);
  editor_.inform(made->note);
  log_("converted", {});
}

}  // namespace hariko
