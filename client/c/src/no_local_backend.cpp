// libcontactd has no solver, and so does not depend on the licences of solvers.
#include "backend.hpp"
#include "contactd/status.hpp"

namespace contactd::c {

std::unique_ptr<Backend> make_local_backend() {
    throw StatusError(StatusCode::unimplemented, "NO_LOCAL",
                      "This library, libcontactd, speaks to daemons only; link libcontactd-local instead "
                      "(-lcontactd-local), which has the same functions and solves in process, too.");
}

bool has_local_backend() {
    return false;
}

}  // namespace contactd::c
