#pragma once

// History: undo and redo by storing earlier documents.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/text/phrase.hpp"
#include "core/document/document.hpp"
#include "core/document/history/memory.hpp"

namespace hariko {

/// List of documents with a current one. Documents share memory, so a step costs only its changes. When all
/// steps together need more than `byte_limit`, the oldest are dropped, but never the current document.
///
/// A gesture (a drag, a slider being moved) shows previews that are not in the history; its end makes one
/// step, its cancellation none.
class History {
 public:
  static constexpr std::size_t default_byte_limit = std::size_t(256) << 20;

  explicit History(Document document = {}, std::size_t byte_limit = default_byte_limit);

  /// The last committed document.
  const Document& current() const { return steps_[position_].document; }
  /// Document to show: the preview while there is one, else the current document.
  const Document& shown() const { return preview_ ? *preview_ : current(); }

  /// Commits a document and drops the redo steps. False, and no step, when it equals the current one. Ends a
  /// gesture. `label` names the change in the undo menu, such as "Move 3 vertices".
  bool push(Document document, Phrase label);

  bool in_gesture() const { return preview_.has_value(); }
  /// Starts or continues a gesture.
  void preview(Document document) { preview_ = std::move(document); }
  /// Makes one step of the gesture. False when it changed nothing or there is none.
  bool commit_preview(Phrase label);
  void cancel_preview() { preview_.reset(); }

  /// Moves one step back or forward; cancels a gesture first. False when there is nothing to undo or redo.
  bool undo();
  bool redo();
  bool can_undo() const { return position_ > 0; }
  bool can_redo() const { return position_ + 1 < steps_.size(); }
  /// Label of the change that undo would revert or redo would repeat, in English; empty when there is none.
  const std::string& undo_label() const;
  const std::string& redo_label() const;

  /// Labels of all steps, oldest first; entry i led from state i to state i + 1. Those in English are filled.
  std::vector<Phrase> phrases() const;
  std::vector<std::string> labels() const;
  /// Index of the current state: the number of steps that can be undone.
  std::size_t position() const { return position_; }
  /// Goes to a state by undo or redo steps; false when there is no such state. Cancels a gesture first.
  bool go_to(std::size_t position);

  /// Marks the current document as saved on disk. To mark a state that is no longer current:
  /// `mark_saved(serial())` with the serial taken when the save began.
  void mark_saved() { saved_ = serial(); }
  void mark_saved(std::uint64_t serial) { saved_ = serial; }
  /// Marks no state as saved: the file is gone, or the document was recovered.
  void mark_unsaved() { saved_.reset(); }
  /// Whether the current state differs from the saved one. A new history counts as saved.
  bool dirty() const { return saved_ != serial(); }
  /// Serial number of the current state: unique within this history, and restored by undo.
  std::uint64_t serial() const { return steps_[position_].serial; }
  /// Serial number of any state, 0 .. `labels().size()`.
  std::uint64_t serial_at(std::size_t position) const { return steps_[position].serial; }
  /// Serial number of the oldest state kept; serials rise along the list.
  std::uint64_t oldest_serial() const { return steps_.front().serial; }

  /// New history that begins with the current state under its serial; later steps can be undone back to it.
  History fork() const;
  /// Inserts the history that this one was forked from: its earlier states, and if this one has no further
  /// steps also its later ones. Does nothing where the state of the fork is no longer kept.
  void prepend(History before);

  /// Bytes of all states together, shared memory counted once; previews do not count.
  std::size_t bytes() const { return memory_.bytes(); }
  std::size_t byte_limit() const { return byte_limit_; }

 private:
  struct Step {
    Document document;
    Phrase label;  ///< names the change that led to this state
    std::uint64_t serial = 0;
  };

  void forget_redo();
  void forget_oldest();

  std::vector<Step> steps_;
  std::size_t position_ = 0;
  std::optional<Document> preview_;
  std::optional<std::uint64_t> saved_ = 0;
  std::uint64_t next_serial_ = 1;
  std::size_t byte_limit_;
  SharedMemory memory_;
};

}  // namespace hariko
