#include "core/exchange/archive_3mf/xml_reader.hpp"

#include <expat.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace hariko {
namespace {

#ifdef HARIKO_EXPAT_64
std::uint64_t current_line(XML_Parser parser) {
  return XML_GetCurrentLineNumber64(parser);
}
std::int64_t current_byte(XML_Parser parser) {
  return XML_GetCurrentByteIndex64(parser);
}
#else
std::uint64_t current_line(XML_Parser parser) {
  return XML_GetCurrentLineNumber(parser);
}
std::int64_t current_byte(XML_Parser parser) {
  return XML_GetCurrentByteIndex(parser);
}
#endif

constexpr std::size_t max_depth = 32, max_tag = 1'000'000, piece_size = 65536;

}  // namespace

const char* XmlAttributes::find(std::string_view name) const {
  for (const char** pair = pairs_; *pair; pair += 2)
    if (name == pair[0]) return pair[1];
  return nullptr;
}

template <class Body>
void XmlReader::tell(void* self, const Body& body) {
  auto& reader = *static_cast<XmlReader*>(self);
  if (reader.error_ || reader.thrown_) return;
  try {
    body(reader);
  } catch (...) {
    reader.thrown_ = std::current_exception();
    XML_StopParser(reader.parser_, XML_FALSE);
  }
}

XmlReader::XmlReader(XmlTarget& target, std::string part, const ReadLimits& limits)
    : target_(target),
      part_(std::move(part)),
      limits_(limits),
      parser_(XML_ParserCreateNS(nullptr, separator)) {
  HARIKO_ASSERT(parser_ != nullptr, "no memory for a parser");
  XML_SetUserData(parser_, this);
  XML_SetElementHandler(
      parser_,
      [](void* self, const char* name, const char** attributes) {
        tell(self, [&](XmlReader& reader) {
          if (++reader.depth_ > max_depth) return reader.refuse(e_parse, "The elements are nested too deep.");
          reader.target_.start(name, XmlAttributes(attributes));
        });
      },
      [](void* self, const char*) {
        tell(self, [](XmlReader& reader) {
          --reader.depth_;
          reader.target_.end();
        });
      });
  XML_SetStartNamespaceDeclHandler(parser_, [](void* self, const char* prefix, const char* uri) {
    tell(self, [&](XmlReader& reader) { reader.target_.declare(prefix ? prefix : "", uri ? uri : ""); });
  });
  XML_SetStartDoctypeDeclHandler(parser_, [](void* self, const char*, const char*, const char*, int) {
    tell(self, [](XmlReader& reader) { reader.refuse(e_parse, "A document type is not allowed here."); });
  });
}

XmlReader::~XmlReader() {
  XML_ParserFree(parser_);
}

std::size_t XmlReader::line() const {
  return static_cast<std::size_t>(current_line(parser_));
}

void XmlReader::refuse(Code code, const std::string& sentence, const char* remedy) {
  if (error_) return;
  error_ = make_error(code, "Line " + std::to_string(line()) + " of " + part_ + ": " + sentence, remedy,
                      {Element::Kind::line, line()});
  XML_StopParser(parser_, XML_FALSE);
}

bool XmlReader::parse(std::string_view piece, bool last) {
  // Splits large texts: the parser keeps a tag that is not complete.
  for (; piece.size() > piece_size; piece.remove_prefix(piece_size))
    if (!parse(piece.substr(0, piece_size), false)) return false;
  if (error_) return false;
  if (limits_.cancel.cancelled()) {
    error_ = make_error(e_cancelled, "The import was cancelled.");
    return false;
  }
  fed_ += piece.size();
  const XML_Status status = XML_Parse(parser_, piece.data(), static_cast<int>(piece.size()), last ? 1 : 0);
  if (thrown_) std::rethrow_exception(thrown_);
  if (status == XML_STATUS_ERROR && !error_) {
    const XML_Error code = XML_GetErrorCode(parser_);
    if (last &&
        (code == XML_ERROR_NO_ELEMENTS || code == XML_ERROR_UNCLOSED_TOKEN || code == XML_ERROR_PARTIAL_CHAR))
      refuse(e_truncated, "The text ends before what it began is complete.",
             "The file was cut off: copy or export it again.");
    else
      refuse(e_parse, "This is not XML: " + std::string(XML_ErrorString(code)) + ".");
  }
  const auto done = static_cast<std::size_t>(std::max<std::int64_t>(current_byte(parser_), 0));
  if (!error_ && fed_ > done + max_tag) refuse(e_limit, "A tag is longer than a million characters.");
  return !error_;
}

std::optional<Message> XmlReader::finish() {
  parse({}, true);
  return error_;
}

}  // namespace hariko
