#pragma once

// The question whether corners of an imported mesh that are nearly at the same place are joined.

#include <functional>
#include <string>

#include "core/document/document.hpp"
#include "core/exchange/repair/clean_part.hpp"
#include "ui/widgets/prompt.hpp"

namespace hariko {

/// `file`: its name. `unit`: of the lengths in the report. The tolerance is shown and can be changed. One of
/// the two is called, unless the designer closes the question.
Prompt::Request join_request(const Language& language, const std::string& file, const CleanReport& report,
                             Unit unit, std::function<void(const JoinChoice&)> join,
                             std::function<void()> keep);

}  // namespace hariko
