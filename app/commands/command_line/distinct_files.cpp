#include "app/commands/command_line/distinct_files.hpp"

#include <CLI/CLI.hpp>
#include <system_error>

namespace hariko {

void check_distinct(const std::filesystem::path& in, const std::filesystem::path& out) {
  std::error_code ignored;
  if (in == out || std::filesystem::equivalent(in, out, ignored))
    throw CLI::ValidationError("OUT", "must be another file than FILE");
}

}  // namespace hariko
