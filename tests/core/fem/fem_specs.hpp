// Creates specs of the finite-element tests.
#pragma once

#include <algorithm>

#include "contactd/ic_spec.hpp"

namespace contactd {

/// Returns the steel of the paper's section 3 on 10 x 10 elements of 0.8 mm, in a block of size L (mm).
inline IcSpec paper_spec(const char* preset, double L) {
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.8;
    spec.nx = spec.ny = 10;
    spec.source = IcSource::fem;
    spec.fem = fem_preset(preset).value();
    spec.fem.L_over_h = L / 0.8;
    return spec;
}

/// Returns a coarse spec that takes a fraction of a second.
inline IcSpec coarse_spec(int nx, int ny, double dx, double dy) {
    IcSpec spec = paper_spec("paper-test2", 64);
    spec.dx = dx;
    spec.dy = dy;
    spec.nx = nx;
    spec.ny = ny;
    spec.fem.h_over_hs = 2;
    spec.fem.L_over_h = 40;
    return spec;
}

}  // namespace contactd
