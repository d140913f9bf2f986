#pragma once

// XmlReader: streaming reader of XML text. Internal to core/exchange; the only user of expat.

#include <cstddef>
#include <exception>
#include <optional>
#include <string>
#include <string_view>

#include "core/exchange/imported_mesh.hpp"

struct XML_ParserStruct;

namespace hariko {

/// Attributes of the element that begins; names as those of elements.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}
  /// Value of an attribute; null where there is none.
  const char* find(std::string_view name) const;

 private:
  const char** pairs_;
};

/// Receiver of the elements of a text. Names with a namespace are "namespace|name".
class XmlTarget {
 public:
  virtual ~XmlTarget() = default;
  /// Called at the start of an element.
  virtual void start(std::string_view name, const XmlAttributes& attributes) = 0;
  /// Called at the end of an element.
  virtual void end() {}
  /// Called for a namespace prefix, before `start` of the element that declares it.
  virtual void declare(std::string_view, std::string_view /*uri*/) {}
};

/// Reader that bounds memory by refusing document types, and with them entities, elements nested deeper than
/// 32, and tags of more than a million characters.
class XmlReader {
 public:
  static constexpr char separator = '|';

  /// `part` names the text in messages.
  XmlReader(XmlTarget& target, std::string part, const ReadLimits& limits);
  ~XmlReader();
  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;

  /// Parses the next piece; false where the text was refused.
  bool feed(std::string_view piece) { return parse(piece, false); }
  /// Ends the text. Errors: E_PARSE, E_TRUNCATED, E_LIMIT, E_CANCELLED, or the target's refusal.
  std::optional<Message> finish();

  /// Line where the present element begins, counted from 1; for the target.
  std::size_t line() const;
  /// Stops the parsing with an error; for the target, which is not called any more.
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
  std::exception_ptr thrown_;  ///< thrown by the target; it must not pass through expat, which is C
  std::size_t depth_ = 0, fed_ = 0;
};

}  // namespace hariko
