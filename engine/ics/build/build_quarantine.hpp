// Manages tables whose builds failed repeatedly. Requests get the last failure immediately, until the quarantine ends.
#pragma once

#include <chrono>
#include <cstddef>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "contactd/ic_spec.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::engine {

/// Thread-safe. Kept in memory, so a restarted daemon tries again.
class BuildQuarantine {
   public:
    using Clock = std::chrono::steady_clock;
    struct Settings {
        int failures = 2;                  ///< failures before a quarantine; 0: none
        std::chrono::seconds lasts{3600};  ///< from the last failure
        std::size_t most_entries = 1024;   ///< the oldest goes
    };
    struct Entry {
        std::string key;
        int nx = 0, ny = 0;
        int max_iterations = 0;  ///< is not part of the key, but a larger bound may help
        int failures = 0;
        proto::Status last;
        Clock::time_point until;
    };

    explicit BuildQuarantine(const Settings& settings) : settings_(settings) {}

    void note_failure(const std::string& key, const IcSpec& spec, const proto::Status& status);
    /// Forgets the failures of tables that a built table covers.
    void note_success(const std::string& key, const IcSpec& spec);
    /// Returns the answer to a request for this table if its build, or that of a smaller one, failed too often.
    std::optional<proto::Status> refusal(const std::string& key, const IcSpec& spec);
    /// Forgets the failures of a key. Returns whether there were any.
    bool forget(const std::string& key);
    /// Returns the tables in quarantine, the latest first.
    std::vector<Entry> entries();

   private:
    void forget_old();
    bool is_quarantined(const Entry& entry) const {
        return settings_.failures > 0 && entry.failures >= settings_.failures;
    }

    const Settings settings_;
    std::mutex mutex_;
    std::list<Entry> entries_;  // the latest first
};

}  // namespace contactd::engine
