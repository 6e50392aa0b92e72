#include "build_quarantine.hpp"

#include <algorithm>
#include <iterator>

namespace contactd::engine {
namespace {

using Entry = BuildQuarantine::Entry;

/// Returns true if the build of `spec` would fail for the same reason as that of `entry`, because it is at least as
/// demanding.
bool concerns(const Entry& entry, const std::string& key, const IcSpec& spec) {
    return entry.key == key && spec.nx >= entry.nx && spec.ny >= entry.ny &&
           spec.fem.max_iterations <= entry.max_iterations;
}

std::chrono::milliseconds time_left(const Entry& entry) {
    return std::chrono::ceil<std::chrono::milliseconds>(entry.until - BuildQuarantine::Clock::now());
}

}  // namespace

void BuildQuarantine::forget_old() {
    const auto now = Clock::now();
    std::erase_if(entries_, [&](const Entry& entry) { return entry.until <= now; });
}

void BuildQuarantine::note_failure(const std::string& key, const IcSpec& spec, const proto::Status& status) {
    const std::scoped_lock lock(mutex_);
    forget_old();
    auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) {
        return e.key == key && e.nx == spec.nx && e.ny == spec.ny && e.max_iterations == spec.fem.max_iterations;
    });
    if (entry == entries_.end())
        entries_.push_front({key, spec.nx, spec.ny, spec.fem.max_iterations, 0, {}, {}});
    else
        entries_.splice(entries_.begin(), entries_, entry);
    Entry& latest = entries_.front();
    ++latest.failures;
    latest.last = status;
    latest.until = Clock::now() + settings_.lasts;
    if (entries_.size() > settings_.most_entries) entries_.pop_back();
}

void BuildQuarantine::note_success(const std::string& key, const IcSpec& spec) {
    const std::scoped_lock lock(mutex_);
    std::erase_if(entries_, [&](const Entry& e) { return e.key == key && e.nx <= spec.nx && e.ny <= spec.ny; });
}

std::optional<proto::Status> BuildQuarantine::refusal(const std::string& key, const IcSpec& spec) {
    const std::scoped_lock lock(mutex_);
    forget_old();
    const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const Entry& e) { return is_quarantined(e) && concerns(e, key, spec); });
    if (entry == entries_.end()) return std::nullopt;
    const auto left = time_left(*entry);
    return proto::Status{
        proto::StatusCode::failed_precondition,
        "The build of this table failed " + std::to_string(entry->failures) + " times and is not tried again for " +
            std::to_string(std::chrono::ceil<std::chrono::seconds>(left).count()) + " s; call ic.delete with the key " +
            key + " to retry now. The last failure: " + entry->last.message,
        std::string(proto::reason::build_quarantined),
        {},
        static_cast<int>(left.count())};
}

bool BuildQuarantine::forget(const std::string& key) {
    const std::scoped_lock lock(mutex_);
    return std::erase_if(entries_, [&](const Entry& entry) { return entry.key == key; }) > 0;
}

std::vector<Entry> BuildQuarantine::entries() {
    const std::scoped_lock lock(mutex_);
    forget_old();
    std::vector<Entry> quarantined;
    std::copy_if(entries_.begin(), entries_.end(), std::back_inserter(quarantined),
                 [&](const Entry& entry) { return is_quarantined(entry); });
    return quarantined;
}

}  // namespace contactd::engine
