// Warnings of answers.
#pragma once

#include <string>
#include <vector>

#include "contactd/proto/answer_text.hpp"

namespace contactd::client {

/// All sentences that the answer to a method warns of, each once; of a part of the request, as one of many problems,
/// with that part before it: "problems[3]: ...".
std::vector<std::string> warnings_in(const std::string& method, const proto::AnswerValue& answer);

}  // namespace contactd::client
