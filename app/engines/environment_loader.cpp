#include "app/engines/environment_loader.hpp"

#include <memory>
#include <utility>

#include "core/base/files/file_io.hpp"

namespace hariko {

namespace {

/// Levels for the GPU, and why they are those of the studio instead of a file.
struct LoadedEnvironment {
  EnvironmentLevels levels;
  std::optional<Message> error;
};

Result<RadianceImage> environment_of_file(const std::string& path) {
  const Result<std::string> bytes = read_file(path, largest_environment_file);
  if (!bytes) return bytes.error();
  return read_environment(*bytes);
}

LoadedEnvironment load_environment(EnvironmentKind kind, const std::string& file) {
  if (kind != EnvironmentKind::file) return {environment_levels(environment_picture(kind)), {}};
  auto read = environment_of_file(file);
  if (read) return {environment_levels(std::move(read).value()), {}};
  return {environment_levels(environment_picture(EnvironmentKind::studio)), read.error()};
}

}  // namespace

EnvironmentLoader::EnvironmentLoader(Editor& editor, std::function<void()> wake)
    : editor_(editor), lane_(std::move(wake)) {}

EnvironmentLoader::Request EnvironmentLoader::wanted() const {
  const EnvironmentSettings& settings = editor_.settings.environment;
  const bool own = settings.kind == EnvironmentKind::file;
  return {settings.kind, own ? settings.file : std::string()};
}

void EnvironmentLoader::sync() {
  if (!editor_.view.environment) return;
  const Request now = wanted();
  if (requested_ == now && (editor_.environment || !lane_.idle())) return;
  requested_ = now;
  constexpr WorkLane::Key key = 1;
  lane_.submit(
      key,
      [this, now](const CancelToken&) -> WorkLane::Publication {
        auto loaded = std::make_shared<LoadedEnvironment>(load_environment(now.kind, now.file));
        return [this, loaded] {
          editor_.environment = std::make_shared<const EnvironmentLevels>(std::move(loaded->levels));
          if (!loaded->error) return;
          editor_.notify(Notice::Kind::warning, editor_.language.text_of(*loaded->error),
                         editor_.language("The studio is shown instead. Choose another picture in View > "
                                          "Environment."));
        };
      },
      WorkLane::Running::cancel);
}

}  // namespace hariko
