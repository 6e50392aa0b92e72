// Keeps wheels on rails with prepared profiles, because a step of a simulation usually has the set-up of the previous
// one.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <mutex>

#include "contactd/solve_wheel_rail.hpp"

namespace contactd::engine {

/// Removes the least recently used first. Thread-safe; contacts are shared between solves.
class PreparedContacts {
   public:
    explicit PreparedContacts(InfluenceSource source) : source_(std::move(source)) {}

    using Contact = std::shared_ptr<const WheelRailContact>;
    /// Returns the contact of an equal set-up, from memory or newly prepared. Throws as WheelRailContact.
    Contact of(const WheelRailSetup& setup, const Observer& observer = {});

    std::size_t size() const;

   private:
    const InfluenceSource source_;
    mutable std::mutex mutex_;     // guards the members below
    std::list<Contact> contacts_;  // used last first
};

}  // namespace contactd::engine
