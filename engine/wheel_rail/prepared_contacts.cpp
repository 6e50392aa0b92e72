#include "prepared_contacts.hpp"

#include <algorithm>

namespace contactd::engine {
namespace {

constexpr std::size_t most_cached = 32;  // 32 wheels of up to 2 MB each, by the limit of points

}  // namespace

PreparedContacts::Contact PreparedContacts::of(const WheelRailSetup& setup, const Observer& observer) {
    {
        const std::scoped_lock lock(mutex_);
        const auto found =
            std::ranges::find_if(contacts_, [&](const Contact& contact) { return contact->setup() == setup; });
        if (found != contacts_.end()) {
            contacts_.splice(contacts_.begin(), contacts_, found);
            return contacts_.front();
        }
    }
    auto made = std::make_shared<const WheelRailContact>(setup, source_, observer);  // Two steps may create the same.
    const std::scoped_lock lock(mutex_);
    contacts_.push_front(made);
    if (contacts_.size() > most_cached) contacts_.pop_back();
    return made;
}

std::size_t PreparedContacts::size() const {
    const std::scoped_lock lock(mutex_);
    return contacts_.size();
}

}  // namespace contactd::engine
