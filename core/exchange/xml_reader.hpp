#pragma once

// XmlReader: the elements of an XML text that comes in pieces. Internal to core/exchange; the only door to
// expat.

#include <cstddef>
#include <exception>
#include <optional>
#include <string>
#include <string_view>

#include "core/exchange/imported_mesh.hpp"

struct XML_ParserStruct;

namespace hariko {

/// Of the element that begins; names as those of elements.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}
  /// Null where there is no such attribute.
  const char* find(std::string_view name) const;

 private:
  const char** pairs_;
};

/// What is told of the text. Names with a namespace are "namespace|name".
class XmlTarget {
 public:
  virtual ~XmlTarget() = default;
  virtual void start(std::string_view name, const XmlAttributes& attributes) = 0;
  virtual void end() {}
  /// Before `start` of the element that declares the prefix.
  virtual void declare(std::string_view, std::string_view /*uri*/) {}
};

/// Refuses document types, and with them entities; elements nested deeper than 32; tags of more than a
/// million characters. Memory is bounded by these.
class XmlReader {
 public:
  static constexpr char separator = '|';

  /// `part` is what messages call the text.
  XmlReader(XmlTarget& target, std::string part, const ReadLimits& limits);
  ~XmlReader();
  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;

  /// False where the text was refused.
  bool feed(std::string_view piece) { return parse(piece, false); }
  /// Ends the text. E_PARSE, E_TRUNCATED, E_LIMIT, E_CANCELLED, or what the target refused.
  std::optional<Message> finish();

  /// For the target: the line where the element begins, counted from 1.
  std::size_t line() const;
  /// For the target: nothing more is told after the first refusal.
  void refuse(Code code, const std::string& sentence,
              const char* remedy = "Correct the file, or export it again.");
  bool refused() const { return error_.has_value(); }

 private:
  bool parse(std::string_view piece, bool last);
  template <class Body>
  static void tell(void* self, const Body& body);

  XmlTarget& target_;
  std::string part_;
  const ReadLimits& limits_;
  XML_ParserStruct* parser_;
  std::optional<Message> error_;
  std::exception_ptr thrown_;  ///< by the target; expat is C and must not see it
  std::size_t depth_ = 0, fed_ = 0;
};

}  // namespace hariko
