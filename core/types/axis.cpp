#include "contactd/axis.hpp"

namespace contactd {

Parity parity(Axis displacement, Axis load) {
    const auto involves = [&](Axis axis) { return (displacement == axis) != (load == axis); };
    return {involves(Axis::x) ? -1 : 1, involves(Axis::y) ? -1 : 1};
}

}  // namespace contactd
