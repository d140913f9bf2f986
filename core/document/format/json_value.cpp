#include "core/document/format/json_value.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/base/files/file_io.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/document/format/format.hpp"

namespace hariko::detail {
namespace {

using Json = nlohmann::json;

/// Iterates over the text and counts consumed characters, because the parser's events carry no position.
class TrackingIterator {
 public:
  // NOLINTBEGIN(readability-identifier-naming): names that iterators must have
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;
  // NOLINTEND(readability-identifier-naming)

  TrackingIterator(const char* at, std::size_t* consumed) : at_(at), consumed_(consumed) {}
  reference operator*() const { return *at_; }
  TrackingIterator& operator++() {
    ++at_;
    ++*consumed_;
    return *this;
  }
  TrackingIterator operator++(int) {
    TrackingIterator before = *this;
    ++*this;
    return before;
  }
  // Member function, because as an unused friend it causes warnings in some compilers, depending on how != is
  // rewritten.
  bool operator==(const TrackingIterator& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  std::size_t* consumed_;
};

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

std::string line_and_column(std::string_view text, std::size_t position, std::uint64_t& line) {
  const std::string_view before = text.substr(0, position > 0 ? std::min(position - 1, text.size()) : 0);
  line = 1 + static_cast<std::uint64_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - line_begin + 1);
}

/// Receives the parser's events and builds the value; stops at the first error.
class Builder final : public nlohmann::json_sax<Json> {
 public:
  Builder(std::string_view text, const std::size_t& consumed) : text_(text), consumed_(consumed) {}

  bool null() override { return scalar(JsonValue()); }
  bool boolean(bool value) override { return scalar(JsonValue(value)); }
  bool number_integer(number_integer_t value) override {
    return scalar(JsonValue(static_cast<double>(value)));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return scalar(JsonValue(static_cast<double>(value)));
  }
  bool number_float(number_float_t value, const string_t&) override { return scalar(JsonValue(value)); }
  bool string(string_t& value) override { return scalar(JsonValue(std::move(value))); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(JsonValue::make_object()); }
  bool start_array(std::size_t) override { return open(JsonValue::make_array()); }
  bool end_object() override {
    if (!check_names(*open_.back()->object())) return false;
    close();
    return true;
  }
  bool end_array() override {
    close();
    return true;
  }
  bool key(string_t& name) override {
    JsonMember member;
    member.name = std::move(name);
    std::size_t begin = consumed_;
    while (begin < text_.size() && (is_space(text_[begin]) || text_[begin] == ':')) ++begin;
    member.begin = begin;
    open_.back()->object()->push_back(std::move(member));
    return true;
  }
  bool parse_error(std::size_t position, const std::string& token, const Json::exception& reason) override {
    constexpr int number_overflow = 406;
    std::uint64_t line = 0;
    const std::string where = line_and_column(text_, position, line);
    const bool at_end = position > text_.size();
    const std::string what = reason.id == number_overflow
                                 ? "the number \"" + shortened(token, 120) + "\" is too large"
                             : at_end ? std::string("the text ends too early")
                                      : "\"" + shortened(token, 120) + "\" does not belong here";
    error_ = make_error(e_parse, "The file is not valid JSON: at " + where + " " + what + ".",
                        "Open an intact copy of the file, or repair that line in a text editor.",
                        {Element::Kind::line, line});
    return false;
  }

  Result<JsonValue> take() {
    if (error_) return *error_;
    return std::move(root_);
  }

 private:
  /// Stores a value at its place in the tree and returns its final address.
  JsonValue* place(JsonValue value) {
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    if (JsonArray* array = open_.back()->array()) {
      array->push_back(std::move(value));
      return &array->back();
    }
    JsonMember& member = open_.back()->object()->back();
    member.value = std::move(value);
    return &member.value;
  }
  bool count() {
    if (++values_ <= max_document_values) return true;
    error_ =
        make_error(e_limit, "The file has more values than this program accepts.", "Split the document.");
    return false;
  }
  bool scalar(JsonValue value) {
    if (!count()) return false;
    const bool number = value.number() != nullptr;
    place(std::move(value));
    end_member(number);
    return true;
  }
  bool open(JsonValue value) {
    if (!count()) return false;
    if (open_.size() >= static_cast<std::size_t>(max_document_depth)) {
      std::uint64_t line = 0;
      const std::string where = line_and_column(text_, consumed_, line);
      error_ = make_error(e_limit, "The file is nested too deeply at " + where + ".",
                          "Open an intact copy of the file.", {Element::Kind::line, line});
      return false;
    }
    open_.push_back(place(std::move(value)));
    return true;
  }
  void close() {
    open_.pop_back();
    end_member(false);
  }
  /// Records where a complete value's text ends, when it is a member. The parser reads one character past a
  /// number.
  void end_member(bool number) {
    if (open_.empty() || !open_.back()->object()) return;
    JsonMember& member = open_.back()->object()->back();
    member.end = consumed_;
    if (!number) return;
    member.end = member.begin;
    while (member.end < text_.size() &&
           std::string_view("+-.eE0123456789").find(text_[member.end]) != std::string::npos)
      ++member.end;
  }
  bool check_names(const JsonObject& object) {
    std::vector<std::string_view> names;
    names.reserve(object.size());
    for (const JsonMember& member : object) names.push_back(member.name);
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice == names.end()) return true;
    error_ =
        make_error(e_schema, "The member \"" + shortened(*twice, 120) + "\" appears twice in one object.",
                   "Remove one of the two in a text editor.");
    return false;
  }

  std::string_view text_;
  const std::size_t& consumed_;
  JsonValue root_;
  /// Containers being filled; addresses stay valid, because only the innermost one grows.
  std::vector<JsonValue*> open_;
  std::size_t values_ = 0;
  std::optional<Message> error_;
};

}  // namespace

JsonValue JsonValue::make_array() {
  JsonValue value;
  value.state_ = std::make_unique<JsonArray>();
  return value;
}

JsonValue JsonValue::make_object() {
  JsonValue value;
  value.state_ = std::make_unique<JsonObject>();
  return value;
}

Result<JsonValue> parse_json(std::string_view text) {
  if (text.size() > max_document_bytes)
    return make_error(e_limit, "The file is larger than this program accepts.", "Split the document.");
  std::size_t consumed = 0;
  Builder builder(text, consumed);
  Json::sax_parse(TrackingIterator(text.data(), &consumed),
                  TrackingIterator(text.data() + text.size(), &consumed), &builder);
  return builder.take();
}

}  // namespace hariko::detail
