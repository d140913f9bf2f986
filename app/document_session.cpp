#include "app/document_session.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "app/files/file_names.hpp"
#include "app/jobs/mesh_questions.hpp"
#include "app/persistence/unix_seconds.hpp"
#include "core/base/files/temporary_files.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/file.hpp"

namespace hariko {

namespace fs = std::filesystem;
using Outcome = FileLock::Attempt::Outcome;

namespace {

/// Owner of a lock, "ada on studio-3", as far as the lock tells.
std::string owner_text(const Language& tr, const std::optional<LockOwner>& owner) {
  if (!owner || owner->user.empty()) return tr("another program");
  return fill(tr("{0} on {1}"), {owner->user, owner->host});
}

Message in_use(const fs::path& path) {
  return make_error(e_document_locked, name_of(path) + " is open in another window and was not overwritten.",
                    "Close it there, or save under another name.");
}

/// Note about surfaces that are made by equal angles; null where there are none.
const char* note_about_frames(const Document& document) {
  bool rounder = false, any = false;
  for (const auto& object : document.objects) {
    if (surface_frames(object->source) != Frames::equal) continue;
    const auto mode = stored_mode(object->source);
    rounder = rounder || mode == Mode::g2;
    any = any || !mode || mode == Mode::fair;
  }
  if (rounder)
    return translatable(
        "Surfaces G2 of this document are rounder than they were before. Shape > Surfaces by measure makes "
        "them even over uneven cages.");
  if (any)
    return translatable(
        "Surfaces of this document are made by equal angles, as they were. Shape > Surfaces by measure makes "
        "them even over uneven cages.");
  return nullptr;
}

}  // namespace

struct DocumentSession::Opened {
  fs::path path;
  Work replaces;
  OpenedFile file;
  std::optional<FileStamp> stamp;
  FileLock::Attempt attempt;
  bool own_lock = false;  ///< this session has locked the file already
  bool sample = false;    ///< a sample of the program
  std::string note;       ///< shown once it is open, in the language of the interface; may be empty
};

struct DocumentSession::Recovered {
  Work replaces;
  Result<RecoveryCopy> copy = make_error(e_no_recovery, {});
  std::optional<RecoverySlot> slot;
  FileLock::Attempt attempt;
};

struct DocumentSession::Saved {
  fs::path path;
  Document document;
  std::uint64_t document_number = 0, serial = 0;
  Result<Done> result = Done{};
  std::optional<FileStamp> stamp;
  FileLock::Attempt attempt;
  bool changed_on_disk = false;
};

DocumentSession::DocumentSession(Editor& editor, Workbench& workbench, const XdgFolders& folders,
                                 fs::path samples, Hooks hooks)
    : editor_(editor),
      workbench_(workbench),
      hooks_(std::move(hooks)),
      samples_(std::move(samples)),
      recovery_(folders.state / "recovery"),
      recent_(workbench, background_, folders.state / "recent.json"),
      recoveries_(editor, workbench, recovery_, background_, hooks_.log),
      autosaver_(recovery_),
      background_(editor, hooks_.wake) {}

// Opening.

void DocumentSession::open(const fs::path& given, const MeshAnswers& answers) {
  start_open(full_path(given), answers, present_work());
}

void DocumentSession::when_opened(std::function<void()> then) {
  if (!opening()) return then();
  after_opening_.push_back(std::move(then));
}

bool DocumentSession::opening() const {
  return !editor_.has_document && (!background_.idle() || workbench_.question() != nullptr);
}

void DocumentSession::start_open(const fs::path& path, const MeshAnswers& answers, const Work& replaces) {
  background_.run_cancellable(
      Phrase(translatable("Opening {0}"), {name_of(path)}),
      [path, answers, replaces, choice = editor_.mesh_import, samples = samples_,
       own = lock_.held() ? lock_.path() : fs::path()](const CancelToken& cancel, const Progress& progress) {
        auto opened = std::make_shared<Opened>();
        opened->path = path;
        opened->replaces = replaces;
        std::error_code unknown;  // an error says that one of them does not exist: they are different
        opened->sample = fs::equivalent(path.parent_path(), samples, unknown);
        // The stamp is taken first, so that a change during reading counts as one.
        (void)remove_stale_temporaries(path.parent_path());
        opened->stamp = stamp_of(path);
        opened->file = open_as_answered(path, answers, choice, cancel, progress);
        if (!opened->file.native || !opened->file.document || opened->sample) return opened;
        const fs::path lock = lock_path_of(path);
        opened->own_lock = lock == own;
        if (!opened->own_lock) opened->attempt = FileLock::try_lock(lock, unix_seconds());
        return opened;
      },
      [this, answers](const std::shared_ptr<Opened>& opened) {
        if (opened->file.broken_mesh) return ask_about_mesh(opened, answers);
        if (!opened->file.document) return editor_.notify(*opened->file.error());
        if (opened->attempt.outcome == Outcome::taken) return ask_about_lock(opened);
        if (opened->file.meshes) return ask_about_faults_of(opened, answers);
        install(opened, opened->sample ? Mode::copy : Mode::normal);
      });
}

void DocumentSession::ask_about_mesh(const std::shared_ptr<Opened>& opened, const MeshAnswers& answers) {
  const auto accept = [this, opened](const Document& document, const std::string& note) {
    opened->file.document = document;
    opened->note = note;
    forget_errors(opened->file);
    install(opened, Mode::normal);
  };
  const OpenedFile& file = opened->file;
  if (answers.repair && file.repaired)
    return accept(*file.repaired, repair_note(editor_.language, opened->path, file.repair));
  hooks_.log("broken", opened->path);
  ask_about_broken_mesh(editor_, workbench_, opened->path, std::shared_ptr<const OpenedFile>(opened, &file),
                        accept, [this, path = opened->path, answers, replaces = opened->replaces] {
                          start_open(path, with_repair(answers), replaces);
                        });
}

void DocumentSession::ask_about_faults_of(const std::shared_ptr<Opened>& opened, const MeshAnswers& answers) {
  MeshReactions reactions;
  reactions.read_again = [this, path = opened->path, replaces = opened->replaces](
                             const MeshAnswers& decided) { start_open(path, decided, replaces); };
  reactions.accept = [this, opened] {
    if (opened->file.dense_faces > 0) return ask_about_density(opened);
    install(opened, opened->sample ? Mode::copy : Mode::normal);
  };
  reactions.asked = [this, path = opened->path](const char* what) { hooks_.log(what, path); };
  ask_about_faults(editor_, workbench_, opened->path,
                   std::shared_ptr<const OpenedFile>(opened, &opened->file), answers, reactions);
}

void DocumentSession::ask_about_density(const std::shared_ptr<Opened>& opened) {
  const auto take = [this, opened](const Document& document) {
    opened->file.document = Document(document);
    install(opened, Mode::normal);
  };
  ask_about_dense_mesh(editor_, workbench_, opened->path, {opened, &opened->file}, take);
}

void DocumentSession::ask_about_lock(const std::shared_ptr<Opened>& opened) {
  const Language& tr = editor_.language;
  workbench_.ask(
      {tr("The file is in use"),
       fill(tr("{0} is open in another window ({1}). What is saved there and here would overwrite each "
               "other."),
            {name_of(opened->path), owner_text(tr, opened->attempt.owner)}),
       {{tr("Open read-only"), "read_only", [this, opened] { install(opened, Mode::read_only); }},
        {tr("Open a copy"), "copy", [this, opened] { install(opened, Mode::copy); }},
        {tr("Cancel"), "cancel", {}}}});
  hooks_.log("locked", opened->path);
}

void DocumentSession::warn_about_lock(const fs::path& path, const FileLock::Attempt& attempt) {
  const Language& tr = editor_.language;
  const std::string reason =
      attempt.outcome == Outcome::unavailable ? tr(attempt.reason) : tr("no locks on this disk");
  editor_.warn(
      {"{0} cannot be locked ({1}). Take care that no other window saves it.", {name_of(path), reason}});
}

void DocumentSession::install(const std::shared_ptr<Opened>& opened, Mode mode) {
  if (!(opened->replaces == present_work()))
    return workbench_.guarded([this, opened, mode] {
      // The state that was read is older than the one just saved there.
      if (is_own_file(opened->path)) return open(opened->path);
      opened->replaces = present_work();
      install(opened, mode);
    });
  const bool file = opened->file.native && mode != Mode::copy;
  editor_.notices().clear();
  hooks_.replaced();
  editor_.open(*opened->file.document, file ? std::optional(opened->path) : std::nullopt);
  editor_.read_only = mode == Mode::read_only;
  if (!file) {
    const std::string stem = opened->path.stem().string();
    editor_.suggested_name = mode == Mode::copy ? fill(editor_.language("{0} copy"), {stem}) : stem;
  }
  document_ = editor_.documents;
  disk_ = file ? Disk{opened->stamp, opened->file.document} : Disk{};
  if (!opened->own_lock) lock_ = std::move(opened->attempt.lock);
  if (file && mode == Mode::normal && !opened->own_lock &&
      (opened->attempt.outcome == Outcome::unavailable || !opened->attempt.certain))
    warn_about_lock(opened->path, opened->attempt);
  constexpr std::size_t most_warnings = 6;
  for (std::size_t i = 0; i < std::min(most_warnings, opened->file.messages.size()); ++i)
    editor_.notify(opened->file.messages[i]);
  if (const char* note = opened->file.native ? note_about_frames(*opened->file.document) : nullptr)
    editor_.inform(note);
  if (!opened->note.empty()) editor_.notify(Notice::Kind::info, opened->note);
  if (!opened->sample) recent_.used(opened->path);
  hooks_.log("opened", opened->path);
}

// Saving.

bool DocumentSession::is_own_file(const fs::path& path) const {
  return editor_.path && lock_path_of(*editor_.path) == lock_path_of(path);
}

void DocumentSession::save(const fs::path& given, std::function<void()> then) {
  fs::path path = full_path(given);
  // Being saved under another name, the document has left its file, which stays as it is.
  if (next_file_ && next_file_->document == editor_.documents && is_own_file(path)) path = next_file_->path;
  start_save(path, std::move(then), false);
}

void DocumentSession::start_save(const fs::path& path, std::function<void()> then, bool overwrite) {
  auto saved = std::make_shared<Saved>();
  saved->path = path;
  // The committed value is saved, not the preview of a drag; it may change while this one is written.
  saved->document = editor_.history.current();
  saved->document_number = editor_.documents;
  saved->serial = editor_.history.serial();
  const fs::path own_lock = lock_.held() ? lock_.path() : fs::path();
  const Disk expected = is_own_file(path) && !overwrite ? disk_ : Disk{};
  const bool again = next_file_ && next_file_->document == editor_.documents && next_file_->path == path;
  if (!is_own_file(path)) next_file_ = NextFile{editor_.documents, path};
  ++unwritten_;
  background_.run(
      Phrase(translatable("Saving {0}"), {name_of(path)}),
      [saved, own_lock, expected, again, own = own_write_](const CancelToken&) {
        const fs::path lock = lock_path_of(saved->path);
        // The save before this one has locked the file where it wrote it.
        if (lock != own_lock && !(again && own->lock == lock))
          saved->attempt = FileLock::try_lock(lock, unix_seconds());
        if (saved->attempt.outcome == Outcome::taken) {
          *own = {};
          return saved;
        }
        const auto now = stamp_of(saved->path);
        // A file that an earlier save wrote after this one was asked for is no change.
        const bool is_own_write = own->lock == lock && own->stamp == now;
        if (expected.stamp && now && now != expected.stamp && !is_own_write) {
          // A touched file is not a changed one: only different content is asked about.
          const auto content = load_document(saved->path);
          saved->changed_on_disk = !content.ok() || !expected.content || !(*content == *expected.content);
          if (saved->changed_on_disk) return saved;
        }
        saved->result = save_document(saved->document, saved->path);
        (void)remove_stale_temporaries(saved->path.parent_path());
        saved->stamp = stamp_of(saved->path);
        *own = {lock, saved->stamp};
        return saved;
      },
      [this, then = std::move(then)](const std::shared_ptr<Saved>& done) { finish_save(*done, then); });
}

void DocumentSession::finish_save(Saved& saved, const std::function<void()>& then) {
  --unwritten_;
  if (next_file_ && next_file_->path == saved.path) next_file_.reset();
  if (saved.attempt.outcome == Outcome::taken) return editor_.notify(in_use(saved.path));
  if (saved.changed_on_disk) return ask_about_change(saved.path, then);
  if (!saved.result.ok()) return editor_.notify(saved.result.error());
  editor_.inform({"Saved {0}.", {name_of(saved.path)}});
  recent_.used(saved.path);
  if (saved.document_number == editor_.documents) {
    editor_.path = saved.path;
    editor_.read_only = false;
    editor_.history.mark_saved(saved.serial);
    disk_ = {saved.stamp, saved.document};
    ++saves_;
    if (saved.attempt.outcome == Outcome::acquired) lock_ = std::move(saved.attempt.lock);
  }
  hooks_.log("saved", saved.path);
  if (then) then();
}

void DocumentSession::ask_about_change(const fs::path& path, std::function<void()> then) {
  const Language& tr = editor_.language;
  workbench_.ask(
      {tr("The file was changed"),
       fill(tr("Another program changed {0} after it was opened here. Saving would overwrite those changes."),
            {name_of(path)}),
       {{tr("Save as\u2026"), "save_as", [this, then] { workbench_.files().save_as(then); }},
        {tr("Overwrite"), "overwrite", [this, path, then] { start_save(path, then, true); }},
        {tr("Cancel"), "cancel", {}}}});
  hooks_.log("changed", path);
}

void DocumentSession::save_copy(const fs::path& given) {
  const fs::path path = full_path(given);
  if (is_own_file(path)) return save(path, {});
  ++unwritten_;
  background_.run(
      Phrase(translatable("Saving {0}"), {name_of(path)}),
      [path, document = editor_.history.current()](const CancelToken&) -> Result<Done> {
        const auto attempt = FileLock::try_lock(lock_path_of(path), unix_seconds());
        if (attempt.outcome == Outcome::taken) return in_use(path);
        return save_document(document, path);
      },
      [this, path](const Result<Done>& saved) {
        --unwritten_;
        if (!saved.ok()) return editor_.notify(saved.error());
        editor_.inform({"Saved a copy as {0}.", {name_of(path)}});
        hooks_.log("copied", path);
      });
}

void DocumentSession::revert() {
  const fs::path path = *editor_.path;
  struct Reverted {
    std::optional<FileStamp> stamp;
    Result<Document> document;
  };
  background_.run(
      Phrase(translatable("Opening {0}"), {name_of(path)}),
      [path](const CancelToken&) {
        const auto stamp = stamp_of(path);
        return Reverted{stamp, load_document(path)};
      },
      [this, path, number = editor_.documents](const Reverted& reverted) {
        if (number != editor_.documents) return;
        if (!reverted.document.ok()) return editor_.notify(reverted.document.error());
        editor_.cancel_preview();
        editor_.commit(reverted.document, translatable("Revert to the file"));
        editor_.history.mark_saved();
        disk_ = {reverted.stamp, *reverted.document};
        hooks_.log("reverted", path);
      });
}

// Autosave.

double DocumentSession::interval() const {
  return std::clamp(editor_.settings.autosave_seconds, 1.0, Settings::most_autosave_seconds);
}

void DocumentSession::update() {
  if (!after_opening_.empty() && !opening())
    for (const auto& then : std::exchange(after_opening_, {})) then();
  // Another document, or none: the file no longer belongs to this session
  if (document_ != editor_.documents) {
    document_ = editor_.documents;
    disk_ = {};
    lock_ = {};
  }
  if (!editor_.has_document || !editor_.history.dirty()) {
    autosaver_.set_nothing();
  } else if (const Autosaver::State state{document_, editor_.history.serial(), saves_};
             !autosaver_.is_latest(state)) {
    autosaver_.set_work(
        {editor_.history.current(), state, {editor_.path.value_or(fs::path()), disk_.stamp, 0}});
  }
  if (!autosaving_ && autosaver_.due(editor_.now, interval())) autosave();
}

void DocumentSession::autosave() {
  autosaving_ = true;
  autosaver_.started(editor_.now);
  background_.run(
      {}, [this](const CancelToken&) { return autosaver_.write(unix_seconds()); },
      [this](const Result<Done>& written) {
        autosaving_ = false;
        if (!written.ok() && !autosave_failed_) editor_.notify(written.error());
        autosave_failed_ = !written.ok();
        if (written.ok()) hooks_.log("autosaved", {});
      });
}

double DocumentSession::due_in() const {
  return autosaving_ ? -1 : autosaver_.due_in(editor_.now, interval());
}

void DocumentSession::write_autosave() {
  (void)autosaver_.write(unix_seconds());  // the program ends: there is nobody to report to
}

void DocumentSession::end() {
  if (unwritten_ > 0) {
    // Work that would keep them waiting was asked about before the user left.
    for (const auto& job : editor_.jobs)
      if (job->can_be_cancelled) job->cancel.cancel();
    background_.wait();
  }
  autosaver_.set_nothing();
  (void)autosaver_.write(unix_seconds());
}

// Work of earlier sessions and recent files.

void DocumentSession::find_offers(Pictures& pictures) {
  recoveries_.find(pictures);
  recent_.find(pictures);
}

void DocumentSession::recover(const std::string& id) {
  workbench_.guarded([this, id] {
    background_.run(
        translatable("Recovering"),
        [this, id, replaces = present_work()](const CancelToken&) {
          auto recovered = std::make_shared<Recovered>();
          recovered->replaces = replaces;
          auto slot = recovery_.adopt(id, unix_seconds());
          if (!slot.ok()) {
            recovered->copy = slot.error();
            return recovered;
          }
          recovered->copy = read_recovery(slot->folder());
          recovered->slot = std::move(slot).value();
          if (recovered->copy.ok() && !recovered->copy->note.original.empty())
            recovered->attempt =
                FileLock::try_lock(lock_path_of(recovered->copy->note.original), unix_seconds());
          return recovered;
        },
        [this, id](const std::shared_ptr<Recovered>& recovered) { finish_recovery(id, recovered); });
  });
}

void DocumentSession::finish_recovery(const std::string& id, const std::shared_ptr<Recovered>& found) {
  const Language& tr = editor_.language;
  Recovered& recovered = *found;
  if (!recovered.copy.ok()) return editor_.notify(recovered.copy.error());
  if (!(recovered.replaces == present_work()))
    return workbench_.guarded([this, id, found] {
      found->replaces = present_work();
      finish_recovery(id, found);
    });
  const RecoveryNote& note = recovered.copy->note;
  const Document document = with_absolute_pictures(recovered.copy->document, note.original.parent_path());
  const bool in_use = recovered.attempt.outcome == Outcome::taken;
  const bool file = !note.original.empty() && !in_use;
  editor_.notices().clear();
  hooks_.replaced();
  editor_.open(document, file ? std::optional(note.original) : std::nullopt);
  if (in_use) editor_.suggested_name = fill(tr("{0} recovered"), {note.original.stem().string()});
  editor_.history.mark_unsaved();
  document_ = editor_.documents;
  disk_ = {file ? note.original_stamp : std::nullopt, std::nullopt};
  lock_ = std::move(recovered.attempt.lock);
  autosaver_.adopt(std::move(*recovered.slot),
                   {document, {document_, editor_.history.serial(), saves_}, note});
  recoveries_.remove(id);
  workbench_.offers().recovery_places = 0;
  if (in_use)
    editor_.warn(
        {"{0} is open in another window: the recovered work has no file yet.", {name_of(note.original)}});
  else
    editor_.inform("The work is recovered. Save it to keep it.");
  hooks_.log("recovered", note.original);
}

}  // namespace hariko
