// Represents the bodies in Newton's method on the friction law: slip for tractions, and an approximate inverse.
#pragma once

#include <string_view>
#include <vector>

#include "linearisation.hpp"

namespace contactd {

// Represents K of the slip s = w + K p on the elements in contact: A for shifts and transient steps, C for steady
// rolling.
class Compliance {
   public:
    virtual ~Compliance() = default;
    // Computes u = K p.
    virtual void apply(const Field& p, Field& u) = 0;
    // Returns the displacement of an element under its own traction (mm^3/N), > 0.
    virtual const std::vector<double>& self() const = 0;

    // Sets the law for precondition(). It must outlive the next call.
    virtual void linearise(const Linearisation& law) = 0;
    enum class Residual { first, later };  // within a solve; the first residual is smooth up to the edges
    // Computes z ~ J^-1 r with the reduced Jacobian J = P (K + D); r is projected, and so is z. Some implementations
    // converge faster if they change from iteration to iteration.
    virtual void precondition(const Field& r, Field& z, Residual kind, int iteration) = 0;

    // Returns whether a traction causes slip far from its element. Moving some tractions then spoils the slip of all.
    virtual bool is_far_reaching() const = 0;

    // Returns the name of the stage in progress reports.
    virtual std::string_view stage() const = 0;
};

}  // namespace contactd
