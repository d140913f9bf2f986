#include <iostream>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/pictures/sample_pictures.hpp"
#include "render/offscreen.hpp"
#include "render/renderer.hpp"

namespace hariko {

int run_sample_pictures(const std::filesystem::path& assets, const std::filesystem::path& out) {
  const auto made = make_sample_pictures(assets, out);
  if (made.ok()) return exit_fine;
  if (const Code code = made.error().code; code != e_no_egl && code != e_gl_version) {
    report(out.string(), made.error());
    return exit_failed;
  }
  std::cerr << "No pictures of the samples were drawn, so that the first start will take longer: "
            << made.error().text << " " << made.error().remedy << "\n";
  return exit_fine;
}

}  // namespace hariko
