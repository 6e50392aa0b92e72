#include "ping.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <zmq.hpp>

#include "contactd/error.hpp"
#include "contactd/proto/key_file.hpp"
#include "contactd/proto/message.hpp"

namespace contactd::server {

using nlohmann::json;

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* handshakes = "inproc://handshakes";
/// A daemon closes the connection silently if it cannot read a client's messages, and once while it shuts down.
constexpr int silent_ends_allowed = 2;

void encrypt(zmq::socket_t& socket, const PingKeys& keys) {
    if (keys.server.empty() && keys.own.empty()) return;
    const proto::KeyFile server = proto::read_key_file(keys.server), own = proto::read_key_file(keys.own);
    if (own.secret_key.empty())
        throw Error("The key file " + keys.own.string() +
                    " contains no secret key; give NAME.key_secret to --own-key.");
    proto::check_private(keys.own);
    socket.set(zmq::sockopt::curve_serverkey, server.public_key);
    socket.set(zmq::sockopt::curve_publickey, own.public_key);
    socket.set(zmq::sockopt::curve_secretkey, own.secret_key);
}

/// Returns a socket that reports failed handshakes of `socket`.
zmq::socket_t failures_of(zmq::context_t& context, zmq::socket_t& socket) {
    constexpr int events =
        ZMQ_EVENT_HANDSHAKE_FAILED_AUTH | ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL | ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL;
    if (::zmq_socket_monitor(socket.handle(), handshakes, events) != 0) throw zmq::error_t();
    zmq::socket_t failures(context, zmq::socket_type::pair);
    failures.set(zmq::sockopt::linger, 0);
    failures.connect(handshakes);
    return failures;
}

/// Returns the next event, or 0. An event has two frames, of which the first begins with its number.
int next_failure(zmq::socket_t& failures) {
    zmq::message_t frame;
    if (!failures.recv(frame, zmq::recv_flags::dontwait)) return 0;
    std::uint16_t event = 0;
    if (frame.size() >= sizeof event) std::memcpy(&event, frame.data(), sizeof event);
    while (frame.more() && failures.recv(frame, zmq::recv_flags::none)) continue;
    return event;
}

PingResult read_answer(const zmq::message_t& reply) {
    const json answer = json::parse(reply.to_string_view());
    const json& status = answer.at("status");
    if (status.at("code") != 0) return {false, status.at("message").get<std::string>()};
    const std::string state = answer.at("result").at("state");
    return {state == "serving", state};
}

PingResult ask(zmq::socket_t& socket, zmq::socket_t& failures, const std::string& endpoint,
               std::chrono::milliseconds timeout) {
    const json request{{"contactd", proto::protocol_version}, {"id", "ping"}, {"method", "server.health"}};
    socket.send(zmq::buffer(request.dump()), zmq::send_flags::none);
    std::array<zmq::pollitem_t, 2> items{{{socket.handle(), 0, ZMQ_POLLIN, 0}, {failures.handle(), 0, ZMQ_POLLIN, 0}}};
    int silent_ends = 0;
    const auto end = Clock::now() + timeout;
    for (auto now = Clock::now(); now < end; now = Clock::now()) {
        zmq::poll(items, std::chrono::ceil<std::chrono::milliseconds>(end - now));
        zmq::message_t reply;
        if (socket.recv(reply, zmq::recv_flags::dontwait)) return read_answer(reply);
        const int failure = next_failure(failures);
        if (failure == 0 || (failure == ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL && ++silent_ends <= silent_ends_allowed))
            continue;
        return {false, endpoint +
                           " refuses this connection. An encrypted daemon requires its --server-key and an allowed "
                           "--own-key, and an unencrypted one requires neither."};
    }
    return {false, "No answer from " + endpoint + " within " + std::to_string(timeout.count()) + " ms."};
}

}  // namespace

PingResult ping(const std::string& endpoint, const PingKeys& keys, std::chrono::milliseconds timeout) {
    try {
        zmq::context_t context;
        zmq::socket_t socket(context, zmq::socket_type::dealer);
        socket.set(zmq::sockopt::linger, 0);
        socket.set(zmq::sockopt::ipv6, endpoint.starts_with("tcp://["));
        encrypt(socket, keys);
        zmq::socket_t failures = failures_of(context, socket);
        socket.connect(endpoint);
        return ask(socket, failures, endpoint, timeout);
    } catch (const Error& error) {
        return {false, error.what()};
    } catch (const std::exception& error) {
        return {false, endpoint + " cannot be reached: " + error.what() + "."};
    }
}

}  // namespace contactd::server
