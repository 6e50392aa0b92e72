// Transport of tractions through the contact area, along the way of the particles.
#pragma once

#include <array>
#include <vector>

#include "contact/newton/linearisation.hpp"
#include "contact/support/contact_elements.hpp"
#include "rolling.hpp"

namespace contactd {

// Solves (T + D/stiffness) z = r, T p = p(x) - p(x + step): backwards from the leading edges, element by element; p
// between the centres by bilinear interpolation, and zero outside contact.
class RollingSweep {
   public:
    // `stiffness` of each element in contact.
    RollingSweep(const Grid& grid, double step_x, double step_y, const Contact& contact, std::vector<double> stiffness);

    void linearise(const Linearisation& linearisation);
    // z and r may be the same.
    void solve(const Field& r, Field& z) const { solve(r, z, m_); }
    // Solves for the first `count` elements of the sweep; those behind get anything.
    void solve(const Field& r, Field& z, std::size_t count) const;
    // Up to the last element that adheres.
    void solve_adhesion(const Field& r, Field& z) const { solve(r, z, to_adhesion_); }
    // How many elements the sweep takes up to the last one that is wanted.
    template <class Predicate>
    std::size_t up_to_last(const Predicate& is_counted) const {
        std::size_t count = m_;
        while (count > 0 && !is_counted(order_[count - 1])) --count;
        return count;
    }
    double diagonal() const { return diagonal_; }  // of T

   private:
    struct Link {
        std::size_t element;  // ahead; the number of elements when that is outside contact
        double weight;
    };

    std::size_t m_;
    double diagonal_ = 1;
    std::vector<std::size_t> order_;
    std::size_t to_adhesion_ = 0;  // of the order, up to the last element that adheres
    std::size_t links_ = 0;        // per element
    std::vector<Link> ahead_;      // shape [m, links_], in the order of the sweep
    const Linearisation* linearisation_ = nullptr;
    std::vector<double> stiffness_, diagonal_stiffness_;  // the latter times the diagonal of T
    std::vector<double> inverse_diagonal_;
    mutable Field z_;  // with one zero behind its end
};

}  // namespace contactd
