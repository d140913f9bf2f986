#include "core/document/edits/edit_solids.hpp"

#include <algorithm>
#include <map>

#include "core/document/edits/edit_support.hpp"

namespace hariko {

DisplaySettings solids_display() {
  DisplaySettings display;
  display.network = false;
  return display;
}

Result<Document> change_envelope(const Document& document, ObjectId object,
                                 const std::function<void(EnvelopeInput&)>& change) {
  return detail::change_object(document, object, true, [&](Object& changed) -> Result<Done> {
    auto* source = std::get_if<SolidsSource>(&changed.source);
    if (!source)
      return make_error(e_not_solids, "\"" + changed.name + "\" is not made of solids.",
                        "Choose an object with solids.", element_of(object));
    EnvelopeInput input = *source->input;
    change(input);
    if (const auto checked = check_envelope(input); !checked) return checked.error();
    if (!(input == *source->input)) source->input = std::move(input);
    return Done{};
  });
}

Result<Document> change_solids(const Document& document, ObjectId object, std::span<const std::uint32_t> ids,
                               const std::function<void(Solid&)>& change) {
  return change_envelope(document, object, [&](EnvelopeInput& input) {
    for (Solid& solid : input.solids)
      if (std::find(ids.begin(), ids.end(), solid.id) != ids.end()) change(solid);
  });
}

std::uint32_t next_solid_id(const EnvelopeInput& input) {
  std::uint32_t next = 0;
  for (const Solid& solid : input.solids) next = std::max(next, solid.id + 1);
  return next;
}

Result<Document> add_solid(const Document& document, ObjectId object, Solid solid) {
  return change_envelope(document, object, [&](EnvelopeInput& input) {
    solid.id = next_solid_id(input);
    input.solids.push_back(std::move(solid));
  });
}

Result<Document> array_solids(const Document& document, ObjectId object, std::span<const std::uint32_t> ids,
                              int copies, const Vector3& step, std::vector<std::uint32_t>& added) {
  added.clear();
  return change_envelope(document, object, [&](EnvelopeInput& input) {
    const std::vector<Solid> before = input.solids;
    for (int copy = 1; copy <= copies && input.solids.size() <= max_solids; ++copy) {
      std::map<std::uint32_t, std::uint32_t> copies_of;
      const std::size_t first = input.solids.size();
      for (Solid solid : before) {
        if (std::find(ids.begin(), ids.end(), solid.id) == ids.end()) continue;
        solid.id = copies_of[solid.id] = next_solid_id(input);
        solid.position += copy * step;
        added.push_back(solid.id);
        input.solids.push_back(std::move(solid));
      }
      for (std::size_t i = first; i < input.solids.size(); ++i)
        if (auto& bridge = input.solids[i].bridge)
          for (std::uint32_t& end : bridge->between)
            if (const auto found = copies_of.find(end); found != copies_of.end()) end = found->second;
    }
  });
}

Result<Document> remove_solids(const Document& document, ObjectId object,
                               std::span<const std::uint32_t> ids) {
  const auto gone = [&](std::uint32_t id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
  if (const Object* found = document.find(object); found && found->solids()) {
    const auto& solids = found->solids()->input->solids;
    if (std::all_of(solids.begin(), solids.end(), [&](const Solid& solid) { return gone(solid.id); }))
      return make_error(e_last_solid, "An object needs at least one solid.", "Delete the object instead.",
                        element_of(object));
  }
  return change_envelope(document, object, [&](EnvelopeInput& input) {
    std::erase_if(input.solids, [&](const Solid& solid) { return gone(solid.id); });
  });
}

const Solid* find_solid(const Object& object, std::uint32_t id) {
  if (!object.solids()) return nullptr;
  const auto& solids = object.solids()->input->solids;
  const auto found =
      std::find_if(solids.begin(), solids.end(), [&](const Solid& solid) { return solid.id == id; });
  return found == solids.end() ? nullptr : &*found;
}

}  // namespace hariko
