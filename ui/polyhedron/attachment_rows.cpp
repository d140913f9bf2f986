#include "ui/polyhedron/attachment_rows.hpp"

#include <array>

#include "core/document/edits/edits.hpp"
#include "ui/widgets/choice.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

constexpr std::array continuity_choices{
    Choice{"Position", "The edge lies on the side's curve"},
    Choice{"Tangent", "The tangent planes agree too, all along"},
};
constexpr std::array adapts_choices{
    Choice{"Surface", "This surface takes the patch's tangent planes"},
    Choice{"Patch", "The patch's second row of points takes this surface's tangent planes"},
};

/// The value that all attached edges share.
template <class Value, class Get>
int common_choice(const Attachments& attachments, const std::vector<EdgeId>& ids, const Get& get) {
  int value = -1;
  for (const EdgeId& id : ids) {
    const int own = static_cast<int>(get(*attachments.find(id)));
    if (value >= 0 && own != value) return -1;
    value = own;
  }
  return value;
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
  const int continuity = common_choice<Continuity>(
      attachments, ids, [](const Attachment& attachment) { return attachment.continuity; });
  if (const auto chosen =
          choose(context, "join", "Joint", "How the edge meets the side of the patch that it is attached to",
                 continuity_choices, continuity))
    change("Joint",
           [&](Attachment& attachment) { attachment.continuity = static_cast<Continuity>(*chosen); });
  if (frozen) {
    hint_text(context, "The patch is gone; the edge keeps a copy of its side.");
  } else if (continuity == static_cast<int>(Continuity::g1)) {
    const int adapts = common_choice<Adapts>(attachments, ids,
                                             [](const Attachment& attachment) { return attachment.adapts; });
    if (const auto chosen =
            choose(context, "adapts", "Adapts", "Who gives way where the two meet", adapts_choices, adapts))
      change("Adapts", [&](Attachment& attachment) { attachment.adapts = static_cast<Adapts>(*chosen); });
  }
  if (ImGui::Button((std::string(context.tr("Release attached edges")) + "###release_edges").c_str(),
                    {-1, 0}))
    context.run("shape.release_edges");
  context.marks.item("button.release_edges");
}

}  // namespace hariko
