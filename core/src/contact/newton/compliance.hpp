// The bodies as Newton's method on the friction law sees them: slip for tractions, and about the inverse of that.
#pragma once

#include <string_view>
#include <vector>

#include "linearisation.hpp"

namespace contactd {

// K of the slip s = w + K p, on the elements in contact: A of shifts and steps of a transient, C of steady rolling.
class Compliance {
   public:
    virtual ~Compliance() = default;
    // u = K p
    virtual void apply(const Field& p, Field& u) = 0;
    // Returns the displacement by a traction on an element there (mm^3/N), > 0.
    virtual const std::vector<double>& self() const = 0;

    // The law has changed: precondition() is for this one now, which outlives the next call.
    virtual void linearise(const Linearisation& law) = 0;
    enum class Residual { first, later };  // of a solve: the first is smooth up to the edges
    // z ~ J^-1 r with the reduced Jacobian J = P (K + D); r is projected, and so is z. Some get better when what they
    // do changes from iteration to iteration.
    virtual void precondition(const Field& r, Field& z, Residual kind, int iteration) = 0;

    // Whether a traction slips far from where it acts, too, so that to move some of them spoils the slip of all.
    virtual bool is_far_reaching() const = 0;

    // Progress is told under this name.
    virtual std::string_view stage() const = 0;
};

}  // namespace contactd
