// Solves that the I/O thread does itself.
#pragma once

#include <cstddef>

#include "contactd/contact_setup.hpp"

namespace contactd::server {

/// Whether a simplified model solves that many elements in about the time of waking a thread: FASTSIM needs 40 us
/// for 625. With forces given it takes some times as long, which the I/O thread can bear when nobody else asks.
inline bool is_small_solve(Model model, std::size_t elements) {
    return model != Model::full && elements <= 1000;
}

}  // namespace contactd::server
