#include "ui/analysis/environment_rows.hpp"

#include <cmath>
#include <filesystem>
#include <string>

#include "core/base/text/sanitized_utf8.hpp"
#include "ui/widgets/command_services.hpp"
#include "ui/widgets/enum_labels.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

/// A button with the name of the file, which asks for another one.
void environment_file_row(PanelContext& context, const EnvironmentSettings& environment) {
  const std::string name = sanitized_utf8(std::filesystem::path(environment.file).filename().string());
  context.editor.show_text(name);
  row_label(context, context.tr("File"), "");
  if (ImGui::Button((name + "###environment_file").c_str(), {-1, 0})) context.services.choose_environment();
  if (ImGui::IsItemHovered()) show_tip(sanitized_utf8(environment.file).c_str());
  context.marks.item("button.environment_file");
}

/// A slider of the settings of the environment.
void environment_slider(PanelContext& context, const std::string& id, double& value, double low, double high,
                        const char* format) {
  number_slider(("##" + id).c_str(), {low, high, format}, value);
  if (!std::isfinite(value)) value = 0;
  context.marks.item("slider." + id);
}

}  // namespace

void environment_rows(PanelContext& context) {
  Editor& editor = context.editor;
  EnvironmentSettings& environment = editor.settings.environment;
  if (const auto chosen = choose(context, "environment", "Environment", "What shaded surfaces reflect",
                                 std::optional(environment.kind))) {
    if (*chosen == EnvironmentKind::file && environment.file.empty())
      context.services.choose_environment();
    else
      editor.show_environment(*chosen);
  }
  if (environment.kind == EnvironmentKind::file) environment_file_row(context, environment);
  row_label(context, context.tr("Turn"),
            context.tr("Turns the environment about z: drag, and highlights run over the surface"));
  environment_slider(context, "environment_turn", environment.turn, 0, 360, "%.0f\u00b0");
  row_label(context, context.tr("Exposure"), context.tr("Stops: each doubles the light of the environment"));
  environment_slider(context, "environment_exposure", environment.exposure, -Environment::most_exposure,
                     Environment::most_exposure, "%+.1f");
}

}  // namespace hariko
