// Importers hold pointers to these. One that was given back, or never came from here, is told apart from those that
// live, so that freeing it twice, or using it afterwards, is refused instead of ending the importer.
#pragma once

#include <memory>
#include <mutex>
#include <unordered_set>

namespace contactd::fmu {

/// Thread-safe. What is never given back stays, as importers that end without it expect.
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
    /// Null for a pointer that is none of these.
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
