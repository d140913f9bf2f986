#pragma once

// LastOperation: a step whose numbers can still be changed right after it was made, and that can be made
// again on what is selected then.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/ids.hpp"
#include "core/base/progress.hpp"
#include "core/base/text/phrase.hpp"
#include "core/document/document.hpp"
#include "ui/editor/command_arguments.hpp"
#include "ui/editor/selection.hpp"

namespace hariko {

/// Work that an edit of one object begins with, and what makes the step of it.
struct LongEdit {
  using Then = std::function<void()>;
  Phrase what;  ///< "Fitting Body"
  ObjectId object;
  /// Computes from values alone, as it may run on another thread, and returns soon when it is cancelled.
  /// Work of the worker; returns a function, never empty, that is called on the main thread unless cancelled.
  std::function<Then(const CancelToken&, const Progress&)> work;
};

class Editor;

struct OperationNumber {
  const char* id;     ///< also the mark "last.<id>"
  const char* label;  ///< English, translated where it is shown
  double value = 0;
  double low = 0, high = 0;
  bool whole = false;  ///< a count; others are lengths in the document's unit
  bool angle = false;  ///< in degrees instead of a length
  /// Names of the values 0, 1, ..., English, which then are a list instead of a number.
  std::vector<const char*> choices = {};
};

/// A length between those that primitives can have, in both directions.
OperationNumber distance_number(const char* id, const char* label, double value);
OperationNumber choice_number(const char* id, const char* label, std::vector<const char*> choices,
                              int value = 0);

/// Result of an operation with these numbers on a document, the object that is then active, and what is
/// selected.
struct OperationResult {
  Document document;
  ObjectId active;
  ElementSelection selected = {};      ///< elements of the active object
  std::vector<ObjectId> objects = {};  ///< whole objects; empty: those that were chosen stay so
  bool keeps_selection = false;        ///< selection and active element stay as before
  bool selects_as_operation = false;   ///< `selected` is for `select_result`
  /// Tells what it brought, after each time the step was made or changed nothing; may be empty.
  std::function<void(Editor&)> say = {};
};
using MakeOperation =
    std::function<Result<OperationResult>(const Document&, std::span<const OperationNumber>)>;

/// Work that has to be done before an operation is quick with these numbers on this document, and that keeps
/// what the operation reads then; nothing where it is done already. It is asked for again where the document
/// is another one than that which the operation began with.
using PrepareOperation =
    std::function<std::optional<LongEdit>(const Document&, std::span<const OperationNumber>)>;

/// Steps of a script that do what an operation does with these numbers.
using WriteOperation = std::function<std::vector<WrittenCommand>(std::span<const OperationNumber>)>;

/// An operation on what is selected in an editor.
struct BegunOperation {
  MakeOperation make;
  Phrase label = {};              ///< name of its step; empty: as before
  WriteOperation written = {};    ///< empty: no command does the same
  PrepareOperation prepare = {};  ///< empty: it is always quick
};
/// Begins an operation anew, on what is selected then, or says why it cannot be.
using BeginOperation = std::function<Result<BegunOperation>(const Editor&)>;

struct OperationStep {
  Phrase label;
  std::vector<OperationNumber> numbers;
  MakeOperation make;             ///< empty: of a step that was taken up and cannot be adjusted
  BeginOperation begin = {};      ///< for repeating; empty: `make` is repeated
  WriteOperation written = {};    ///< empty: no command does the same
  PrepareOperation prepare = {};  ///< empty: it is always quick
};

/// Can be adjusted as long as the document is the one that it made, and repeated as long as no other step of
/// the same document was made after it.
class LastOperation {
 public:
  /// Makes the step, or begins with what it needs (`prepare`): then it is made when that is there, and a
  /// notice says where its objects were changed meanwhile. False, with a notice, when it is refused.
  bool run(Editor& editor, OperationStep step);
  bool run(Editor& editor, Phrase label, std::vector<OperationNumber> numbers, MakeOperation make) {
    return run(editor, {std::move(label), std::move(numbers), std::move(make), {}});
  }
  /// Takes up a step that a tool has just made of the document `before`. Without numbers it is only for
  /// repeating, and `before` does not matter: an older step can be adjusted when one goes back to it.
  void take_up(const Editor& editor, Document before, OperationStep step);
  /// Takes up a step that a command without numbers has just made: running it again repeats it.
  void take_up_command(const Editor& editor, std::string id);
  /// Makes the step anew with another number, in the place of the old one, or begins with what it needs;
  /// refused numbers change nothing.
  bool adjust(Editor& editor, std::size_t number, double value);
  /// Makes a further step like it, with its numbers, on what is selected now. False, with a notice, when it
  /// is refused. Not where a `command` is to be repeated.
  bool repeat(Editor& editor);

  bool can_adjust(const Editor& editor) const;
  /// Whether it, or the command, is the last step that was made; undone ones count, too.
  bool can_repeat(const Editor& editor) const;
  /// Id of the command that is to be run for repeating; empty where `repeat` does it.
  const std::string& command() const { return command_; }
  /// Number of steps that were run or taken up.
  std::uint64_t count() const { return count_; }
  const Phrase& label() const { return step_.label; }
  const std::vector<OperationNumber>& numbers() const { return step_.numbers; }

 private:
  static bool run_prepared(Editor& editor, const LongEdit& first, OperationStep step);
  bool adjust_prepared(Editor& editor, const LongEdit& first, std::size_t number, double value);
  bool commit(Editor& editor, const Document& before, const OperationStep& step);
  void note(const Editor& editor, std::string command);

  OperationStep step_;  ///< to be adjusted
  Document before_, after_;
  OperationStep again_;  ///< to be repeated, where no command is
  std::string command_;
  std::uint64_t count_ = 0;
  // The state of the history that the last step led to, and its document.
  std::uint64_t serial_ = 0, documents_ = 0;
};

/// Declarations of the numbers, which are the defaults: lengths count as millimetres. Choices are words.
std::vector<ArgumentSpec> arguments_of(std::span<const OperationNumber> numbers);

/// The numbers with the values of arguments that `arguments_of` declared.
std::vector<OperationNumber> with_values(std::vector<OperationNumber> numbers, const Arguments& arguments);

/// The numbers as a script writes them.
std::vector<WrittenArgument> written_numbers(std::span<const OperationNumber> numbers);

}  // namespace hariko
