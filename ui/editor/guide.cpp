#include "ui/editor/guide.hpp"

#include <algorithm>

#include "ui/base/language.hpp"

namespace hariko {

namespace {

/// Whether `differs(before, now)` holds for the polyhedron of some object that is in both documents.
template <class Differs>
bool any_polyhedron(const Document& before, const Document& now, const Differs& differs) {
  return std::ranges::any_of(now.objects, [&](const auto& object) {
    const Object* old = before.find(object->id);
    return old && old->polyhedron() && object->polyhedron() &&
           differs(*old->polyhedron(), *object->polyhedron());
  });
}

bool moved(const PolyhedronSource& before, const PolyhedronSource& now) {
  if (before.polyhedron.vertex_count() != now.polyhedron.vertex_count()) return false;
  for (Index v = 0; v < now.polyhedron.vertex_count(); ++v)
    if (before.polyhedron.position(v) != now.polyhedron.position(v)) return true;
  return false;
}

bool tensed(const PolyhedronSource& before, const PolyhedronSource& now) {
  return before.shaping->alpha != now.shaping->alpha || before.shaping->beta != now.shaping->beta;
}

bool creased(const PolyhedronSource& before, const PolyhedronSource& now) {
  return now.shaping->crease.size() > before.shaping->crease.size();
}

}  // namespace

bool fulfilled(GuideStep step, const GuideFacts& before, const GuideFacts& now) {
  const auto& objects = now.document.objects;
  switch (step) {
    case GuideStep::box:
      return std::ranges::any_of(objects, [](const auto& object) { return object->polyhedron(); });
    case GuideStep::pull:
      return any_polyhedron(before.document, now.document, &moved);
    case GuideStep::tension:
      return any_polyhedron(before.document, now.document, &tensed);
    case GuideStep::crease:
      return any_polyhedron(before.document, now.document, &creased);
    case GuideStep::zebra:
      return now.zebra;
    case GuideStep::export_file:
      return now.exports > before.exports;
    case GuideStep::done:
      return false;
  }
  return false;
}

void Guide::start(const GuideFacts& now) {
  if (step_ == GuideStep::done) step_ = GuideStep::box;
  shown_ = true;
  before_ = now;
}

bool Guide::look(const GuideFacts& now) {
  if (!shown_ || !fulfilled(step_, before_, now)) {
    // Another document, or objects that came since: changes count from when they were first seen.
    if (shown_)
      for (const auto& object : now.document.objects)
        if (!before_.document.find(object->id)) before_.document.objects.push_back(object);
    return false;
  }
  step_ = static_cast<GuideStep>(static_cast<int>(step_) + 1);
  before_ = now;
  return true;
}

const GuideText& text_of(GuideStep step) {
  static constexpr std::array<GuideText, guide_step_count + 1> texts{{
      {translatable("Start with a box"),
       translatable("Press the button. The box is a cage: a smooth surface is stretched over it."), ""},
      {translatable("Pull a vertex"),
       translatable("Press {0} for vertices, then drag a corner of the cage. The surface follows."),
       "select.vertices"},
      {translatable("Raise its tension"),
       translatable("Drag the slider Tension \u03b1 on the right. The surface comes up to the vertex and "
                    "sharpens there."),
       ""},
      {translatable("Crease an edge"),
       translatable(
           "Press 2, click an edge, then press {0} or tick Crease on the right. The surface folds there."),
       "shape.crease"},
      {translatable("Judge it with zebra stripes"),
       translatable("Press {0}. Stripes that run on without a kink mean a smooth surface; the same key takes "
                    "them away."),
       "analyse.zebra"},
      {translatable("Take it out"),
       translatable("Press {0}, type a name and export. What you have now is a mesh for any other program."),
       "file.export"},
      {translatable("That is all you need"),
       translatable("Press F1 for all keys, or open a sample to see how others are made."), ""},
  }};
  return texts[static_cast<std::size_t>(step)];
}

}  // namespace hariko
