#include "app/recovery_offers.hpp"

#include <algorithm>
#include <utility>

#include "app/files/file_names.hpp"
#include "app/persistence/unix_seconds.hpp"
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
    pictures.request(leftover.copy, [this, id = leftover.id](ImTextureID picture) {
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
  const auto offered =
      std::find_if(offers.begin(), offers.end(), [&](const auto& one) { return one.id == id; });
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

}  // namespace hariko
