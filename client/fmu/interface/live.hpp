// Records the valid pointers of importers. Freed and foreign pointers are detected, so that a second free, or a later
// use, is refused instead of crashing the importer.
#pragma once

#include <memory>
#include <mutex>
#include <unordered_set>

namespace contactd::fmu {

/// Thread-safe. Objects that are never freed remain, as importers expect that end without freeing them.
template <class Object>
class Live {
   public:
    static Live& all() {
        static Live objects;
        return objects;
    }

    Object* add(std::unique_ptr<Object> object) {
        const std::lock_guard lock(mutex_);
        objects_.insert(object.get());
        return object.release();
    }
    /// Returns null for an invalid pointer.
    Object* find(void* pointer) {
        const std::lock_guard lock(mutex_);
        auto* const object = static_cast<Object*>(pointer);
        return objects_.contains(object) ? object : nullptr;
    }
    std::unique_ptr<Object> take(void* pointer) {
        const std::lock_guard lock(mutex_);
        auto* const object = static_cast<Object*>(pointer);
        return std::unique_ptr<Object>(objects_.erase(object) > 0 ? object : nullptr);
    }

   private:
    std::mutex mutex_;
    std::unordered_set<Object*> objects_;
};

}  // namespace contactd::fmu
