#include "ui/editor/paper_state.hpp"

#include <algorithm>

#include "core/unfolding/cut_large_faces.hpp"
#include "core/unfolding/edit_unfolding.hpp"

namespace hariko {

std::shared_ptr<const PaperLayout> lay_out_paper(std::shared_ptr<const PaperModel> model,
                                                 std::shared_ptr<const PaperMesh> mesh, Unfolding unfolding) {
  auto out = std::make_shared<PaperLayout>();
  out->model = std::move(model);
  out->mesh = std::move(mesh);
  out->unfolding = std::move(unfolding);
  const Unfolding& u = out->unfolding;
  out->drawing = draw_sheets(u);
  const auto facets = static_cast<Index>(u.corners.size());
  out->overlapping.assign(facets, 0);
  const auto pairs = overlaps_of(u);
  out->overlaps = pairs.size();
  for (const auto& [a, b] : pairs)
    for (const Index thing : {a, b}) {
      if (thing < facets)
        out->overlapping[thing] = 1;
      else if (const auto& tab = u.joints[thing - facets].tab)
        out->overlapping[tab->facet] = 1;
    }
  out->off_page = pieces_off_page(u);
  out->fitting = fitting_factor(u);
  out->messages = unfolding_messages(u);
  if (out->mesh->cut > 0) {
    out->messages.push_back(cut_faces_message(out->mesh->cut));
    out->fitting =
        std::min(out->fitting, largest_uncut_scale(out->mesh->whole->mesh, u.settings) / u.settings.scale);
  }
  return out;
}

Index PaperState::selected_piece() const {
  const PaperLayout* layout_now = visible();
  if (!layout_now || selected >= layout_now->unfolding.piece_of.size()) return no_index;
  return layout_now->unfolding.piece_of[selected];
}

void PaperState::remember(std::shared_ptr<const PaperLayout> made) {
  remembered_.push_back(std::move(made));
  if (remembered_.size() > most_remembered) remembered_.pop_front();
}

std::shared_ptr<const PaperLayout> PaperState::find(const PaperModel& model, const PaperMesh* on) const {
  const auto found = std::find_if(remembered_.rbegin(), remembered_.rend(), [&](const auto& each) {
    return each->mesh.get() == on && (each->model.get() == &model || *each->model == model);
  });
  return found == remembered_.rend() ? nullptr : *found;
}

void PaperState::forget() {
  remembered_.clear();
  mesh.reset();
  layout.reset();
  dragged.reset();
  fault.reset();
  hovered = {};
  selected = no_index;
  folded = 1;
  pending = wants_unfolding = false;
  wants_framing = true;
}

}  // namespace hariko
