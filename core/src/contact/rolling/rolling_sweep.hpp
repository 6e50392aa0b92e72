// Transport of tractions through the contact area, along the way of the particles.
#pragma once

#include <vector>

#include "contact/newton/linearisation.hpp"
#include "contact/support/contact_elements.hpp"
#include "operators/upstream.hpp"
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
        while (count > 0 && !is_counted(upstream_.order()[count - 1])) --count;
        return count;
    }
    double diagonal() const { return upstream_.diagonal(); }  // of T

   private:
    // One with a flow law, and one without.
    template <bool flows>
    void sweep(const Field& r, std::size_t count) const;

    std::size_t m_;
    Upstream upstream_;
    std::size_t to_adhesion_ = 0;  // of the order, up to the last element that adheres
    const Linearisation* linearisation_ = nullptr;
    std::vector<double> stiffness_, diagonal_stiffness_;  // the latter times the diagonal of T
    std::vector<double> inverse_diagonal_;
    std::vector<double> along_flow_;  // what the direction of flow has in place of that
    mutable Field z_;                 // with one zero behind its end
};

}  // namespace contactd
