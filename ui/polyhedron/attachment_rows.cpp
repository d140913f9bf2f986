#include "ui/polyhedron/attachment_rows.hpp"

#include "core/document/edits/edits.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

/// The value that all attached edges share.
template <class Value>
std::optional<Value> common_value(const Attachments& attachments, const std::vector<EdgeId>& ids,
                                  Value Attachment::*member) {
  return common<Value>(ids, [&](const EdgeId& id) { return attachments.find(id)->*member; });
}

}  // namespace

void attachment_rows(PanelContext& context, const SelectedIds<EdgeId>& selected) {
  const Attachments& attachments = *selected.object->polyhedron()->attachments;
  std::vector<EdgeId> ids;
  bool frozen = false;
  for (const EdgeId& id : selected.ids)
    if (const Attachment* attachment = attachments.find(id)) {
      ids.push_back(id);
      frozen = frozen || attachment->frozen.has_value();
    }
  if (ids.empty()) return;
  const auto change = [&](const std::string& step, const auto& edit) {
    Result<Document> result = context.editor.history.current();
    for (const EdgeId& id : ids) {
      Attachment changed = *attachments.find(id);
      edit(changed);
      if (result) result = attach_edge(*result, selected.object->id, id, changed);
    }
    context.editor.commit(result, step);
  };
  const auto continuity = common_value(attachments, ids, &Attachment::continuity);
  if (const auto chosen =
          choose(context, "join", "Joint", "How the edge meets the side of the patch that it is attached to",
                 continuity))
    change("Joint", [&](Attachment& attachment) { attachment.continuity = *chosen; });
  if (frozen) {
    hint_text(context, "The patch is gone; the edge keeps a copy of its side.");
  } else if (continuity == Continuity::g1) {
    const auto adapts = common_value(attachments, ids, &Attachment::adapts);
    if (const auto chosen = choose(context, "adapts", "Adapts", "Who gives way where the two meet", adapts))
      change("Adapts", [&](Attachment& attachment) { attachment.adapts = *chosen; });
  }
  if (ImGui::Button((std::string(context.tr("Release attached edges")) + "###release_edges").c_str(),
                    {-1, 0}))
    context.run("shape.release_edges");
  context.marks.item("button.release_edges");
}

}  // namespace hariko
