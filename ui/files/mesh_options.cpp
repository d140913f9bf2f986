#include "ui/files/mesh_options.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

void draw_mesh_options(Editor& editor, Marks& marks, const Metrics& metrics) {
  const Language& tr = editor.language;
  MeshImport& choice = editor.mesh_import;
  option_label(tr, metrics, "Meshes");
  const std::array<std::string, 3> uses{tr("Cage, asked about above 5,000 faces"), tr("Cage"),
                                        tr("Reference facets")};
  if (const auto chosen =
          option_list(marks, "import.use", std::min(metrics.px(300), ImGui::GetContentRegionAvail().x), uses,
                      static_cast<std::size_t>(choice.use), {},
                      tr("A cage gets a surface. Reference facets are to be traced and measured.")))
    choice.use = static_cast<MeshUse>(*chosen);
  option_label(tr, metrics, "");
  ImGui::Checkbox((std::string(tr("Crease edges above")) + "###creases").c_str(), &choice.creases);
  marks.item("import.creases");
  if (ImGui::IsItemHovered())
    show_tip(tr("Edges where faces meet at more than this angle become sharp edges of the surface."));
  ImGui::SameLine();
  ImGui::SetNextItemWidth(metrics.px(70));
  double degrees = choice.crease_degrees;
  if (ImGui::InputDouble("##crease_angle", &degrees, 0, 0, "%.4g\u00b0") && std::isfinite(degrees))
    choice.crease_degrees = std::clamp(degrees, 0.0, 180.0);
  if (ImGui::IsItemDeactivatedAfterEdit()) choice.creases = true;
  marks.item("import.crease_angle");
}

}  // namespace hariko
