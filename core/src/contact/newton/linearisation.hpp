// Linearises the friction law at the present tractions.
#pragma once

#include <optional>
#include <vector>

#include "contact/support/contact_elements.hpp"
#include "contact/support/traction_loops.hpp"

namespace contactd {

// Holds the division of the contact area and its reduced Jacobian. In slip, only the direction of the traction is free,
// normal to it, and that direction has the tangent stiffness D = |s|/g.
struct Linearisation {
    std::vector<char> slips;
    Field normal;                           // n = p/g in slip, 0 in adhesion, so that projections need no branch
    std::vector<double> tangent_stiffness;  // D along the direction of slip; 0 in adhesion

    // Describes elements where a layer flows, in which both components of the traction are free. Across its direction
    // the stiffness D is as in slip. Along it, the row of the Jacobian is unit (1 + slope K) T, where T is the
    // difference of a traction from the one that it follows.
    struct Flow {
        Field direction;                  // p/|p| of elements that flow, 0 elsewhere
        std::vector<double> slope, unit;  // slope of the yield stress over the flow (N/mm^3); slip per traction
        std::vector<char> follows;        // whether it follows the incoming yield stress, not the least one

        explicit Flow(std::size_t m) : direction(m), slope(m), unit(m), follows(m) {}
    };
    std::optional<Flow> flow{};

    explicit Linearisation(std::size_t m) : slips(m), normal(m), tangent_stiffness(m) {}
    // Changes a to a - (a . n) n.
    void project(Field& a) const { project_out(a.x.size(), normal, a); }
    // Converts slip to the rows of the Jacobian.
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
