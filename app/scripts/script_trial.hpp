#pragma once

// ScriptTrial: what steps of a script make of a document, found by running them.

#include <memory>
#include <optional>
#include <span>

#include "app/scripts/circumstances.hpp"
#include "app/scripts/script_session.hpp"

namespace hariko {

/// Document in which a script stands, with its circumstances.
struct ScriptState {
  std::optional<Document> document;  ///< nothing before the first one was opened
  Circumstances circumstances;
};

/// Runs steps as `hariko run` does, in a session of its own. For the main thread.
class ScriptTrial {
 public:
  explicit ScriptTrial(ScriptSession::OpenFile open_file) : open_file_(std::move(open_file)) {}

  /// State in which a script begins.
  ScriptState start();
  /// State after the steps; nothing where one of them is refused. Takes as long as they take.
  std::optional<ScriptState> run(const ScriptState& from, std::span<const WrittenCommand> steps);
  const CommandTable& commands() { return session().commands(); }

 private:
  ScriptSession& session();
  bool run_step(const WrittenCommand& step);

  ScriptSession::OpenFile open_file_;
  std::unique_ptr<ScriptSession> session_;
};

}  // namespace hariko
