#include "ui/editor/operation_arguments.hpp"

#include <algorithm>

namespace hariko {

namespace {

ArgumentSpec argument_of(const OperationNumber& number) {
  ArgumentSpec spec;
  spec.name = number.id;
  spec.help = number.label;
  if (!number.choices.empty()) {
    spec.type = ArgumentType::word;
    spec.words.assign(number.choices.begin(), number.choices.end());
    spec.standard = spec.words[static_cast<std::size_t>(number.value)];
    return spec;
  }
  spec.type = number.whole ? ArgumentType::whole : ArgumentType::number;
  spec.unit = number.whole ? ArgumentUnit::none : number.angle ? ArgumentUnit::degrees : ArgumentUnit::length;
  spec.standard = number.value;
  spec.low = number.low;
  spec.high = number.high;
  return spec;
}

}  // namespace

std::vector<ArgumentSpec> arguments_of(std::span<const OperationNumber> numbers) {
  std::vector<ArgumentSpec> out;
  for (const OperationNumber& number : numbers) out.push_back(argument_of(number));
  return out;
}

std::vector<OperationNumber> with_values(std::vector<OperationNumber> numbers, const Arguments& arguments) {
  for (OperationNumber& number : numbers) {
    if (number.choices.empty()) {
      number.value = arguments.number(number.id);
      continue;
    }
    const auto chosen = std::find(number.choices.begin(), number.choices.end(), arguments.text(number.id));
    number.value = static_cast<double>(chosen - number.choices.begin());
  }
  return numbers;
}

std::vector<WrittenArgument> written_numbers(std::span<const OperationNumber> numbers) {
  std::vector<WrittenArgument> out;
  for (const OperationNumber& number : numbers)
    out.push_back(number.choices.empty()
                      ? written(number.id, number.value)
                      : written(number.id, std::string(number.choices[std::size_t(number.value)])));
  return out;
}

}  // namespace hariko
