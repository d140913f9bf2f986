#include "ui/base/language.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace hariko {

namespace {

/// The number of a placeholder that stands at i; nothing when there is none.
std::optional<std::size_t> placeholder_at(std::string_view text, std::size_t i) {
  if (i + 2 >= text.size() || text[i] != '{' || text[i + 2] != '}') return {};
  if (text[i + 1] < '0' || text[i + 1] > '9') return {};
  return static_cast<std::size_t>(text[i + 1] - '0');
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

std::string fill(std::string_view pattern, std::span<const std::string> arguments) {
  std::string out;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const auto number = placeholder_at(pattern, i);
    if (!number || *number >= arguments.size()) {
      out += pattern[i];
      continue;
    }
    out += arguments[*number];
    i += 2;
  }
  return out;
}

std::string fill(std::string_view pattern, std::initializer_list<std::string> arguments) {
  return fill(pattern, std::span(arguments.begin(), arguments.size()));
}

Result<Language> Language::load(const std::filesystem::path& path) {
  const auto failed = [&](const char* sentence, const std::string& detail = {}) {
    return make_error(e_catalogue, fill(sentence, {path.filename().string(), detail}),
                      "Install the program's assets again. English is used until then.");
  };
  std::ifstream in(path);
  if (!in) return failed(translatable("The catalogue {0} cannot be read."));
  const auto json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object()) return failed(translatable("The catalogue {0} is not a JSON object."));
  Language language;
  for (const auto& [english, translation] : json.items()) {
    if (!translation.is_string())
      return failed(translatable("The catalogue {0} has an entry that is not a string: {1}."), english);
    language.translations_.emplace(english, translation.get<std::string>());
    Pattern pattern = cut(english, translation.get<std::string>());
    if (!pattern.numbers.empty()) language.patterns_.push_back(std::move(pattern));
  }
  const auto text_of_pattern = [](const Pattern& pattern) {
    std::size_t length = 0;
    for (const std::string& literal : pattern.literals) length += literal.size();
    return length;
  };
  std::stable_sort(
      language.patterns_.begin(), language.patterns_.end(),
      [&](const Pattern& a, const Pattern& b) { return text_of_pattern(a) > text_of_pattern(b); });
  return language;
}

Language::Pattern Language::cut(const std::string& english, const std::string& translation) {
  Pattern pattern;
  pattern.translation = translation;
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

std::optional<std::string> Language::find_phrase(std::string_view english, Entries entries) const {
  const auto it = translations_.find(english);
  if (it != translations_.end()) return it->second;
  for (const Pattern& pattern : patterns_) {
    const std::string& end = pattern.literals.back();
    // Labels such as "{0} of {1}" are found in many sentences.
    if (entries == Entries::sentences && (end.empty() || !std::strchr(".?!", end.back()))) continue;
    if (auto arguments = match(pattern, english)) {
      for (std::string& argument : *arguments)
        if (const auto known = translations_.find(argument); known != translations_.end())
          argument = known->second;
      return fill(pattern.translation, *arguments);
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

std::u32string Language::characters() const {
  std::set<char32_t> points;
  for (const auto& [english, translation] : translations_)
    for (const char32_t point : code_points(translation)) points.insert(point);
  return {points.begin(), points.end()};
}

const char* Language::operator()(const char* english) const {
  const auto it = translations_.find(std::string_view(english));
  return it == translations_.end() ? english : it->second.c_str();
}

std::string Language::operator()(const std::string& english) const {
  const auto it = translations_.find(english);
  return it == translations_.end() ? english : it->second;
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
