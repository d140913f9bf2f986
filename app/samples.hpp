#pragma once

// Samples: the documents that come with the program, and their pictures on the start page.

#include <filesystem>
#include <vector>

#include "render/renderer.hpp"
#include "ui/panels/panels.hpp"

namespace hariko {

/// The folder with the program's data: HARIKO_ASSETS, else beside the program, else where it was built from.
std::filesystem::path assets_folder();

/// Documents in the samples folder, in the order of their names; titles come from the names.
std::vector<Sample> find_samples(const std::filesystem::path& assets);

/// What a picture of a sample is drawn from; null members when the sample cannot be read. For a worker.
Scene sample_scene(const std::filesystem::path& path, const CancelToken& cancel);

/// Draws it and uploads it as a texture that lives as long as the GL context.
ImTextureID sample_picture(Renderer& renderer, const Scene& scene);

}  // namespace hariko
