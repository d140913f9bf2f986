#pragma once

// Pictures of the samples: made with the program, by its build, and shown from there.

#include <filesystem>
#include <map>
#include <vector>

#include "app/pictures/pictures.hpp"
#include "core/base/result.hpp"
#include "ui/base/samples.hpp"
#include "ui/base/settings.hpp"

namespace hariko {

/// The folder with the pictures among the program's data, which need not be there.
std::filesystem::path sample_pictures_folder(const std::filesystem::path& assets);

/// Draws every sample, without a window, into a folder that is made where needed: a picture for each theme.
/// Gives the number of samples. `complete`, an empty file, is written at the end. Errors: those of
/// PictureDrawer::create where there is no OpenGL, of files that cannot be written, and E_SAMPLE_PICTURE for
/// a sample that shows nothing.
inline constexpr Code e_sample_picture{"E_SAMPLE_PICTURE"};
Result<std::size_t> make_sample_pictures(const std::filesystem::path& assets,
                                         const std::filesystem::path& out);

/// Gives the samples of the interface their pictures. For the main thread, with the GL context of `drawn`.
class SamplePictures {
 public:
  /// `drawn`: makes those that the build did not.
  SamplePictures(std::filesystem::path folder, std::vector<Sample>& samples, Pictures& drawn)
      : folder_(std::move(folder)), samples_(samples), drawn_(drawn) {}

  /// At once where the build made one, else later.
  void give(Sample& sample, ThemeId theme);
  /// Takes all pictures away, to be asked for anew: after a change of the theme.
  void forget();

 private:
  std::filesystem::path folder_;
  std::vector<Sample>& samples_;
  Pictures& drawn_;
  std::vector<ImTextureID> own_;
};

}  // namespace hariko
