#include "stress_arrays.hpp"

#include <algorithm>
#include <cmath>

namespace contactd {

void find_von_mises(SubsurfaceStress& s) {
    const auto square = [](double a) { return a * a; };
    for (std::size_t i = 0; i < s.xx.size(); ++i)
        s.von_mises[i] =
            std::sqrt(0.5 * (square(s.xx[i] - s.yy[i]) + square(s.yy[i] - s.zz[i]) + square(s.zz[i] - s.xx[i])) +
                      3 * (square(s.xy[i]) + square(s.xz[i]) + square(s.yz[i])));
    s.largest =
        static_cast<std::size_t>(std::max_element(s.von_mises.begin(), s.von_mises.end()) - s.von_mises.begin());
}

}  // namespace contactd
