#include "ui/editor/selection_memory.hpp"

#include <iterator>

namespace hariko {

namespace {

std::size_t size_of(const ChosenElements& chosen) {
  std::size_t size = 1 + chosen.selection.objects().size();
  for (const auto& entry : chosen.selection.elements()) size += entry.second.size();
  return size;
}

}  // namespace

void SelectionMemory::step(std::uint64_t left, ChosenElements chosen, std::uint64_t oldest) {
  kept_.erase(kept_.lower_bound(left), kept_.end());
  kept_.erase(kept_.begin(), kept_.lower_bound(oldest));
  if (left >= oldest) keep(left, std::move(chosen));
}

void SelectionMemory::leave(std::uint64_t state, ChosenElements chosen) {
  if (!kept_.contains(state)) keep(state, std::move(chosen));
}

const ChosenElements* SelectionMemory::find(std::uint64_t state) const {
  const auto it = kept_.find(state);
  return it == kept_.end() ? nullptr : it->second.get();
}

void SelectionMemory::keep(std::uint64_t state, ChosenElements chosen) {
  const auto next = kept_.lower_bound(state);
  const bool same = next != kept_.begin() && *std::prev(next)->second == chosen;
  kept_[state] = same ? std::prev(next)->second : std::make_shared<const ChosenElements>(std::move(chosen));
  std::size_t total = 0;
  const ChosenElements* last = nullptr;
  for (auto it = kept_.rbegin(); it != kept_.rend(); ++it) {
    if (it->second.get() != last) total += size_of(*it->second);
    last = it->second.get();
    if (total <= limit_) continue;
    kept_.erase(kept_.begin(), it.base());
    return;
  }
}

}  // namespace hariko
