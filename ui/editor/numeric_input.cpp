#include "ui/editor/numeric_input.hpp"

#include <algorithm>

namespace hariko {

namespace {

bool is_letter(char32_t c) {
  return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z');
}

bool is_axis(char32_t c) {
  return c == U'x' || c == U'y' || c == U'z' || c == U'X' || c == U'Y' || c == U'Z';
}

}  // namespace

bool NumericInput::takes(char32_t c) const {
  const std::string& text = texts_[current_];
  if (text.size() >= max_expression_length) return false;
  if ((c >= U'0' && c <= U'9') || c == U'.' || c == U'-' || c == U'+' || c == U'(') return true;
  if (text.empty()) return false;
  if (c == U'*' || c == U'/' || c == U'^' || c == U')' || c == U',' || c == U' ' || c == U'"') return true;
  // X, Y and Z choose axes, but for those within a name: max, exp.
  if (is_axis(c)) return is_letter(static_cast<unsigned char>(text.back()));
  return is_letter(c);
}

bool NumericInput::key(const KeyPress& press) {
  std::string& text = texts_[current_];
  if (press.chord.key == Key::backspace) {
    if (!active()) return false;
    if (press.chord.control || text.empty()) text.clear();
    if (!text.empty()) text.pop_back();
    return true;
  }
  if (press.chord.key == Key::tab) {
    if (texts_.size() < 2) return active();
    current_ = (current_ + (press.chord.shift ? texts_.size() - 1 : 1)) % texts_.size();
    return true;
  }
  if (press.chord.control || press.chord.alt || press.text == 0 || !takes(press.text)) return false;
  text += static_cast<char>(press.text);
  return true;
}

bool NumericInput::active() const {
  return std::ranges::any_of(texts_, [](const std::string& text) { return !text.empty(); });
}

std::optional<double> NumericInput::value(std::size_t component) const {
  if (texts_[component].empty()) return std::nullopt;
  const auto value = evaluate(texts_[component], units_);
  return value ? std::optional<double>(*value) : std::nullopt;
}

std::optional<Message> NumericInput::error() const {
  if (texts_[current_].empty()) return std::nullopt;
  const auto value = evaluate(texts_[current_], units_);
  return value ? std::nullopt : std::optional<Message>(value.error());
}

bool NumericInput::unfinished() const {
  const std::string& text = texts_[current_];
  std::size_t begin = text.size();
  while (begin > 0 && is_letter(static_cast<unsigned char>(text[begin - 1]))) --begin;
  const std::string_view unit = std::string_view(text).substr(begin);
  return !unit.empty() && std::ranges::any_of(units_, [&](const UnitFactor& longer) {
    return longer.name.size() > unit.size() && longer.name.starts_with(unit);
  });
}

void NumericInput::resize(std::size_t components) {
  texts_.resize(components);
  current_ = std::min(current_, components - 1);
}

void NumericInput::clear() {
  std::fill(texts_.begin(), texts_.end(), std::string());
  current_ = 0;
}

}  // namespace hariko
