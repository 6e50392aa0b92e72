// Serves pages for monitoring by HTTP: /metrics (Prometheus), /healthz (alive), /readyz (accepts requests).
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace contactd::server {

/// Has its own threads. Serves only these three pages, and cannot change anything.
class HttpListener {
   public:
    struct Pages {
        std::function<std::string()> metrics;
        std::function<std::string()> not_ready;  ///< why not; empty: ready
    };

    /// `address` is HOST:PORT; port 0 selects a free one. Throws Error if it cannot listen there.
    HttpListener(const std::string& address, Pages pages);
    ~HttpListener();

    /// Returns the address with the actual port.
    std::string address() const;

   private:
    struct Server;
    std::unique_ptr<Server> server_;
};

}  // namespace contactd::server
