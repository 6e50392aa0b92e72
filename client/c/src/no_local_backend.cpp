// libcontactd has no solver, and so does not depend on the licences of solvers.
#include "backend.hpp"
#include "contactd/status.hpp"
#include "creep_tables.hpp"

namespace contactd::c {

std::unique_ptr<Backend> make_local_backend() {
    throw StatusError(StatusCode::unimplemented, "NO_LOCAL",
                      "This library, libcontactd, connects to daemons only. To solve in process, link "
                      "libcontactd-local (-lcontactd-local), which has the same functions.");
}

bool has_local_backend() {
    return false;
}

std::unique_ptr<const OpenCreepTable> open_creep_table(const std::filesystem::path&, double) {
    throw StatusError(StatusCode::unimplemented, "NO_LOCAL",
                      "This library, libcontactd, connects to daemons only. To evaluate tables of creep forces, link "
                      "libcontactd-local (-lcontactd-local), which has the same functions.");
}

}  // namespace contactd::c
