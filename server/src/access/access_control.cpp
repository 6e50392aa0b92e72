#include "access_control.hpp"

#include <spdlog/spdlog.h>

#include <array>
#include <string_view>
#include <vector>
#include <zmq_addon.hpp>

#include "contactd/error.hpp"

namespace contactd::server {
namespace {

constexpr const char* zap_address = "inproc://zeromq.zap.01";
constexpr const char* zap_domain = "contactd";
constexpr int accept_backlog = 1024;
constexpr int keepalive_idle_seconds = 120;

/// Lists frames of a ZAP request; credentials follow if the mechanism has them.
enum Frame : std::size_t { version, request, domain, address, identity, mechanism, credentials };

/// Returns the user of a client without a key, from ZeroMQ's data: the IP address or, over ipc,
/// "localhost:UID:GID:PID".
std::string user_at(std::string_view address) {
    constexpr std::string_view ipc = "localhost:";
    if (!address.starts_with(ipc)) return address.empty() ? "unknown" : std::string(address);
    address.remove_prefix(ipc.size());
    return "uid:" + std::string(address.substr(0, address.find(':')));
}

std::string z85_of(const zmq::message_t& key) {
    std::array<char, 41> text{};
    if (key.size() != 32 || !zmq_z85_encode(text.data(), key.data<std::uint8_t>(), key.size())) return {};
    return text.data();
}

}  // namespace

proto::Status key_revoked() {
    return {proto::StatusCode::unauthenticated,
            "The key of this connection is no longer allowed; ask the administrator of the daemon to allow it.",
            std::string(proto::reason::key_revoked),
            {},
            0};
}

AccessControl::AccessControl(const Config& config, zmq::context_t& context)
    : config_(config), socket_(context, zmq::socket_type::rep) {
    if (encrypted()) {
        secret_key_ = read_secret_key(config.security.curve.secret_key_file);
        read_allowed();
    }
    socket_.set(zmq::sockopt::linger, 0);
    socket_.bind(zap_address);
}

void AccessControl::protect(zmq::socket_t& socket) const {
    // With a domain, ZeroMQ also asks about connections without CURVE, and rejects clients too old for such a question.
    // Otherwise it would take arbitrary bytes for such a client.
    socket.set(zmq::sockopt::zap_domain, zap_domain);
    socket.set(zmq::sockopt::handshake_ivl, 1000 * config_.security.handshake_seconds);
    socket.set(zmq::sockopt::backlog, accept_backlog);
    // Detects machines that disappeared silently, whose connections would otherwise be kept for ever.
    socket.set(zmq::sockopt::tcp_keepalive, 1);
    socket.set(zmq::sockopt::tcp_keepalive_idle, keepalive_idle_seconds);
    if (config_.endpoint.starts_with("tcp://[")) socket.set(zmq::sockopt::ipv6, true);
    if (!encrypted()) return;
    socket.set(zmq::sockopt::curve_server, true);
    socket.set(zmq::sockopt::curve_secretkey, secret_key_);
}

void AccessControl::answer_all() {
    std::vector<zmq::message_t> question;
    while (zmq::recv_multipart(socket_, std::back_inserter(question), zmq::recv_flags::dontwait)) {
        const std::string user = admitted(question);
        const bool yes = !user.empty();
        const std::string_view id = question.size() > request ? question[request].to_string_view() : "";
        const std::array<zmq::const_buffer, 6> answer{
            zmq::str_buffer("1.0"), zmq::buffer(id),   yes ? zmq::str_buffer("200") : zmq::str_buffer("400"),
            zmq::str_buffer(""),    zmq::buffer(user), zmq::str_buffer("")};
        zmq::send_multipart(socket_, answer);
        question.clear();
    }
}

std::string AccessControl::admitted(const std::vector<zmq::message_t>& question) const {
    if (question.size() <= mechanism) return {};
    const std::string from = question[address].to_string();
    if (!encrypted()) return question[mechanism].to_string_view() == "NULL" ? user_at(from) : "";
    // ZeroMQ itself rejects clients without CURVE; this is a safeguard.
    const bool is_curve = question[mechanism].to_string_view() == "CURVE" && question.size() > credentials;
    const std::string key = is_curve ? z85_of(question[credentials]) : "";
    const std::string user = allowed_.user_of(key);
    if (user.empty()) {
        spdlog::warn("connection refused: from {} with the unknown key {}", from, key);
        return {};
    }
    spdlog::debug("connection of {} from {}", user, from);
    return key;
}

std::string AccessControl::user_of(const zmq::message_t& part) const {
    // Uses the C function, because the C++ one throws if the property does not exist.
    const char* id = zmq_msg_gets(part.handle(), "User-Id");
    if (!id) return {};
    return encrypted() ? allowed_.user_of(id) : id;
}

void AccessControl::reload() {
    if (!encrypted()) return;
    try {
        read_allowed();
    } catch (const Error& error) {
        spdlog::error("{} The previously allowed keys remain valid.", error.what());
    }
}

void AccessControl::read_allowed() {
    std::vector<std::string> problems;
    allowed_ = AllowedKeys::read(config_.security.curve.allowed_keys, problems);
    for (const std::string& problem : problems) spdlog::error("{}", problem);
    spdlog::info("{} keys are allowed to connect", allowed_.size());
}

}  // namespace contactd::server
