// Replaces the remote backend in a library without ZeroMQ, which solves in process and cannot connect to daemons.
#include "backend.hpp"
#include "contactd/status.hpp"

namespace contactd::c {

std::unique_ptr<Backend> make_remote_backend(const std::string& endpoint) {
    throw StatusError(StatusCode::unimplemented, "NO_REMOTE",
                      "This library solves in process only. It was built without connections to daemons such as " +
                          endpoint + "; open \"local\".");
}

}  // namespace contactd::c
