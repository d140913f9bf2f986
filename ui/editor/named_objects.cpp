#include "ui/editor/named_objects.hpp"

#include "core/base/text/nearest_word.hpp"
#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {

Result<std::vector<ObjectId>> objects_named(const Document& document, std::span<const std::string> names) {
  std::vector<ObjectId> out;
  std::vector<std::string> known;
  for (const auto& object : document.objects) known.push_back(object->name);
  for (const std::string& name : names) {
    const std::size_t before = out.size();
    for (const auto& object : document.objects)
      if (object->name == name) out.push_back(object->id);
    if (out.size() > before) continue;
    constexpr std::size_t shown_bytes = 120;
    const auto near = nearest_word(name, known);
    return make_error(e_no_object_named,
                      "There is no object called \"" + shortened(name, shown_bytes) + "\"." +
                          (near ? " Did you mean \"" + *near + "\"?" : std::string()),
                      "`hariko info` lists the names.");
  }
  return out;
}

}  // namespace hariko
