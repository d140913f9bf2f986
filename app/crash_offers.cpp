#include "app/crash_offers.hpp"

#include <system_error>
#include <utility>

#include "app/start_program.hpp"

namespace hariko {

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
  editor_.notify(Notice::Kind::info, fill(editor_.language("The log lies in {0}."), {folder_.string()}));
}

}  // namespace hariko
