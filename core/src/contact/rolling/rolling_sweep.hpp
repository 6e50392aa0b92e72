// Transport of tractions through the contact area, along the way of the particles.
#pragma once

#include <array>
#include <vector>

#include "contact/support/contact_elements.hpp"
#include "rolling.hpp"

namespace contactd {

// The division of the contact area and the reduced Jacobian that goes with it: in slip only the direction of the
// traction is free, normal to it, and turning it meets the stiffness D = |s|/g.
struct Linearisation {
    std::vector<char> slips;
    Field normal;                 // n = p/g in slip, 0 in adhesion: what projects there needs no branch
    std::vector<double> turning;  // D, 0 in adhesion

    explicit Linearisation(std::size_t m) : slips(m), normal(m), turning(m) {}
    // a -> a - (a . n) n
    void project(Field& a) const;
};

// Solves (T + D/stiffness) z = r, T p = p(x) - p(x + step): backwards from the leading edges, element by element; p
// between the centres by bilinear interpolation, and zero outside contact.
class RollingSweep {
   public:
    // `stiffness` of each element in contact.
    RollingSweep(const Grid& grid, double step_x, double step_y, const Contact& contact, std::vector<double> stiffness);

    void linearise(const Linearisation& linearisation);
    // z and r may be the same.
    void solve(const Field& r, Field& z) const;
    double diagonal() const { return diagonal_; }  // of T

   private:
    struct Link {
        std::size_t element;  // ahead; the number of elements when that is outside contact
        double weight;
    };

    std::size_t m_;
    double diagonal_ = 1;
    std::vector<std::size_t> order_;
    std::size_t links_ = 0;    // per element
    std::vector<Link> ahead_;  // shape [m, links_], in the order of the sweep
    const Linearisation* linearisation_ = nullptr;
    std::vector<double> stiffness_, diagonal_stiffness_;  // the latter times the diagonal of T
    std::vector<double> inverse_diagonal_;
    mutable Field z_;  // with one zero behind its end
};

}  // namespace contactd
