#pragma once

// Pictures of the samples, made when the program is built and loaded from its data.

#include <filesystem>
#include <vector>

#include "app/pictures/pictures.hpp"
#include "core/base/result.hpp"
#include "ui/base/samples.hpp"
#include "ui/base/settings.hpp"

namespace hariko {

/// Folder of the samples' pictures in the program's data; it need not exist.
std::filesystem::path sample_pictures_folder(const std::filesystem::path& assets);

/// Draws every sample, without a window, into a folder that is created where needed: one picture for each
/// theme. Returns the number of samples. Writes `complete`, an empty file, at the end. Errors: those of
/// PictureDrawer::create where there is no OpenGL, those of writing files, and E_SAMPLE_PICTURE for a sample
/// that shows nothing.
inline constexpr Code e_sample_picture{"E_SAMPLE_PICTURE"};
Result<std::size_t> make_sample_pictures(const std::filesystem::path& assets,
                                         const std::filesystem::path& out);

/// Assigns pictures to the samples of the interface. For the main thread, with the GL context of `drawn`.
class SamplePictures {
 public:
  /// `drawn`: draws pictures that the build did not make.
  SamplePictures(std::filesystem::path folder, std::vector<Sample>& samples, Pictures& drawn)
      : folder_(std::move(folder)), samples_(samples), drawn_(drawn) {}

  /// Assigns a sample's picture: now where the build made one, else later.
  void give(Sample& sample, ThemeId theme);
  /// Removes all pictures, to be assigned again after a change of the theme.
  void forget();

 private:
  std::filesystem::path folder_;
  std::vector<Sample>& samples_;
  Pictures& drawn_;
  std::vector<unsigned> own_;  ///< textures
};

}  // namespace hariko
