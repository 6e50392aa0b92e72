// Reports the daemon's state to systemd (sd_notify), where it asked for that.
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
    /// `within` is how long the end may take: systemd waits that much longer.
    void stopping(const std::string& status, std::chrono::seconds within) const;
    void alive() const;

    /// How often alive() must be called; zero when nobody watches.
    std::chrono::milliseconds interval() const { return interval_; }

   private:
    std::chrono::milliseconds interval_{0};
};

}  // namespace contactd::server
