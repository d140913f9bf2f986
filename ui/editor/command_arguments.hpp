#pragma once

// Arguments of commands: what a script says to a command beyond its name. The row of a command declares them,
// `read_arguments` checks what is written.

#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_argument{"E_ARGUMENT"};

enum class ArgumentType {
  number,  ///< a number, or a text with an expression, which may have units
  whole,
  point,  ///< three numbers
  on_off,
  word,  ///< one of a few
  text,
  path,  ///< path of a file; relative ones begin at the working directory
  list,  ///< texts; whole numbers count as texts, and one alone needs no list
};
/// Word of a type: "number", "whole number" ...
std::string_view name_of(ArgumentType type);

/// Unit of numbers and points. Lengths are in the document's unit, angles in degrees.
enum class ArgumentUnit { none, length, degrees };

/// Checked value of an argument; whole numbers are doubles, words and paths are texts.
using ArgumentValue = std::variant<bool, double, std::string, Vector3, std::vector<std::string>>;

/// Declaration of an argument.
struct ArgumentSpec {
  std::string name;  ///< "width"
  ArgumentType type = ArgumentType::number;
  std::string help = {};  ///< English: a label or a sentence
  ArgumentUnit unit = ArgumentUnit::none;
  /// Default; lengths are in millimetres here. Without one the argument must be written, unless `optional`.
  std::optional<ArgumentValue> standard = {};
  bool optional = false;  ///< may be missing without a default: `Arguments::has`
  /// Bounds of numbers, whole numbers and each number of a point; of lengths in the document's unit.
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  std::vector<std::string> words = {};  ///< choices of type `word`

  bool required() const { return !standard && !optional; }
};

// Declarations in short. Nothing as `standard`: the argument must be written.

ArgumentSpec length_argument(std::string name, std::string help, std::optional<double> millimetres,
                             double low = -std::numeric_limits<double>::infinity());
ArgumentSpec angle_argument(std::string name, std::string help, std::optional<double> degrees);
ArgumentSpec number_argument(std::string name, std::string help, std::optional<double> standard, double low,
                             double high);
ArgumentSpec whole_argument(std::string name, std::string help, std::optional<int> standard, int low,
                            int high);
ArgumentSpec point_argument(std::string name, std::string help, ArgumentUnit unit,
                            const std::optional<Vector3>& standard);
ArgumentSpec on_off_argument(std::string name, std::string help, std::optional<bool> standard);
ArgumentSpec word_argument(std::string name, std::string help, std::vector<std::string> words,
                           std::optional<std::string> standard);
ArgumentSpec text_argument(std::string name, std::string help);
ArgumentSpec path_argument(std::string name, std::string help);
ArgumentSpec list_argument(std::string name, std::string help);
/// The same declaration; the argument may be missing.
ArgumentSpec optional(ArgumentSpec spec);

/// Default of an argument that has one (asserted), lengths in a unit.
ArgumentValue standard_in(const ArgumentSpec& spec, Unit unit);

/// Values of the arguments of a command. The getters assert that the argument is there and of that type.
class Arguments {
 public:
  bool has(std::string_view name) const { return values_.find(name) != values_.end(); }
  double number(std::string_view name) const { return get<double>(name); }
  int whole(std::string_view name) const { return static_cast<int>(get<double>(name)); }
  bool on(std::string_view name) const { return get<bool>(name); }
  const Vector3& point(std::string_view name) const { return get<Vector3>(name); }
  const std::string& text(std::string_view name) const { return get<std::string>(name); }
  const std::vector<std::string>& list(std::string_view name) const {
    return get<std::vector<std::string>>(name);
  }
  void set(std::string name, ArgumentValue value);

 private:
  template <class T>
  const T& get(std::string_view name) const {
    const auto found = values_.find(name);
    HARIKO_ASSERT(found != values_.end(), "the argument is missing");
    const T* value = std::get_if<T>(&found->second);
    HARIKO_ASSERT(value != nullptr, "the argument is of another type");
    return *value;
  }
  std::map<std::string, ArgumentValue, std::less<>> values_;
};

/// Value as a script has it.
using WrittenScalar = std::variant<bool, double, std::string>;
using WrittenValue = std::variant<bool, double, std::string, std::vector<WrittenScalar>>;
struct WrittenArgument {
  std::string name;
  WrittenValue value;
  friend bool operator==(const WrittenArgument&, const WrittenArgument&) = default;
};
/// A command as a step of a script has it.
struct WrittenCommand {
  std::string command;
  std::vector<WrittenArgument> arguments = {};
  friend bool operator==(const WrittenCommand&, const WrittenCommand&) = default;
};

WrittenArgument written(std::string name, double value);
WrittenArgument written(std::string name, const Vector3& point);
WrittenArgument written(std::string name, std::string text);
WrittenArgument written(std::string name, const std::vector<std::string>& texts);
/// Not an overload, which texts in quotes would choose.
WrittenArgument written_switch(std::string name, bool on);

/// Checks what is written against the declarations and adds defaults. `unit`: of the document; without one
/// lengths count as millimetres and their ranges are not checked. Errors: E_ARGUMENT (a name that is not
/// declared, with the nearest one; a name that is written twice; a value of another type or out of its range;
/// a word that is none of the list; an argument that is missing). O(arguments squared).
Result<Arguments> read_arguments(std::span<const ArgumentSpec> specs,
                                 std::span<const WrittenArgument> written, std::optional<Unit> unit);

}  // namespace hariko
