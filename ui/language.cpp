#include "ui/language.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

namespace hariko {

std::string fill(std::string_view pattern, std::initializer_list<std::string> arguments) {
  std::string out;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool placeholder = i + 2 < pattern.size() && pattern[i] == '{' && pattern[i + 2] == '}' &&
                             pattern[i + 1] >= '0' && pattern[i + 1] <= '9';
    const std::size_t number = placeholder ? static_cast<std::size_t>(pattern[i + 1] - '0') : 0;
    if (!placeholder || number >= arguments.size()) {
      out += pattern[i];
      continue;
    }
    out += arguments.begin()[number];
    i += 2;
  }
  return out;
}

Result<Language> Language::load(const std::filesystem::path& path) {
  const auto failed = [&](const std::string& why) {
    return make_error(e_catalogue, "The catalogue " + path.filename().string() + " " + why + ".",
                      "Install the program's assets again. English is used until then.");
  };
  std::ifstream in(path);
  if (!in) return failed("cannot be read");
  const auto json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object()) return failed("is not a JSON object");
  Language language;
  for (const auto& [english, translation] : json.items()) {
    if (!translation.is_string()) return failed("has an entry that is not a string: " + english);
    language.translations_.emplace(english, translation.get<std::string>());
  }
  return language;
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
  const auto it = translations_.find(message.code.name);
  if (it == translations_.end()) return (*this)(message.text);
  if (message.element.kind == Element::Kind::none) return it->second;
  const std::string element = to_string(message.element);
  const std::size_t space = element.find(' ');
  return (*this)(element.substr(0, space)) + element.substr(space) + ": " + it->second;
}

std::string Language::remedy_of(const Message& message) const {
  const auto it = translations_.find(std::string(message.code.name) + ".remedy");
  if (it != translations_.end()) return it->second;
  return has(message.code.name) ? std::string() : (*this)(message.remedy);
}

}  // namespace hariko
