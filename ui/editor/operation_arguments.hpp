#pragma once

// Numbers of operations as arguments of commands.

#include <span>
#include <vector>

#include "ui/editor/command_arguments.hpp"
#include "ui/editor/last_operation.hpp"

namespace hariko {

/// Declarations of the numbers, which are the defaults: lengths count as millimetres. Choices are words.
std::vector<ArgumentSpec> arguments_of(std::span<const OperationNumber> numbers);

/// The numbers with the values of arguments that `arguments_of` declared.
std::vector<OperationNumber> with_values(std::vector<OperationNumber> numbers, const Arguments& arguments);

/// The numbers as a script writes them.
std::vector<WrittenArgument> written_numbers(std::span<const OperationNumber> numbers);

}  // namespace hariko
