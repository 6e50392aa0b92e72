// Handles are numbers, not addresses. Each number is used once, so that freed and invalid handles are detected and
// never dereferenced.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <unordered_map>

#include "failure.hpp"

namespace contactd::c {

inline StatusError not_a_handle(const char* field, const void* handle) {
    const std::string problem =
        handle == nullptr ? "is NULL" : "is not a valid handle: it was not created, or was already freed";
    return StatusError(Status{StatusCode::invalid_argument,
                              std::string(field) + " " + problem + ".",
                              std::string(no_handle),
                              {{field, problem}},
                              0});
}

/// Holds the live objects of one kind. `Handle` is the incomplete type of the interface.
template <class Object, class Handle>
class Handles {
   public:
    /// `field` is the name of parameters of this kind. Numbers of kind k are k modulo 8, and odd, unlike addresses.
    Handles(const char* field, std::uintptr_t kind) : field_(field), kind_(kind) {}

    Handle* add(std::shared_ptr<Object> object) {
        const std::unique_lock lock(mutex_);
        const std::uintptr_t number = 8 * ++given_ + kind_;
        objects_.emplace(number, std::move(object));
        return reinterpret_cast<Handle*>(number);
    }

    /// Returns the object. Throws StatusError for an invalid handle.
    std::shared_ptr<Object> find(const Handle* handle) const {
        if (auto found = find_any(handle)) return found;
        throw not_a_handle(field_, handle);
    }

    /// Returns the object; null for an invalid handle.
    std::shared_ptr<Object> find_any(const void* handle) const {
        const std::shared_lock lock(mutex_);
        const auto at = objects_.find(reinterpret_cast<std::uintptr_t>(handle));
        return at == objects_.end() ? nullptr : at->second;
    }

    void remove(const Handle* handle) {
        const std::unique_lock lock(mutex_);
        objects_.erase(reinterpret_cast<std::uintptr_t>(handle));
    }

   private:
    const char* field_;
    std::uintptr_t kind_, given_ = 0;
    mutable std::shared_mutex mutex_;
    std::unordered_map<std::uintptr_t, std::shared_ptr<Object>> objects_;
};

}  // namespace contactd::c
