#include "http_listener.hpp"

#include <CivetServer.h>

#include <utility>
#include <vector>

#include "contactd/error.hpp"

namespace contactd::server {
namespace {

struct Page {
    int status;
    std::string text;
};

/// Handles GET and HEAD of one path.
class PageHandler final : public CivetHandler {
   public:
    PageHandler(const char* type, std::function<Page()> make) : type_(type), make_(std::move(make)) {}

    bool handleGet(CivetServer*, mg_connection* connection) override { return answer(connection, true); }
    bool handleHead(CivetServer*, mg_connection* connection) override { return answer(connection, false); }

   private:
    bool answer(mg_connection* connection, bool with_text) {
        Page page;
        try {
            page = make_();
        } catch (const std::exception& error) {
            page = {500, std::string(error.what()) + "\n"};
        }
        mg_printf(connection,
                  "HTTP/1.1 %d %s\r\nContent-Type: %s\r\nContent-Length: %zu\r\nCache-Control: no-store\r\n"
                  "Connection: close\r\n\r\n",
                  page.status, mg_get_response_code_text(connection, page.status), type_, page.text.size());
        if (with_text) mg_write(connection, page.text.data(), page.text.size());
        return true;
    }

    const char* const type_;
    const std::function<Page()> make_;
};

constexpr const char* plain = "text/plain; charset=utf-8";

/// Serves no documents and no scripts, only the handlers. A connection occupies a thread even while it is idle, so
/// there are as many threads as idle connections are allowed. A connection without data for `request_timeout_ms` is
/// closed. A waiting thread costs little more than its 8 KiB for a request.
std::vector<std::string> options_for(const std::string& address) {
    return {"listening_ports",   address, "num_threads",       "256",  "request_timeout_ms", "2000",
            "enable_keep_alive", "no",    "linger_timeout_ms", "1000", "max_request_size",   "8192"};
}

}  // namespace

struct HttpListener::Server {
    Server(const std::string& address, Pages pages)
        : metrics("text/plain; version=0.0.4; charset=utf-8", [make = pages.metrics] { return Page{200, make()}; }),
          health(plain, [] { return Page{200, "alive\n"}; }),
          readiness(plain,
                    [why_not = pages.not_ready] {
                        const std::string why = why_not();
                        return why.empty() ? Page{200, "ready\n"} : Page{503, why + "\n"};
                    }),
          civet(options_for(address)),
          host(address.substr(0, address.rfind(':'))) {
        civet.addHandler("/metrics$", metrics);
        civet.addHandler("/healthz$", health);
        civet.addHandler("/readyz$", readiness);
    }

    PageHandler metrics, health, readiness;
    CivetServer civet;  // Must end its threads before the handlers are destroyed.
    const std::string host;
};

HttpListener::HttpListener(const std::string& address, Pages pages) {
    try {
        server_ = std::make_unique<Server>(address, std::move(pages));
    } catch (const CivetException&) {
        throw Error("http.address is \"" + address +
                    "\"; contactd cannot listen there: the address is in use, or does not belong to this machine.");
    }
}

HttpListener::~HttpListener() = default;

std::string HttpListener::address() const {
    const std::vector<int> ports = server_->civet.getListeningPorts();
    return server_->host + ":" + std::to_string(ports.empty() ? 0 : ports.front());
}

}  // namespace contactd::server
