#include "endpoint_rules.hpp"

#include <arpa/inet.h>
#include <net/if.h>
#include <netdb.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "contactd/error.hpp"
#include "socket_file.hpp"

namespace contactd::server {

namespace {

constexpr std::string_view tcp = "tcp://";

/// Returns the numerical addresses of a host in the form of endpoints, or none if the name is unknown.
std::vector<std::string> addresses_of(const std::string& host) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (::getaddrinfo(host.c_str(), nullptr, &hints, &found) != 0) return {};
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> owner(found, &::freeaddrinfo);
    std::vector<std::string> numbers;
    for (const addrinfo* entry = found; entry != nullptr; entry = entry->ai_next) {
        std::array<char, NI_MAXHOST> number{};
        if (::getnameinfo(entry->ai_addr, entry->ai_addrlen, number.data(), number.size(), nullptr, 0,
                          NI_NUMERICHOST) != 0)
            return {};
        numbers.push_back(entry->ai_family == AF_INET6 ? "[" + std::string(number.data()) + "]" : number.data());
    }
    return numbers;
}

}  // namespace

bool is_local(const std::string& endpoint) {
    if (endpoint.starts_with("ipc://")) return true;
    const std::size_t colon = endpoint.rfind(':');
    if (!endpoint.starts_with(tcp) || colon < tcp.size()) return false;
    const std::string host = endpoint.substr(tcp.size(), colon - tcp.size());
    if (host == "[::1]") return true;
    // Accepts four decimal numbers only, without other notations that a resolver would interpret.
    in_addr address{};
    return ::inet_pton(AF_INET, host.c_str(), &address) == 1 && (ntohl(address.s_addr) >> 24u) == 127u;
}

std::string with_loopback_number(const std::string& endpoint) {
    const std::size_t colon = endpoint.rfind(':');
    if (!endpoint.starts_with(tcp) || colon < tcp.size()) return endpoint;
    const std::string host = endpoint.substr(tcp.size(), colon - tcp.size());
    // Numbers in unusual notations and names of interfaces are not names of hosts, so no resolver is asked.
    if (host.empty() || std::isalpha(static_cast<unsigned char>(host.front())) == 0 ||
        ::if_nametoindex(host.c_str()) != 0)
        return endpoint;
    const std::vector<std::string> numbers = addresses_of(host);
    const auto in_endpoint = [&](const std::string& number) { return "tcp://" + number + endpoint.substr(colon); };
    const auto reaches_nobody = [&](const std::string& number) { return is_local(in_endpoint(number)); };
    if (numbers.empty() || !std::all_of(numbers.begin(), numbers.end(), reaches_nobody)) return endpoint;
    // Prefers IPv4, which clients with the name try first.
    return in_endpoint(*std::min_element(numbers.begin(), numbers.end(), [](const auto& a, const auto& b) {
        return !a.starts_with('[') && b.starts_with('[');
    }));
}

void check_endpoint(const Config& config) {
    const auto& curve = config.security.curve;
    if (curve.secret_key_file.empty() != curve.allowed_keys.empty())
        throw Error(std::string("security.curve.") +
                    (curve.allowed_keys.empty() ? "allowed_keys is empty although secret_key_file"
                                                : "secret_key_file is empty although allowed_keys") +
                    " is given; give both for CURVE, or neither for connections without encryption.");
    if (is_local(config.endpoint) || !curve.secret_key_file.empty() || config.security.allow_unencrypted_remote) return;
    throw Error("endpoint is \"" + config.endpoint +
                "\", which other machines may reach; configure security.curve to admit known keys only "
                "(docs/security.md), or listen at ipc://PATH, tcp://127.0.0.1:PORT or tcp://[::1]:PORT. To admit "
                "everyone who can reach it, set security.allow_unencrypted_remote.");
}

void check_log_file(const Config& config) {
    namespace fs = std::filesystem;
    if (config.log.file.empty()) return;
    const auto whole = [](const fs::path& path) {
        std::error_code error;
        const fs::path resolved = fs::weakly_canonical(fs::absolute(path, error), error);
        return error ? path : resolved;
    };
    const fs::path file = whole(config.log.file);
    const auto refuse = [&](const char* field, const fs::path& path, const char* relation) {
        if (path.empty()) return;
        const fs::path taken = whole(path);
        // `taken` is a prefix of `file`: the same path, or a folder of it.
        if (std::mismatch(taken.begin(), taken.end(), file.begin(), file.end()).first != taken.end()) return;
        throw Error("log.file is " + config.log.file.string() + ", which " + relation + " " + field + ", " +
                    path.string() + "; choose a file elsewhere.");
    };
    refuse("store.folder", config.store.folder, "lies in");
    refuse("security.curve.allowed_keys", config.security.curve.allowed_keys, "lies in");
    refuse("security.curve.secret_key_file", config.security.curve.secret_key_file, "is");
    refuse("builds.program", config.builds.program, "is");
    refuse("endpoint", socket_file(config.endpoint), "is the socket of");
}

}  // namespace contactd::server
