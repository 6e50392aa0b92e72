#include "stress_arrays.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "contactd/subsurface.hpp"

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

void find_invariants(SubsurfaceStress& s) {
    for (auto* values : {&s.hydrostatic, &s.principal_1, &s.principal_2, &s.principal_3, &s.tresca})
        values->resize(s.xx.size());
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    for (std::size_t i = 0; i < s.xx.size(); ++i) {
        Eigen::Matrix3d tensor;
        tensor << s.xx[i], s.xy[i], s.xz[i], s.xy[i], s.yy[i], s.yz[i], s.xz[i], s.yz[i], s.zz[i];
        const Eigen::Vector3d principal = solver.compute(tensor, Eigen::EigenvaluesOnly).eigenvalues();  // ascending
        s.hydrostatic[i] = tensor.trace() / 3;
        s.principal_1[i] = principal[2];
        s.principal_2[i] = principal[1];
        s.principal_3[i] = principal[0];
        s.tresca[i] = principal[2] - principal[0];
    }
}

}  // namespace contactd
