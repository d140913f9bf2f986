#include "core/base/text/dxf_writer.hpp"

#include <charconv>

namespace hariko {

void DxfWriter::pair(int code, std::string_view value) {
  text_ += std::to_string(code);
  text_ += '\n';
  text_ += value;
  text_ += '\n';
}

void DxfWriter::number(int code, double value) {
  char text[400];  // every double has its place in fixed notation
  // A negative zero becomes a positive one.
  const auto end = std::to_chars(text, text + sizeof text, value + 0.0, std::chars_format::fixed, 9).ptr;
  pair(code, std::string_view(text, static_cast<std::size_t>(end - text)));
}

void DxfWriter::point(int code, const Vector3& p) {
  for (int k = 0; k < 3; ++k) number(code + 10 * k, p[k]);
}

void DxfWriter::begin(std::string_view kind, std::string_view name) {
  pair(0, kind);
  pair(2, name);
}

void DxfWriter::begin_header() {
  begin("SECTION", "HEADER");
  pair(9, "$ACADVER");
  pair(1, "AC1009");
  pair(9, "$INSUNITS");
  pair(70, "4");  // millimetres
  pair(9, "$MEASUREMENT");
  pair(70, "1");
}

std::string DxfWriter::take() {
  pair(0, "EOF");
  return std::move(text_);
}

}  // namespace hariko
