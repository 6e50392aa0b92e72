// Influence operators of pairs of bodies: their transforms are worth keeping between the steps of a simulation.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "contactd/contact.hpp"
#include "contactd/solve_contact.hpp"
#include "least_recently_used.hpp"

namespace contactd::engine {

/// The least recently used go first when the budget is full. Thread-safe; operators are shared between solves.
class InfluenceCache {
   public:
    explicit InfluenceCache(std::size_t budget_bytes) : influences_(budget_bytes) {}

    using Make = std::function<ContactInfluence()>;
    /// The operators that `key` stands for, from memory or made by `make`; what is larger than the budget is not kept.
    ContactInfluence of(const std::string& key, const Make& make);

    using Usage = LeastRecentlyUsed<ContactInfluence>::Usage;
    Usage usage() const { return influences_.usage(); }

   private:
    LeastRecentlyUsed<ContactInfluence> influences_;
};

/// Says everything that the operators of a problem depend on; `keys` are those of the bodies' tables, without material
/// where they are dimensionless or of a family.
std::string influence_key(const ContactProblem& problem, const std::string& upper_key, const std::string& lower_key);

}  // namespace contactd::engine
