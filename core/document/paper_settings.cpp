#include "core/document/paper_settings.hpp"

#include <cmath>

namespace hariko {

Result<Done> check_settings(const PaperSettings& settings, double longest_edge) {
  const auto refuse = [](const char* text, const char* remedy) {
    return make_error(e_paper_setting, text, remedy);
  };
  const auto length = [](double value) { return std::isfinite(value) && value >= 0 && value <= 10'000; };
  if (!length(settings.page.width) || !length(settings.page.height) || !length(settings.margin) ||
      !length(settings.gap) || !length(settings.tab_height) || !length(settings.least_tab) ||
      !length(settings.strip_width))
    return refuse("A length of the page set-up is negative, or longer than 10 m.", "Enter lengths in mm.");
  if (!(settings.strip_width > 0))
    return refuse("Joint strips need a width.", "Enter a width in mm, such as 8.");
  const PaperSize room = settings.piece_room();
  if (!(room.width >= 5) || !(room.height >= 5))
    return refuse("Margins and tabs leave no room on the page.", "Choose a larger page or a smaller margin.");
  if (!std::isfinite(settings.flat_fold) || settings.flat_fold < 0)
    return refuse("The angle below which folds are flat must not be negative.", "Enter an angle in degrees.");
  const double longest = settings.scale * longest_edge;
  if (!(longest >= 1e-6) || !(longest <= 1e6))
    return refuse("The model would be smaller than a hair or larger than a hall on paper.",
                  "Choose the height, width or depth of the model in mm.");
  return Done{};
}

}  // namespace hariko
