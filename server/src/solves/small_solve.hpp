// Solves that run in the I/O thread.
#pragma once

#include <cstddef>

#include "contactd/contact_setup.hpp"

namespace contactd::server {

/// Returns whether a simplified model solves that many elements in about the time of waking a thread: FASTSIM needs 40
/// us for 625. With prescribed forces it takes several times as long, which is acceptable if no other request is open.
inline bool is_small_solve(Model model, std::size_t elements) {
    return model != Model::full && elements <= 1000;
}

}  // namespace contactd::server
