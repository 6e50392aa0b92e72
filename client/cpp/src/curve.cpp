#include "curve.hpp"

#include <cstdint>
#include <cstring>

#include "contactd/client/errors.hpp"
#include "contactd/proto/key_file.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::client {
namespace {

/// A daemon that cannot decrypt a client's messages closes the connection silently. A stopping one does so once.
constexpr int silent_ends_allowed = 2;

[[noreturn]] void refuse(const std::string& endpoint, const std::string& why) {
    throw StatusError(StatusCode::unauthenticated, "HANDSHAKE_FAILED",
                      "No connection to " + endpoint + ": " + why + ".");
}

}  // namespace

void CurveKeys::apply(zmq::socket_t& socket) const {
    socket.set(zmq::sockopt::curve_serverkey, server);
    socket.set(zmq::sockopt::curve_publickey, own_public);
    socket.set(zmq::sockopt::curve_secretkey, own_secret);
}

std::optional<CurveKeys> load_curve_keys(const std::filesystem::path& server_key,
                                         const std::filesystem::path& own_key) {
    if (server_key.empty() && own_key.empty()) return std::nullopt;
    if (server_key.empty() || own_key.empty())
        throw Error(std::string(server_key.empty() ? "server_key" : "own_key") +
                    " is missing: an encrypted connection requires the daemon's public key and your own key.");
    const proto::KeyFile server = proto::read_key_file(server_key);
    const proto::KeyFile own = proto::read_key_file(own_key);
    if (own.secret_key.empty())
        throw Error("The key file " + own_key.string() +
                    " contains no secret key; set own_key to the file NAME.key_secret.");
    proto::check_private(own_key);
    return CurveKeys{server.public_key, own.public_key, own.secret_key};
}

HandshakeMonitor::HandshakeMonitor(zmq::context_t& context, zmq::socket_t& watched, const std::string& channel,
                                   std::string endpoint, bool encrypted)
    : watched_(watched),
      endpoint_(std::move(endpoint)),
      encrypted_(encrypted),
      events_(context, zmq::socket_type::pair) {
    constexpr int events =
        ZMQ_EVENT_HANDSHAKE_FAILED_AUTH | ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL | ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL;
    if (::zmq_socket_monitor(watched_.handle(), channel.c_str(), events) != 0) throw zmq::error_t();
    events_.set(zmq::sockopt::linger, 0);
    events_.connect(channel);
}

HandshakeMonitor::~HandshakeMonitor() {
    ::zmq_socket_monitor(watched_.handle(), nullptr, 0);
}

void HandshakeMonitor::check() {
    for (Event event = next(); event.kind != 0; event = next()) judge(event);
}

void HandshakeMonitor::forget() {
    while (next().kind != 0) continue;
    silent_ends_ = 0;
}

HandshakeMonitor::Event HandshakeMonitor::next() {
    // Receives two frames: event (16 bits) and its value (32 bits), then an address.
    zmq::message_t frame;
    if (!events_.recv(frame, zmq::recv_flags::dontwait)) return {};
    std::uint16_t kind = 0;
    std::uint32_t value = 0;
    if (frame.size() == sizeof kind + sizeof value) {
        std::memcpy(&kind, frame.data(), sizeof kind);
        std::memcpy(&value, frame.data<char>() + sizeof kind, sizeof value);
    }
    while (frame.more() && events_.recv(frame, zmq::recv_flags::none)) continue;
    return {kind, static_cast<int>(value)};
}

void HandshakeMonitor::judge(const Event& event) {
    if (event.kind == ZMQ_EVENT_HANDSHAKE_FAILED_AUTH)
        refuse(endpoint_, "the daemon does not accept this client's key; ask its administrator to allow own_key");
    if (event.kind == ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL) {
        if (event.value != ZMQ_PROTOCOL_ERROR_ZMTP_MECHANISM_MISMATCH)
            throw ConnectionError("The program that listens at " + endpoint_ + " is not a contactd daemon.");
        refuse(endpoint_, encrypted_ ? "the daemon does not use encryption; remove server_key and own_key"
                                     : "the daemon accepts encrypted connections only; give server_key and own_key");
    }
    if (event.kind != ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL || ++silent_ends_ <= silent_ends_allowed) return;
    refuse(endpoint_,
           encrypted_
               ? "it cannot read this client's messages; either server_key is not the daemon's key, or the daemon does "
                 "not use encryption"
               : "it closes the connection; if it accepts encrypted connections only, give server_key and own_key");
}

}  // namespace contactd::client
