// libcontactd has no solver, and so does not depend on the licences of solvers.
#include "backend.hpp"
#include "contactd/status.hpp"

namespace contactd::c {

std::unique_ptr<Backend> make_local_backend() {
    throw StatusError(StatusCode::unimplemented, "NO_LOCAL",
                      "This library, libcontactd, connects to daemons only. To solve in process, link "
                      "libcontactd-local (-lcontactd-local), which has the same functions.");
}

bool has_local_backend() {
    return false;
}

}  // namespace contactd::c
