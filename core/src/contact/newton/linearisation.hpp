// The friction law to first order around the present tractions.
#pragma once

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

    explicit Linearisation(std::size_t m) : slips(m), normal(m), tangent_stiffness(m) {}
    // a -> a - (a . n) n
    void project(Field& a) const { project_out(a.x.size(), normal, a); }
};

}  // namespace contactd
