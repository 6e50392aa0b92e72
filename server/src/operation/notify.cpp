#include "notify.hpp"

#include <systemd/sd-daemon.h>
#include <time.h>

#include <cstdint>

namespace contactd::server {
namespace {

/// Returns the time by which systemd distinguishes a reload from an earlier one.
std::int64_t monotonic_microseconds() {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1'000'000LL + now.tv_nsec / 1000;
}

void notify(const std::string& state) {
    ::sd_notify(0, state.c_str());
}

}  // namespace

Notifier::Notifier() {
    std::uint64_t microseconds = 0;
    if (::sd_watchdog_enabled(0, &microseconds) > 0)
        interval_ = std::chrono::milliseconds(microseconds / 1000 / 3);  // allows three notifications within the time
}

void Notifier::ready(const std::string& status) const {
    notify("READY=1\nSTATUS=" + status);
}

void Notifier::reloading() const {
    notify("RELOADING=1\nMONOTONIC_USEC=" + std::to_string(monotonic_microseconds()));
}

void Notifier::stopping(const std::string& status, std::chrono::seconds within) const {
    notify("STOPPING=1\nSTATUS=" + status + "\nEXTEND_TIMEOUT_USEC=" + std::to_string(within.count() * 1'000'000));
}

void Notifier::alive() const {
    if (interval_.count() > 0) notify("WATCHDOG=1");
}

}  // namespace contactd::server
