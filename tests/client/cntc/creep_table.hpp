// A table of forces against creepage for simulations: 5 ellipses, 4 spins, 7 directions and 23 sizes of creepage, on
// elements of which 7 x 7 divide the box of the ellipse. In numbers without dimension: G = 1, Fn = 1, curvature a1 = 1.
#pragma once

#include <array>
#include <numbers>

#include "client/cntc/calls.hpp"

namespace contactd::cntc::test {

struct CreepCase {
    std::size_t ellipse, spin, direction, size;
};

/// Forces over mu Fn, moment over mu Fn c, per cent of the elements that slip.
struct CreepLine {
    int error = 0;
    double fx = 0, fy = 0, mz = 0, slip = 0;
};

class CreepTable {
   public:
    static constexpr std::array ratios{0.2, 0.5, 1.0, 2.0, 5.0};
    static constexpr std::array c{0.9063561, 0.7580279, 0.6463304, 0.5351031, 0.3978158};  // sqrt(ab)
    static constexpr std::array rho{1.844071, 1.479543, 1.0, 0.5204566, 0.1559291};        // 2/(a1 + b1)
    static constexpr std::array spins{0.0, 0.5, 1.0, 2.0};
    static constexpr std::size_t directions = 7;  // from -90 to 90 degrees
    static constexpr std::array sizes{0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 0.9, 1.1, 1.4, 1.7, 2.0,
                                      2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10., 12.};
    static constexpr double mu = 0.3, nu = 0.28;
    static constexpr int elements = 11;

    explicit CreepTable(int ire) : contact_(ire) {
        contact_.material(nu, nu, 1, 1);
        contact_.coulomb(mu);
        contact_.velocity(30000);
        contact_.normal_force(1);
        contact_.tolerance(1e-6);
    }

    static Creepages creepages(const CreepCase& k) {
        const double angle = (static_cast<double>(k.direction) - 3) * std::numbers::pi / 6;
        const double size = sizes[k.size] * mu * c[k.ellipse] / rho[k.ellipse];
        return {size * std::cos(angle), size * std::sin(angle), mu * spins[k.spin] / rho[k.ellipse]};
    }

    CreepLine solve(const CreepCase& k) {
        contact_.hertz(-2, {elements, elements, 1, ratios[k.ellipse], elements / double{elements - 4}});
        const Creepages given = creepages(k);
        contact_.creepages(given.vx, given.vy, given.phi);
        CreepLine line{contact_.calculate()};
        const ContactForces f = contact_.forces();
        const PatchAreas areas = contact_.areas();
        line.fx = f.fx / (mu * f.fn);
        line.fy = f.fy / (mu * f.fn);
        line.mz = f.mz / (mu * f.fn * c[k.ellipse]);
        line.slip = 100 * areas.slip / areas.contact;
        return line;
    }

    template <class Visit>
    static void for_each(const Visit& visit) {
        for (std::size_t ellipse = 0; ellipse < ratios.size(); ++ellipse)
            for (std::size_t spin = 0; spin < spins.size(); ++spin)
                for (std::size_t direction = 0; direction < directions; ++direction)
                    for (std::size_t size = 0; size < sizes.size(); ++size)
                        visit(CreepCase{ellipse, spin, direction, size});
    }
    Case& contact() { return contact_; }

   private:
    Case contact_;
};

}  // namespace contactd::cntc::test
