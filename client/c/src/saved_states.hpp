// The states that a handle has saved, by the numbers that contactd_save gives them.
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
    /// Throws StatusError (NOT_FOUND) where there is none of that number.
    const Saved& at(std::int32_t state) const {
        const auto found = states_.find(state);
        if (found != states_.end()) return found->second;
        throw StatusError(Status{StatusCode::not_found,
                                 "The handle has no state " + std::to_string(state) +
                                     "; contactd_save names those there are, until contactd_forget.",
                                 std::string(reason::state_unknown),
                                 {{"state", "is none"}},
                                 0});
    }
    void forget(std::int32_t state) { states_.erase(state); }
    /// None is left; their numbers are not given again.
    void clear() { states_.clear(); }

   private:
    std::map<std::int32_t, Saved> states_;
    std::int32_t given_ = 0;
};

}  // namespace contactd::c
