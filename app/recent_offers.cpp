#include "app/recent_offers.hpp"

#include <utility>

#include "app/persistence/unix_seconds.hpp"

namespace hariko {

RecentOffers::RecentOffers(Workbench& workbench, BackgroundWork& background, std::filesystem::path list)
    : workbench_(workbench), background_(background), recent_(std::move(list)) {}

void RecentOffers::find(Pictures& pictures) {
  pictures_ = &pictures;
  background_.run(
      {}, [this](const CancelToken&) { return recent_.load(); },
      [this](const std::vector<RecentEntry>& entries) { show(entries); });
}

void RecentOffers::used(const std::filesystem::path& path) {
  background_.run(
      {},
      [this, path](const CancelToken&) {
        (void)recent_.touch(path, unix_seconds());  // a convenience: nothing is lost without it
        return recent_.load();
      },
      [this](const std::vector<RecentEntry>& entries) {
        if (pictures_) show(entries);
      });
}

void RecentOffers::show(const std::vector<RecentEntry>& entries) {
  auto& recent = workbench_.offers().recent;
  const std::vector<RecentFile> before = std::exchange(recent, {});
  for (const RecentEntry& entry : entries) {
    RecentFile file;
    file.path = entry.path;
    file.used_at = entry.used_at;
    for (const RecentFile& old : before)
      if (old.path == file.path) file.picture = old.picture;
    recent.push_back(std::move(file));
    pictures_->request(entry.path, [this, path = entry.path](ImTextureID picture) {
      for (RecentFile& shown : workbench_.offers().recent)
        if (shown.path == path) shown.picture = picture;
    });
  }
}

}  // namespace hariko
