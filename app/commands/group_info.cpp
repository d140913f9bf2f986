#include "app/commands/group_info.hpp"

#include <algorithm>

#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/group_tree.hpp"

namespace hariko {

namespace {

std::string group_line(const std::string& label, const std::string& text) {
  std::string padded = label;
  padded.resize(std::max<std::size_t>(padded.size() + 2, 22), ' ');
  return padded + text + "\n";
}

}  // namespace

std::vector<GroupInfo> inspect_groups(const Document& document) {
  std::vector<GroupInfo> out;
  if (document.groups->empty()) return out;
  const GroupTree tree(document);
  std::map<ObjectId, const Object*> objects;
  for (const auto& object : document.objects) objects.emplace(object->id, object.get());
  for (const Group& group : *document.groups) {
    GroupInfo& info = out.emplace_back();
    info.id = group.id.value;
    info.name = group.name;
    if (group.parent != GroupId{}) info.parent = group.parent.value;
    info.visible = is_visible(document, group.id);
    info.locked = is_locked(document, group.id);
    for (const ObjectId id : tree.objects_in(group.id)) info.objects.push_back(objects.at(id)->name);
  }
  return out;
}

std::string groups_text(const std::vector<GroupInfo>& groups) {
  if (groups.empty()) return {};
  std::string out = group_line("groups", std::to_string(groups.size()));
  for (const GroupInfo& info : groups) {
    std::string text = sanitized_utf8(info.name);
    if (info.parent) {
      const auto round = std::ranges::find(groups, *info.parent, &GroupInfo::id);
      text += ", in " + sanitized_utf8(round->name);
    }
    text += info.visible ? "" : ", hidden";
    text += info.locked ? ", locked" : "";
    std::string names;
    for (const std::string& name : info.objects) names += (names.empty() ? "" : ", ") + sanitized_utf8(name);
    out += group_line("group", text + "  (" + names + ")");
  }
  return out;
}

}  // namespace hariko
