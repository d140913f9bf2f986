#include "core/exchange/gltf/gltf_fields.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/files/file_io.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {

using Json = nlohmann::json;

std::string numbered(const char* list, std::uint64_t number) {
  return std::string(list) + "[" + std::to_string(number) + "]";
}

const Json* find(const Json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

std::string text_of(const Json& object, const char* name) {
  const Json* found = find(object, name);
  return found && found->is_string() ? found->get<std::string>() : std::string();
}

std::size_t size_of(const Json& object, const char* list) {
  const Json* found = find(object, list);
  return found && found->is_array() ? found->size() : 0;
}

bool GltfFields::fail(Message message) {
  if (!error_) error_ = std::move(message);
  return false;
}

bool GltfFields::fail(const std::string& place, const std::string& sentence) {
  return fail(make_error(e_parse, place + ": " + sentence, "Correct the file, or export it again."));
}

const Json* GltfFields::entry(const Json& root, const char* list, std::uint64_t number) {
  const std::string place = numbered(list, number);
  if (number >= size_of(root, list)) {
    fail(place, "It is used, but there is none.");
    return nullptr;
  }
  const Json* found = &root[list][number];
  if (found->is_object()) return found;
  fail(place, "It should be an object.");
  return nullptr;
}

std::optional<std::uint64_t> GltfFields::whole(const Json& object, const char* name,
                                               const std::string& place) {
  const Json* found = find(object, name);
  if (!found) return {};
  if (found->is_number_unsigned()) return found->get<std::uint64_t>();
  fail(place, quote(name) + " should be a whole number that is not negative.");
  return {};
}

std::uint64_t GltfFields::needed(const Json& object, const char* name, const std::string& place) {
  const auto found = whole(object, name, place);
  if (!found) fail(place, quote(name) + " is missing.");
  return found.value_or(0);
}

std::vector<std::uint64_t> GltfFields::wholes(const Json& object, const char* name,
                                              const std::string& place) {
  std::vector<std::uint64_t> out;
  const Json* list = find(object, name);
  if (!list) return out;
  const bool good = list->is_array() && std::all_of(list->begin(), list->end(), [](const Json& value) {
                      return value.is_number_unsigned();
                    });
  if (!good) {
    fail(place, quote(name) + " should be a list of whole numbers that are not negative.");
    return out;
  }
  for (const Json& value : *list) out.push_back(value.get<std::uint64_t>());
  return out;
}

std::vector<double> GltfFields::reals(const Json& object, const char* name, std::size_t count,
                                      const std::string& place) {
  std::vector<double> out;
  const Json* list = find(object, name);
  if (!list) return out;
  const bool good =
      list->is_array() && list->size() == count &&
      std::all_of(list->begin(), list->end(), [](const Json& value) { return value.is_number(); });
  if (!good) {
    fail(place, quote(name) + " should be " + std::to_string(count) + " numbers.");
    return out;
  }
  for (const Json& value : *list) out.push_back(value.get<double>());
  return out;
}

}  // namespace hariko
