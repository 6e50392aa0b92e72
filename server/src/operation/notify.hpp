// Reports the daemon's state to systemd (sd_notify), if requested.
#pragma once

#include <chrono>
#include <string>

namespace contactd::server {

class Notifier {
   public:
    /// Reads NOTIFY_SOCKET and WATCHDOG_USEC, which systemd sets.
    Notifier();

    void ready(const std::string& status) const;
    void reloading() const;
    /// `within` is the longest time of the shutdown, by which systemd extends its wait.
    void stopping(const std::string& status, std::chrono::seconds within) const;
    void alive() const;

    /// Returns the interval of calls of alive(), or zero without a watchdog.
    std::chrono::milliseconds interval() const { return interval_; }

   private:
    std::chrono::milliseconds interval_{0};
};

}  // namespace contactd::server
