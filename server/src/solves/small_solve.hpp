// Solves that the I/O thread does itself.
#pragma once

#include <cstddef>

#include "contactd/contact_setup.hpp"

namespace contactd::server {

/// Whether a solve by a quick model on that many elements takes about as long as waking a thread: FASTSIM needs 40 us
/// for 625. With forces given it takes some times as long, which the I/O thread can bear when nobody else asks.
inline bool is_small_solve(Model model, std::size_t elements) {
    return model != Model::full && elements <= 1000;
}

}  // namespace contactd::server
