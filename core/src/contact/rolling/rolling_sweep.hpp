// Transports tractions through the contact area along the paths of particles.
#pragma once

#include <vector>

#include "contact/newton/linearisation.hpp"
#include "contact/support/contact_elements.hpp"
#include "operators/upstream.hpp"
#include "rolling.hpp"

namespace contactd {

// Solves (T + D/stiffness) z = r, T p = p(x) - p(x + step), backwards from the leading edges, element by element. p
// between the centres is interpolated bilinearly, with zero outside the contact.
class RollingSweep {
   public:
    // `stiffness` is that of each element in contact.
    RollingSweep(const Grid& grid, double step_x, double step_y, const Contact& contact, std::vector<double> stiffness);

    void linearise(const Linearisation& linearisation);
    // Solves for all elements; z and r may be the same.
    void solve(const Field& r, Field& z) const { solve(r, z, m_); }
    // Solves for the first `count` elements of the sweep; those behind are undefined.
    void solve(const Field& r, Field& z, std::size_t count) const;
    // Solves up to the last element that adheres.
    void solve_adhesion(const Field& r, Field& z) const { solve(r, z, to_adhesion_); }
    // Returns the number of elements in the sweep up to the last selected one.
    template <class Predicate>
    std::size_t up_to_last(const Predicate& is_counted) const {
        std::size_t count = m_;
        while (count > 0 && !is_counted(upstream_.order()[count - 1])) --count;
        return count;
    }
    double diagonal() const { return upstream_.diagonal(); }  // diagonal of T

   private:
    // Sweeps with or without a flow law.
    template <bool flows>
    void sweep(const Field& r, std::size_t count) const;

    std::size_t m_;
    Upstream upstream_;
    std::size_t to_adhesion_ = 0;  // number of elements up to the last one that adheres
    const Linearisation* linearisation_ = nullptr;
    std::vector<double> stiffness_, diagonal_stiffness_;  // the latter times the diagonal of T
    std::vector<double> inverse_diagonal_;
    std::vector<double> along_flow_;  // diagonal along the direction of flow
    mutable Field z_;                 // with an additional zero at its end
};

}  // namespace contactd
