// Pages that monitoring reads by HTTP: /metrics (Prometheus), /healthz (alive), /readyz (takes requests).
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace contactd::server {

/// Has threads of its own; nothing but these three pages is answered, and nothing can be changed through it.
class HttpListener {
   public:
    struct Pages {
        std::function<std::string()> metrics;
        std::function<std::string()> not_ready;  ///< why not; empty: ready
    };

    /// `address` is HOST:PORT, port 0 taking a free one. Throws Error when it cannot be listened at.
    HttpListener(const std::string& address, Pages pages);
    ~HttpListener();

    /// With the port that was taken.
    std::string address() const;

   private:
    struct Server;
    std::unique_ptr<Server> server_;
};

}  // namespace contactd::server
