// Wheels on rails whose profiles are read and smoothed: a step of a simulation comes with the set-up of the step
// before.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <mutex>

#include "contactd/solve_wheel_rail.hpp"

namespace contactd::engine {

/// The least recently used go first. Thread-safe; contacts are shared between solves.
class PreparedContacts {
   public:
    explicit PreparedContacts(InfluenceSource source) : source_(std::move(source)) {}

    using Contact = std::shared_ptr<const WheelRailContact>;
    /// The contact of an equal set-up, from memory or made now. Throws as WheelRailContact.
    Contact of(const WheelRailSetup& setup, const Observer& observer = {});

    std::size_t size() const;

   private:
    const InfluenceSource source_;
    mutable std::mutex mutex_;     // guards what follows
    std::list<Contact> contacts_;  // used last first
};

}  // namespace contactd::engine
