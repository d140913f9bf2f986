#include "ui/base/language.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <set>
#include <system_error>
#include <utility>

#include "core/base/files/file_io.hpp"
#include "ui/base/language_files.hpp"
#include "ui/base/text_number.hpp"

namespace hariko {

namespace {

/// Stands between a context and the text.
constexpr char context_end = '\4';

const char* without_context(const char* english) {
  const char* end = std::strchr(english, context_end);
  return end ? end + 1 : english;
}

/// The argument that is the count of a text with a plural: the last one before the first difference of the
/// two, or the first one.
std::size_t counted_argument(std::string_view one, std::string_view many) {
  const auto difference = static_cast<std::size_t>(
      std::mismatch(one.begin(), one.end(), many.begin(), many.end()).second - many.begin());
  std::optional<std::size_t> first, last;
  for (std::size_t i = 0; i < many.size(); ++i)
    if (const auto number = placeholder_at(many, i)) {
      if (!first) first = number;
      if (i < difference) last = number;
    }
  if (one == many) last = first;
  return last.value_or(first.value_or(0));
}

}  // namespace

std::u32string code_points(std::string_view utf8) {
  std::u32string out;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto first = static_cast<unsigned char>(utf8[i++]);
    const int more = first < 0x80 ? 0 : first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : -1;
    char32_t point = more < 0 ? 0xfffd : more == 0 ? first : first & (0x3fU >> more);
    for (int k = 0; k < more; ++k) {
      if (i >= utf8.size() || (static_cast<unsigned char>(utf8[i]) & 0xc0) != 0x80) {
        point = 0xfffd;
        break;
      }
      point = (point << 6) | (static_cast<unsigned char>(utf8[i++]) & 0x3fU);
    }
    out += point;
  }
  return out;
}

Result<Language> Language::load(const std::filesystem::path& path) {
  auto bytes = read_file(path, largest_catalogue);
  if (!bytes) return make_error(e_catalogue, bytes.error().text, catalogue_remedy);
  auto read = read_po(*bytes);
  if (!read) return error_in_catalogue(path, read.error());
  Language language;
  auto forms = PluralForms::parse(read.value().header["Plural-Forms"]);
  if (!forms) return error_in_catalogue(path, forms.error());
  language.forms_ = *std::move(forms);
  for (PoEntry& entry : read.value().entries) {
    const std::size_t expected = entry.plural.empty() ? 1 : language.forms_.count();
    if (entry.translations.size() != expected)
      return error_in_catalogue(path, make_error(e_catalogue,
                                                 "Line " + std::to_string(entry.line) +
                                                     ": The entry needs one msgstr for each plural form.",
                                                 catalogue_remedy, {Element::Kind::line, entry.line}));
    if (entry.translated()) language.add(std::move(entry));
  }
  const auto text_of_pattern = [](const Pattern& pattern) {
    std::size_t length = 0;
    for (const std::string& literal : pattern.literals) length += literal.size();
    return length;
  };
  std::stable_sort(
      language.patterns_.begin(), language.patterns_.end(),
      [&](const Pattern& a, const Pattern& b) { return text_of_pattern(a) > text_of_pattern(b); });
  for (std::size_t i = 0; i < language.patterns_.size(); ++i)
    language.pattern_of_.emplace(language.patterns_[i].english, i);
  return language;
}

void Language::add(PoEntry entry) {
  const std::string context = entry.context.empty() ? std::string() : entry.context + context_end;
  const Forms& forms = entry.translations;
  if (entry.plural.empty()) {
    add_pattern(entry.text, forms, 0);
    translations_.emplace(context + entry.text, forms.front());
    return;
  }
  const std::size_t place = counted_argument(entry.text, entry.plural);
  add_pattern(entry.plural, forms, place);
  if (entry.text != entry.plural) add_pattern(entry.text, forms, place);
  // Callers without a count fill the places themselves; a text for one that has no place is complete.
  translations_.emplace(context + entry.plural, forms.back());
  const std::string& one = forms[forms_.form(1)];
  translations_.emplace(context + entry.text, cut(entry.text).numbers.empty() ? fill(one, {"1"}) : one);
  plurals_.emplace(context + entry.text, std::move(entry.translations));
}

void Language::add_pattern(const std::string& english, const Forms& translations, std::size_t place) {
  Pattern pattern = cut(english);
  if (pattern.numbers.empty()) return;
  pattern.translations = translations;
  pattern.counted = place;
  patterns_.push_back(std::move(pattern));
}

Language::Pattern Language::cut(const std::string& english) {
  Pattern pattern;
  pattern.english = english;
  std::string literal;
  for (std::size_t i = 0; i < english.size(); ++i) {
    const auto number = placeholder_at(english, i);
    if (!number) {
      literal += english[i];
      continue;
    }
    pattern.literals.push_back(std::exchange(literal, {}));
    pattern.numbers.push_back(*number);
    i += 2;
  }
  pattern.literals.push_back(std::move(literal));
  return pattern;
}

