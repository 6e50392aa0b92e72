// Exit statuses of contactd-ic; 128 + n if signal n ended it.
#pragma once

namespace contactd::ic {

enum ExitCode { success = 0, failure = 1, bad_input = 2, not_converged = 3, out_of_memory = 4 };

}  // namespace contactd::ic
