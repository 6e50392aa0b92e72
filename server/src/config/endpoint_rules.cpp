#include "endpoint_rules.hpp"

#include <arpa/inet.h>

#include <string_view>

#include "contactd/error.hpp"

namespace contactd::server {

bool is_local(const std::string& endpoint) {
    if (endpoint.starts_with("ipc://")) return true;
    constexpr std::string_view tcp = "tcp://";
    const std::size_t colon = endpoint.rfind(':');
    if (!endpoint.starts_with(tcp) || colon < tcp.size()) return false;
    const std::string host = endpoint.substr(tcp.size(), colon - tcp.size());
    if (host == "[::1]") return true;
    // Strict: four decimal numbers, nothing that a resolver would have to make sense of.
    in_addr address{};
    return ::inet_pton(AF_INET, host.c_str(), &address) == 1 && (ntohl(address.s_addr) >> 24u) == 127u;
}

void check_endpoint(const Config& config) {
    const auto& curve = config.security.curve;
    if (curve.secret_key_file.empty() != curve.allowed_keys.empty())
        throw Error(std::string("security.curve.") +
                    (curve.allowed_keys.empty() ? "allowed_keys is empty although secret_key_file"
                                                : "secret_key_file is empty although allowed_keys") +
                    " is given; CURVE needs both, or neither of them for no encryption.");
    if (is_local(config.endpoint) || !curve.secret_key_file.empty() || config.security.allow_unencrypted_remote) return;
    throw Error("endpoint is \"" + config.endpoint +
                "\", which other machines may reach; configure security.curve so that only known keys are let in "
                "(docs/security.md), or listen at ipc://PATH, tcp://127.0.0.1:PORT or tcp://[::1]:PORT. Whoever wants "
                "everybody who reaches it to use it sets security.allow_unencrypted_remote.");
}

}  // namespace contactd::server
