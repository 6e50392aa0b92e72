// Keeps influence operators of pairs of bodies between the steps of a simulation, because their transforms are
// expensive.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/solve_contact.hpp"
#include "contactd/solve_reply.hpp"
#include "least_recently_used.hpp"

namespace contactd::engine {

/// Holds operators, and the use of those beyond the budget.
struct CachedInfluence {
    ContactInfluence influence{};
    std::optional<OperatorUse> use{};
};

/// Warns of operators beyond the budget.
std::string operator_warning(const OperatorUse& use);
/// Returns the warning for operators that were computed and may have to be recomputed, or an empty text.
std::vector<std::string> operator_warnings(const std::optional<OperatorUse>& use);

/// If the budget is full, the least recently used operators are removed first. In addition, the operators beyond the
/// budget that were used last are cached, and their use is reported, so a repeated problem always finds its operators.
/// Thread-safe; operators are shared between solves.
class InfluenceCache {
   public:
    explicit InfluenceCache(std::size_t budget_bytes) : budget_(budget_bytes), influences_(budget_bytes) {}

    using Make = std::function<ContactInfluence()>;
    /// Returns the operators of `key`, from memory or made by `make`.
    CachedInfluence of(const std::string& key, const Make& make);

    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::seconds longest_unused{60};
    /// Removes operators beyond the budget that no solve and no session has used for longest_unused. Returns the time
    /// of the next call.
    Clock::time_point forget_unused(Clock::time_point now);

    using Usage = LeastRecentlyUsed<ContactInfluence>::Usage;
    Usage usage() const;  ///< with those beyond the budget

   private:
    struct Beyond {
        std::string key;
        CachedInfluence cached;
        Clock::time_point used;
    };
    std::optional<CachedInfluence> found_beyond(const std::string& key);

    const std::size_t budget_;
    LeastRecentlyUsed<ContactInfluence> influences_;
    mutable std::mutex mutex_;  // guards the members below
    std::optional<Beyond> beyond_;
};

/// Returns a key of everything that the operators of a problem depend on. `keys` are those of the bodies' tables,
/// without material if they are dimensionless or belong to a family.
std::string influence_key(const ContactProblem& problem, const std::string& upper_key, const std::string& lower_key);

}  // namespace contactd::engine
