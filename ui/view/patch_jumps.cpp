#include "ui/view/patch_jumps.hpp"

namespace hariko {

std::uint64_t patch_connection(const Surface& surface) {
  // FNV-1a over numbers.
  std::uint64_t sum = 0xcbf29ce484222325U;
  const auto add = [&](std::uint64_t value) { sum = (sum ^ value) * 0x100000001b3U; };
  add(surface.patch_count());
  for (const Seam& seam : surface.seams())
    for (const PatchSide& side : {seam.first, seam.second}) {
      add(side.patch);
      add(static_cast<std::uint64_t>(side.side));
    }
  return sum;
}

void PatchJumps::update(const Editor& editor) {
  if (documents_ != editor.documents) known_.clear();
  documents_ = editor.documents;
  bool jumped = false;
  for (const auto& object : editor.document().objects) {
    const SurfaceView* view = object->solids() ? editor.view_of(object->id) : nullptr;
    if (!view || !view->mesh) {
      known_.erase(object->id);
      continue;
    }
    Known& known = known_[object->id];
    if (known.mesh == view->mesh) continue;
    const Known next{view->mesh, patch_connection(view->surface), view->quality};
    const bool dragged = next.quality == Quality::drag || known.quality == Quality::drag;
    jumped = jumped || (known.mesh && dragged && next.patches != known.patches);
    known = next;
  }
  if (jumped) ++count_;
}

}  // namespace hariko
