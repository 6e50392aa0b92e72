// Stores the saved states of a handle, by their numbers from contactd_save.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "failure.hpp"

namespace contactd::c {

template <class Saved>
class SavedStates {
   public:
    std::int32_t add(Saved saved) {
        states_.emplace(++given_, std::move(saved));
        return given_;
    }
    /// Throws StatusError (NOT_FOUND) for an unknown number.
    const Saved& at(std::int32_t state) const {
        const auto found = states_.find(state);
        if (found != states_.end()) return found->second;
        throw StatusError(Status{StatusCode::not_found,
                                 "The handle has no state " + std::to_string(state) +
                                     "; use a number that contactd_save returned and contactd_forget has not removed.",
                                 std::string(reason::state_unknown),
                                 {{"state", "does not exist"}},
                                 0});
    }
    void forget(std::int32_t state) { states_.erase(state); }
    /// Removes all states; their numbers are not used again.
    void clear() { states_.clear(); }

   private:
    std::map<std::int32_t, Saved> states_;
    std::int32_t given_ = 0;
};

}  // namespace contactd::c
