#include "ui/editor/dimension_view.hpp"

#include <algorithm>

#include "core/document/edits/edit_dimensions.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

SurfaceOf ready_surfaces(const Editor& editor) {
  return [&editor](ObjectId id) -> const Surface* {
    const SurfaceView* view = editor.view_of(id);
    return view && view->mesh && view->surface.patch_count() > 0 ? &view->surface : nullptr;
  };
}

void DimensionView::take_up(const Shared<Dimensions>& dimensions) {
  dimensions_ = dimensions;
  all_.clear();
  named_.clear();
  for (const Dimension& dimension : *dimensions) {
    all_.push_back({dimension, {}, true});
    for (const Anchor& anchor : dimension.anchors)
      if (const ObjectId* id = object_of(anchor)) named_.push_back(*id);
  }
  std::sort(named_.begin(), named_.end());
  named_.erase(std::unique(named_.begin(), named_.end()), named_.end());
}

void DimensionView::update(const Editor& editor) {
  const Document& document = editor.document();
  const bool others = dimensions_.get() != document.dimensions.get();
  if (others) take_up(document.dimensions);
  if (all_.empty()) return known_.clear();
  std::vector<Known> now(named_.size());
  const auto place = [&](ObjectId id) {
    return static_cast<std::size_t>(std::lower_bound(named_.begin(), named_.end(), id) - named_.begin());
  };
  for (const auto& object : document.objects) {
    const std::size_t at = place(object->id);
    if (at == named_.size() || named_[at] != object->id) continue;
    const SurfaceView* view = editor.view_of(object->id);
    now[at] = {object, view ? view->mesh : nullptr};
  }
  const bool fits = !others && known_.size() == now.size();
  const SurfaceOf surfaces = ready_surfaces(editor);
  for (ShownDimension& shown : all_) {
    bool changed = !fits;
    shown.visible = true;
    for (const Anchor& anchor : shown.dimension.anchors)
      if (const ObjectId* id = object_of(anchor)) {
        const std::size_t at = place(*id);
        changed = changed || !(now[at] == known_[at]);
        shown.visible = shown.visible && now[at].object && now[at].object->visible;
      }
    if (changed) shown.measured = measured(document, shown.dimension, surfaces);
  }
  known_ = std::move(now);
}

void DimensionView::choose(const Editor& editor, DimensionId id) {
  chosen_ = Chosen{id, editor.selection, editor.mode};
}

std::optional<DimensionId> DimensionView::chosen(const Editor& editor) const {
  if (!chosen_ || !(chosen_->selection == editor.selection) || chosen_->mode != editor.mode) return {};
  return find_dimension(editor.document(), chosen_->id) ? std::optional(chosen_->id) : std::nullopt;
}

}  // namespace hariko
