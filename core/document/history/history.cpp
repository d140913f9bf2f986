#include "core/document/history/history.hpp"

#include <utility>

namespace hariko {
namespace {

/// Label returned for steps that do not exist.
const std::string no_label;

}  // namespace

History::History(Document document, std::size_t byte_limit) : byte_limit_(byte_limit) {
  steps_.push_back({std::move(document), {}, 0});
  memory_.add(steps_.front().document);
}

bool History::push(Document document, Phrase label) {
  preview_.reset();
  if (document == current()) return false;
  forget_redo();
  steps_.push_back({std::move(document), std::move(label), next_serial_++});
  memory_.add(steps_.back().document);
  ++position_;
  forget_oldest();
  return true;
}

bool History::commit_preview(Phrase label) {
  if (!preview_) return false;
  return push(*std::exchange(preview_, std::nullopt), std::move(label));
}

bool History::undo() {
  preview_.reset();
  if (!can_undo()) return false;
  --position_;
  return true;
}

bool History::redo() {
  preview_.reset();
  if (!can_redo()) return false;
  ++position_;
  return true;
}

bool History::go_to(std::size_t position) {
  preview_.reset();
  if (position >= steps_.size()) return false;
  position_ = position;
  return true;
}

const std::string& History::undo_label() const {
  return can_undo() ? steps_[position_].label.english() : no_label;
}
const std::string& History::redo_label() const {
  return can_redo() ? steps_[position_ + 1].label.english() : no_label;
}

std::vector<Phrase> History::phrases() const {
  std::vector<Phrase> phrases;
  for (std::size_t i = 1; i < steps_.size(); ++i) phrases.push_back(steps_[i].label);
  return phrases;
}

std::vector<std::string> History::labels() const {
  std::vector<std::string> labels;
  for (std::size_t i = 1; i < steps_.size(); ++i) labels.push_back(steps_[i].label.english());
  return labels;
}

History History::fork() const {
  History fork(current(), byte_limit_);
  fork.steps_.front().serial = serial();
  fork.next_serial_ = next_serial_;
  if (dirty())
    fork.saved_.reset();
  else
    fork.saved_ = serial();
  return fork;
}

void History::prepend(History before) {
  if (oldest_serial() != before.serial()) return;
  const std::optional<std::uint64_t> saved = saved_ ? saved_ : before.saved_;
  const std::size_t position = before.position_ + position_;
  before.preview_ = std::exchange(preview_, std::nullopt);
  if (steps_.size() > 1) before.forget_redo();
  for (std::size_t i = 1; i < steps_.size(); ++i) {
    before.memory_.add(steps_[i].document);
    before.steps_.push_back(std::move(steps_[i]));
  }
  before.next_serial_ = next_serial_;
  before.position_ = position;
  before.saved_ = saved;
  *this = std::move(before);
  forget_oldest();
}

void History::forget_redo() {
  while (can_redo()) {
    memory_.remove(steps_.back().document);
    steps_.pop_back();
  }
}

void History::forget_oldest() {
  std::size_t count = 0;
  while (memory_.bytes() > byte_limit_ && count < position_) memory_.remove(steps_[count++].document);
  steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(count));
  position_ -= count;
}

}  // namespace hariko