std::optional<std::vector<std::string>> Language::match(const Pattern& pattern, std::string_view text) {
  const std::string& front = pattern.literals.front();
  const std::string& back = pattern.literals.back();
  if (text.size() < front.size() + back.size() || !text.starts_with(front) || !text.ends_with(back))
    return {};
  const std::size_t end = text.size() - back.size();
  std::vector<std::string> arguments(10);
  std::size_t from = front.size();
  for (std::size_t i = 0; i < pattern.numbers.size(); ++i) {
    std::size_t to = end;
    const bool last = i + 1 == pattern.numbers.size();
    if (!last) {
      to = text.find(pattern.literals[i + 1], from);
      if (to == std::string_view::npos || to + pattern.literals[i + 1].size() > end) return {};
    }
    arguments[pattern.numbers[i]] = std::string(text.substr(from, to - from));
    if (!last) from = to + pattern.literals[i + 1].size();
  }
  return arguments;
}

const std::string& Language::form_for(const Pattern& pattern,
                                      const std::vector<std::string>& arguments) const {
  if (pattern.translations.size() == 1) return pattern.translations.front();
  if (pattern.counted < arguments.size())
    if (const auto count = number_in<std::uint64_t>(arguments[pattern.counted]))
      return pattern.translations[forms_.form(*count)];
  return pattern.translations.back();
}

std::optional<std::string> Language::find_phrase(std::string_view english, Entries entries) const {
  const auto it = translations_.find(english);
  if (it != translations_.end()) return it->second;
  for (const Pattern& pattern : patterns_) {
    const std::string& end = pattern.literals.back();
    // Labels such as "{0} of {1}" are found in many sentences.
    if (entries == Entries::sentences && (end.empty() || !std::strchr(".?!", end.back()))) continue;
    if (auto arguments = match(pattern, english)) {
      const std::string& translation = form_for(pattern, *arguments);
      for (std::string& argument : *arguments)
        if (const auto known = translations_.find(argument); known != translations_.end())
          argument = known->second;
      return fill(translation, *arguments);
    }
  }
  return {};
}

std::optional<std::string> Language::find_sentence(std::string_view english) const {
  if (auto whole = find_phrase(english, Entries::sentences)) return whole;
  for (std::size_t at = english.find(": "); at != std::string_view::npos; at = english.find(": ", at + 2)) {
    const auto rest = find_phrase(english.substr(at + 2), Entries::sentences);
    if (!rest) continue;
    std::string about(english.substr(0, at));
    // The last of several parts may have an entry: a line or a byte of a file.
    const std::size_t last = about.rfind(": ");
    const std::size_t begin = last == std::string::npos ? 0 : last + 2;
    return about.substr(0, begin) + numbered(about.substr(begin)) + ": " + *rest;
  }
  return {};
}

std::string Language::numbered(const std::string& english) const {
  const std::size_t space = english.rfind(' ') + 1;  // 0 where there is none
  const bool number = space > 0 && space < english.size() &&
                      english.find_first_not_of("0123456789", space) == std::string::npos;
  const auto it = number ? translations_.find(english.substr(0, space) + "{0}") : translations_.end();
  return it == translations_.end() ? english : fill(it->second, {english.substr(space)});
}

std::string Language::phrase(std::string_view english) const {
  return find_phrase(english).value_or(std::string(english));
}

std::string Language::operator()(const Phrase& text) const {
  if (text.arguments().empty()) return phrase(text.english());
  if (const auto at = pattern_of_.find(text.pattern()); at != pattern_of_.end())
    return fill(form_for(patterns_[at->second], text.arguments()), text.arguments());
  // A text for one that does not say the number.
  if (const auto at = translations_.find(text.pattern()); at != translations_.end())
    return fill(at->second, text.arguments());
  return text.english();
}

std::string Language::counted(std::size_t count, const char* one, const char* many) const {
  const std::string number = std::to_string(count);
  const auto it = plurals_.find(std::string_view(one));
  if (it == plurals_.end()) return fill((*this)(count == 1 ? one : many), {number});
  return fill(it->second[forms_.form(count)], {number});
}

std::u32string Language::characters() const {
  std::set<char32_t> points;
  for (const auto& [english, translation] : translations_)
    for (const char32_t point : code_points(translation)) points.insert(point);
  for (const auto& [english, forms] : plurals_)
    for (const std::string& form : forms)
      for (const char32_t point : code_points(form)) points.insert(point);
  return {points.begin(), points.end()};
}

const char* Language::operator()(const char* english) const {
  const auto it = translations_.find(std::string_view(english));
  return it == translations_.end() ? without_context(english) : it->second.c_str();
}

std::string Language::operator()(const std::string& english) const {
  const auto it = translations_.find(english);
  if (it != translations_.end()) return it->second;
  const std::size_t end = english.find(context_end);
  return end == std::string::npos ? english : english.substr(end + 1);
}

bool Language::has(std::string_view english) const {
  return translations_.find(english) != translations_.end();
}

std::string Language::text_of(const Message& message) const {
  if (auto sentence = find_sentence(message.text)) return *sentence;
  const auto it = translations_.find(message.code.name);
  if (it == translations_.end()) return message.text;
  if (message.element.kind == Element::Kind::none) return it->second;
  const std::string element = to_string(message.element);
  const std::size_t space = element.find(' ');
  return (*this)(element.substr(0, space)) + element.substr(space) + ": " + it->second;
}

std::string Language::remedy_of(const Message& message) const {
  if (message.remedy.empty()) return {};
  if (auto sentence = find_phrase(message.remedy, Entries::sentences)) return *sentence;
  const auto it = translations_.find(std::string(message.code.name) + ".remedy");
  if (it != translations_.end()) return it->second;
  return message.remedy;
}

}  // namespace hariko
