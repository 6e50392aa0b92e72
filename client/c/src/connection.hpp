// Represents a connection: the solver of its contacts, and their settings. Thread-safe.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "backend.hpp"
#include "contactd.h"
#include "failure.hpp"

namespace contactd::c {

/// Holds the log of the user. Until it is set (`is_set`), warnings go to standard error.
struct Log {
    contactd_log function = nullptr;
    void* user = nullptr;
    bool is_set = false;

    explicit operator bool() const { return function != nullptr; }
    void operator()(std::int32_t level, const std::string& text) const {
        if (function != nullptr) function(user, level, text.c_str());
    }
};

class Connection {
   public:
    explicit Connection(std::unique_ptr<const Backend> where) : backend(std::move(where)) {}

    const std::shared_ptr<const Backend> backend;

    template <class Change>
    void change(const Change& change) {
        const std::scoped_lock lock(mutex_);
        change(settings_, log_);
    }
    std::pair<Settings, Log> snapshot() const {
        const std::scoped_lock lock(mutex_);
        return {settings_, log_};
    }

    void keep(const Failure& failure) {
        const std::scoped_lock lock(mutex_);
        last_ = failure;
    }
    Failure last_failure() const {
        const std::scoped_lock lock(mutex_);
        return last_;
    }

   private:
    mutable std::mutex mutex_;
    Settings settings_;
    Log log_;
    Failure last_;
};

}  // namespace contactd::c
