#pragma once

// GltfFields: members of the description of a glTF file, checked. Internal to core/exchange.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.hpp"

namespace hariko {

/// "nodes[3]".
std::string numbered(const char* list, std::uint64_t number);

/// The member of an object; null where there is none.
const nlohmann::json* find(const nlohmann::json& object, const char* name);
/// A member that is text; empty where there is none.
std::string text_of(const nlohmann::json& object, const char* name);
/// Length of a member that is a list; 0 where there is none.
std::size_t size_of(const nlohmann::json& object, const char* list);

/// Takes members of a type; `place` is what messages call the object. What is wrong is noted, the first time,
/// and the value given then does not count.
class GltfFields {
 public:
  const std::optional<Message>& error() const { return error_; }
  /// Always false, for callers that have nothing else to give.
  bool fail(Message message);
  bool fail(const std::string& place, const std::string& sentence);

  /// An object of a list of the whole; null, noted, where there is none.
  const nlohmann::json* entry(const nlohmann::json& root, const char* list, std::uint64_t number);
  /// A whole number that is not negative.
  std::optional<std::uint64_t> whole(const nlohmann::json& object, const char* name,
                                     const std::string& place);
  std::uint64_t needed(const nlohmann::json& object, const char* name, const std::string& place);
  std::vector<std::uint64_t> wholes(const nlohmann::json& object, const char* name, const std::string& place);
  /// So many numbers, all finite as JSON has no others; empty where there is no such member.
  std::vector<double> reals(const nlohmann::json& object, const char* name, std::size_t count,
                            const std::string& place);

 private:
  std::optional<Message> error_;
};

}  // namespace hariko
