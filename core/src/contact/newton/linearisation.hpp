// The friction law to first order around the present tractions.
#pragma once

#include <optional>
#include <vector>

#include "contact/support/contact_elements.hpp"
#include "contact/support/traction_loops.hpp"

namespace contactd {

// The division of the contact area and the reduced Jacobian that goes with it: in slip only the direction of the
// traction is free, normal to it, and its direction has the tangent stiffness D = |s|/g.
struct Linearisation {
    std::vector<char> slips;
    Field normal;                           // n = p/g in slip, 0 in adhesion: what projects there needs no branch
    std::vector<double> tangent_stiffness;  // D, of the direction of slip; 0 in adhesion

    // Where a layer flows both components of the traction are free. Across its direction the stiffness D is as in slip,
    // along it the row of the Jacobian is unit (1 + slope K) T, T what a traction has over the one that it follows.
    struct Flow {
        Field direction;                  // p/|p| of what flows, elsewhere 0
        std::vector<double> slope, unit;  // of the yield stress over the flow (N/mm^3); length of slip of a traction
        std::vector<char> follows;        // the yield stress that comes to it; else it is the least one

        explicit Flow(std::size_t m) : direction(m), slope(m), unit(m), follows(m) {}
    };
    std::optional<Flow> flow{};

    explicit Linearisation(std::size_t m) : slips(m), normal(m), tangent_stiffness(m) {}
    // a -> a - (a . n) n
    void project(Field& a) const { project_out(a.x.size(), normal, a); }
    // Makes of a slip what stands in the rows of the Jacobian.
    void take_rows(Field& slip) const {
        project(slip);
        if (!flow) return;
        for (std::size_t e = 0; e < slip.x.size(); ++e) {
            const double x = flow->direction.x[e], y = flow->direction.y[e];
            const double more = (flow->unit[e] * flow->slope[e] - 1) * (slip.x[e] * x + slip.y[e] * y);
            slip.x[e] += more * x;
            slip.y[e] += more * y;
        }
    }
};

}  // namespace contactd
