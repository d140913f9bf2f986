#pragma once

// GltfFields: checked access to members of a glTF file's JSON description. Internal to core/exchange.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.hpp"

namespace hariko {

/// Name of an entry for messages: "nodes[3]".
std::string numbered(const char* list, std::uint64_t number);

/// Member of an object; null where there is none.
const nlohmann::json* find(const nlohmann::json& object, const char* name);
/// Text member; empty where there is none.
std::string text_of(const nlohmann::json& object, const char* name);
/// Length of a list member; 0 where there is none.
std::size_t size_of(const nlohmann::json& object, const char* list);

/// Typed access to members; `place` names the object in messages. The first error is noted, and values
/// returned after an error do not count.
class GltfFields {
 public:
  const std::optional<Message>& error() const { return error_; }
  /// Notes an error. Always returns false, so that callers can return it.
  bool fail(Message message);
  /// Notes E_PARSE at a place.
  bool fail(const std::string& place, const std::string& sentence);

  /// Object number `number` in a list of the root; null, with an error noted, where there is none.
  const nlohmann::json* entry(const nlohmann::json& root, const char* list, std::uint64_t number);
  /// Non-negative integer member; nothing where it is missing or, with an error noted, malformed.
  std::optional<std::uint64_t> whole(const nlohmann::json& object, const char* name,
                                     const std::string& place);
  /// Non-negative integer member, required.
  std::uint64_t needed(const nlohmann::json& object, const char* name, const std::string& place);
  /// List of non-negative integers; empty where there is no such member.
  std::vector<std::uint64_t> wholes(const nlohmann::json& object, const char* name, const std::string& place);
  /// List of `count` numbers, finite as all JSON numbers; empty where there is no such member.
  std::vector<double> reals(const nlohmann::json& object, const char* name, std::size_t count,
                            const std::string& place);

 private:
  std::optional<Message> error_;
};

}  // namespace hariko
