// Warnings of answers.
#pragma once

#include <string>
#include <vector>

#include "contactd/proto/answer_text.hpp"

namespace contactd::client {

/// Returns all warnings of the answer to a method, each once. Warnings of a part of the request, such as one of many
/// problems, begin with that part: "problems[3]: ...".
std::vector<std::string> warnings_in(const std::string& method, const proto::AnswerValue& answer);

}  // namespace contactd::client
