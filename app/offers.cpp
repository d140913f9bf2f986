#include "app/offers.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "app/files/file_names.hpp"
#include "app/persistence/unix_seconds.hpp"
#include "app/start_program.hpp"
#include "core/base/files/file_io.hpp"
#include "ui/base/text_lines.hpp"

namespace hariko {

RecoveryOffers::RecoveryOffers(Editor& editor, Workbench& workbench, const RecoveryStore& store,
                               BackgroundWork& background, Log log)
    : editor_(editor), workbench_(workbench), store_(store), background_(background), log_(std::move(log)) {}

void RecoveryOffers::find(Pictures& pictures) {
  // Reading the copies takes time; their places are reserved now, so that nothing moves under the pointer
  // then.
  workbench_.offers().recovery_places = store_.candidates(unix_seconds());
  background_.run(
      {}, [this](const CancelToken&) { return store_.leftovers(unix_seconds()); },
      [this, &pictures](const std::vector<Leftover>& leftovers) { show(leftovers, pictures); });
}

void RecoveryOffers::show(const std::vector<Leftover>& leftovers, Pictures& pictures) {
  auto& offers = workbench_.offers().recoveries;
  offers.clear();
  workbench_.offers().recoveries_known = true;
  for (const Leftover& leftover : leftovers) {
    RecoveryOffer offer;
    offer.id = leftover.id;
    offer.path = leftover.note.original;
    offer.written_at = leftover.note.written_at;
    offer.objects = leftover.objects;
    offer.file_changed = leftover.file_changed;
    offer.damaged = leftover.damaged;
    offers.push_back(std::move(offer));
    if (leftover.damaged) continue;
    pictures.request(leftover.copy, [this, id = leftover.id](unsigned picture) {
      for (RecoveryOffer& shown : workbench_.offers().recoveries)
        if (shown.id == id) shown.picture = picture;
    });
  }
  if (offers.empty() && !workbench_.offers().crash) return;
  workbench_.offer_recovery();
  log_("offers", {});
}

void RecoveryOffers::remove(const std::string& id) {
  std::erase_if(workbench_.offers().recoveries, [&](const RecoveryOffer& offer) { return offer.id == id; });
}

void RecoveryOffers::discard(const std::string& id) {
  const Language& tr = editor_.language;
  const auto& offers = workbench_.offers().recoveries;
  const auto offered = std::ranges::find_if(offers, [&](const auto& one) { return one.id == id; });
  if (offered == offers.end()) return;
  const std::string name = offered->path.empty() ? tr("Untitled") : name_of(offered->path);
  workbench_.ask(
      {tr("Discard unsaved work"),
       fill(tr("The unsaved work on {0} of {1} will be deleted. This cannot be undone."),
            {name, local_time_text(offered->written_at)}),
       {{tr("Discard"), "discard_recovery", [this, id] { remove_copy(id); }}, {tr("Cancel"), "cancel", {}}}});
}

void RecoveryOffers::remove_copy(const std::string& id) {
  background_.run(
      {},
      [this, id](const CancelToken&) -> Result<Done> {
        auto slot = store_.adopt(id, unix_seconds());
        if (!slot.ok()) return slot.error();
        SystemFileLayer layer;
        return RecoverySlot(std::move(slot).value()).clear(layer);
      },
      [this, id](const Result<Done>& discarded) {
        if (!discarded.ok()) editor_.notify(discarded.error());
        remove(id);
        log_("discarded", {});
      });
}

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
    pictures_->request(entry.path, [this, path = entry.path](unsigned picture) {
      for (RecentFile& shown : workbench_.offers().recent)
        if (shown.path == path) shown.picture = picture;
    });
  }
}

namespace {

constexpr std::size_t log_bytes = 16 * 1024;  // length of the log's end that accompanies a report

}  // namespace

CrashOffers::CrashOffers(Editor& editor, Workbench& workbench, std::filesystem::path folder,
                         const RunLog& log)
    : CrashOffers(editor, workbench, std::move(folder), log, [](const std::filesystem::path& path) {
        return start_program({"xdg-open", path.string()});
      }) {}

CrashOffers::CrashOffers(Editor& editor, Workbench& workbench, std::filesystem::path folder,
                         const RunLog& log, ShowFolder show)
    : editor_(editor),
      workbench_(workbench),
      folder_(std::move(folder)),
      log_(log),
      reports_(folder_),
      show_(std::move(show)) {}

void CrashOffers::find() {
  const auto found = reports_.latest();
  workbench_.offers().crash.reset();
  if (!found) return;
  const std::string log = log_.tail(log_bytes);
  workbench_.offers().crash =
      CrashOffer{found->written_at, log.empty() ? found->text : found->text + "\nlog.txt:\n" + log};
}

void CrashOffers::dismiss() {
  reports_.dismiss();
  workbench_.offers().crash.reset();
}

void CrashOffers::show_folder() {
  std::error_code unknown;  // an unknown folder cannot be shown either
  std::filesystem::create_directories(folder_, unknown);
  if (show_(folder_)) return;
  editor_.inform({"The log lies in {0}.", {folder_.string()}});
}

}  // namespace hariko
