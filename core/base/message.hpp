#pragma once

// Messages to the designer about an input: a code, the element concerned, a sentence, and a remedy.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace hariko {

/// Stable name of a kind of message, such as E_NO_FACES. Each folder declares its own codes as constants;
/// names that start with E_ are errors, with W_ warnings.
struct Code {
  std::string_view name;
  friend bool operator==(Code a, Code b) { return a.name == b.name; }
};

enum class Severity { warning, error };

/// Element that a message is about. Ids are the stable ids of the polyhedron, or line numbers of a file (from
/// 1).
struct Element {
  enum class Kind { none, vertex, edge, face, object, line };
  Kind kind = Kind::none;
  std::uint64_t id = 0;
  friend bool operator==(const Element&, const Element&) = default;
};

/// Text of an element: "vertex 12", "edge 12-13", "face 3", "line 7"; empty for none.
std::string to_string(const Element& element);

/// Error or warning about an element of the input.
struct Message {
  Severity severity = Severity::error;
  Code code;
  Element element;
  std::string text;    ///< the fault and its place, one sentence for a designer
  std::string remedy;  ///< advice for the designer; may be empty
};

/// Text of a message with its code: "E_FACE_TOO_SMALL (face 3): The face has 2 corners. Delete it or add a
/// corner."
std::string to_string(const Message& message);

/// Message of severity error, or of severity warning.
Message make_error(Code code, std::string text, std::string remedy = {}, Element element = {});
Message make_warning(Code code, std::string text, std::string remedy = {}, Element element = {});

/// Count for a sentence: the number, with `one` or `several` behind it, such as " face" and " faces".
std::string counted(std::size_t count, std::string_view one, std::string_view several);
/// Number for a sentence, rounded to significant digits (at most 17), in any locale with a decimal point.
std::string rounded_text(double value, int digits);

}  // namespace hariko
