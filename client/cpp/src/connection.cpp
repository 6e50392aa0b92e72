#include "connection.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <random>
#include <thread>
#include <utility>

#include "contactd/client/errors.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/proto/status.hpp"
#include "one_at_a_time.hpp"

namespace contactd::client {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;

/// Additional wait of the client after the deadline, so that the daemon's DEADLINE_EXCEEDED arrives.
constexpr milliseconds grace{500};
constexpr milliseconds longest_timeout{86'400'000};
/// Interval of checks for a stop request.
constexpr milliseconds stop_interval{20};
constexpr int cancel_linger_ms = 200;

/// Distinguishes replies to this object's calls from others.
std::string random_prefix() {
    std::random_device device;
    const std::uint64_t number = (std::uint64_t{device()} << 32u) | device();
    char text[16];
    const auto end = std::to_chars(text, text + sizeof text, number, 16).ptr;
    return std::string(text, end) + "-";
}

void check_limit(const char* what, std::size_t is, std::size_t limit) {
    if (is <= limit) return;
    Status status;
    status.code = StatusCode::invalid_argument;
    status.reason = reason::limit_exceeded;
    status.message = std::string("The request was not sent: ") + what + " is " + std::to_string(is) + ", but at most " +
                     std::to_string(limit) + " are allowed.";
    throw StatusError(std::move(status));
}

void check_limits(const std::string& envelope, const proto::Frames& frames, const MessageLimits& limits) {
    check_limit("the number of frames", frames.size() + 1, limits.max_frames);
    std::size_t total = envelope.size();
    std::size_t largest = envelope.size();
    for (const proto::Frame& frame : frames) {
        total += frame.size();
        largest = std::max(largest, frame.size());
    }
    check_limit("the number of bytes of a frame", largest, limits.max_frame_bytes);
    check_limit("the number of bytes of the message", total, limits.max_message_bytes);
}

void check_schema(std::string_view name, const proto::AnswerValue& document) {
    const auto violations = proto::violations_of(name, document);
    if (violations.empty()) return;
    throw ProtocolError("The daemon's answer does not conform to " + std::string(name) + ": " + violations[0].field +
                        " " + violations[0].description + ".");
}

void check_version(const proto::AnswerValue& answer) {
    const auto version = answer.find("contactd");
    if (!version || !version->is_number_integer() || version->integer() == proto::protocol_version) return;
    throw ProtocolError("The daemon answers in version " + std::to_string(version->integer()) +
                        " of the protocol; this client, contactd " CONTACTD_VERSION ", speaks version " +
                        std::to_string(proto::protocol_version) + ": upgrade the " +
                        (version->integer() > proto::protocol_version ? "client." : "daemon."));
}

json call_envelope(const std::string& id, const std::string& method, json params, milliseconds timeout) {
    return proto::object({{"contactd", proto::protocol_version},
                          {"id", id},
                          {"method", method},
                          {"timeout_ms", timeout.count()},
                          {"metadata", proto::object({{"client", "contactd-cpp " CONTACTD_VERSION}})},
                          {"params", std::move(params)}});
}

proto::AnswerValue no_result() {
    static const auto empty = proto::AnswerText::parsed("{}");
    return empty->root();
}

}  // namespace

Connection::Connection(std::string endpoint, milliseconds connect_timeout, MessageLimits limits,
                       std::optional<CurveKeys> keys, std::chrono::microseconds spin)
    : endpoint_(std::move(endpoint)),
      connect_timeout_(connect_timeout),
      limits_(limits),
      id_prefix_(random_prefix()),
      keys_(std::move(keys)),
      spin_(spin),
      sockets_(std::make_unique<Sockets>()),
      process_(::getpid()) {
    connect();
}

Connection::~Connection() {
    if (process_ != ::getpid()) (void)sockets_.release();
}

void Connection::start_over() {
    (void)sockets_.release();
    sockets_ = std::make_unique<Sockets>();
    process_ = ::getpid();
    connect();
}

void Connection::check_process() const {
    if (process_ != ::getpid())  // on_progress has forked; this is the child process
        throw ConnectionError("This process was forked from the one that receives the answer.");
}

void Connection::connect() {
    sockets_->handshakes.reset();
    sockets_->socket = zmq::socket_t(sockets_->context, zmq::socket_type::dealer);
    sockets_->handshakes = std::make_unique<HandshakeMonitor>(sockets_->context, sockets_->socket,
                                                              "inproc://handshakes-" + std::to_string(++made_),
                                                              endpoint_, keys_.has_value());
    sockets_->socket.set(zmq::sockopt::linger, 0);
    // Sending waits for a listener instead of queueing.
    sockets_->socket.set(zmq::sockopt::immediate, true);
    sockets_->socket.set(zmq::sockopt::sndtimeo,
                         static_cast<int>(std::clamp(connect_timeout_, milliseconds{0}, longest_timeout).count()));
    // Not for host names, which would be resolved to IPv6 addresses first.
    sockets_->socket.set(zmq::sockopt::ipv6, endpoint_.starts_with("tcp://["));
    try {
        if (keys_) keys_->apply(sockets_->socket);
        sockets_->socket.connect(endpoint_);
    } catch (const zmq::error_t& error) {
        throw ConnectionError("The endpoint \"" + endpoint_ + "\" cannot be used: " + error.what() +
                              ". It must have the form ipc:///path or tcp://host:port.");
    }
}

Answer Connection::call(const std::string& method, json params, proto::Frames frames, milliseconds timeout,
                        const ProgressHandler& on_progress, const std::stop_token& stop) {
    const OneAtATime guard(user_,
                           "A call of this client is already running, in another thread or around this on_progress. "
                           "Use one client per thread, and another one in on_progress.");
    if (process_ != ::getpid()) start_over();
    timeout = std::clamp(timeout, milliseconds{1}, longest_timeout);
    const std::string id = id_prefix_ + std::to_string(++calls_);
    const std::string envelope = proto::dump(call_envelope(id, method, std::move(params), timeout));
    check_limits(envelope, frames, limits_);
    send(envelope, frames);
    try {
        return await(id, method, timeout, on_progress, stop);
    } catch (const ConnectionError&) {
        throw;
    } catch (const ProtocolError&) {
        throw;
    } catch (const StatusError&) {
        if (stop.stop_requested()) cancel(id);
        throw;
    } catch (...) {  // timeout, or an exception of on_progress
        cancel(id);
        throw;
    }
}

Answer Connection::await(const std::string& id, const std::string& method, milliseconds timeout,
                         const ProgressHandler& on_progress, const std::stop_token& stop) {
    const auto deadline = Clock::now() + timeout + grace;
    while (true) {
        const auto until = stop.stop_possible() ? std::min(deadline, Clock::now() + stop_interval) : deadline;
        proto::Frames message = receive(until);
        if (message.empty() && stop.stop_requested())
            throw StatusError(StatusCode::cancelled, reason::request_cancelled,
                              "The call of " + method + " was stopped.");
        if (message.empty() && Clock::now() < deadline) continue;
        if (message.empty())
            throw TimeoutError("No answer to " + method + " from " + endpoint_ + " within " +
                               std::to_string(timeout.count()) + " ms.");
        proto::Frame text = message[0];
        auto document = envelope_for(id, text.bytes());
        if (!document) continue;
        const proto::AnswerValue answer = document->root();
        if (const auto progress = answer.find("progress")) {
            if (on_progress) on_progress(progress->json());
            continue;
        }
        const Status status = proto::status_from_json(answer["status"].json());
        if (!status.ok()) throw StatusError(status);
        const proto::AnswerValue result = answer.find("result").value_or(no_result());
        check_schema(method + ".result", result);
        message.erase(message.begin());
        return {std::move(text), std::move(document), result, std::move(message)};
    }
}

void Connection::cancel(const std::string& id) noexcept {
    if (process_ != ::getpid()) return;
    try {
        const json request{{"contactd", proto::protocol_version},
                           {"id", id + "-cancel"},
                           {"method", "request.cancel"},
                           {"params", {{"id", id}}}};
        // A caller that abandons the call may end the connection immediately; the request must still be sent.
        sockets_->socket.set(zmq::sockopt::linger, cancel_linger_ms);
        sockets_->socket.send(zmq::buffer(proto::dump(request)), zmq::send_flags::dontwait);
    } catch (const std::exception&) {  // the daemon has stopped, and the request has ended with it
    }
}

void Connection::wait_until_connected() {
    const auto deadline = Clock::now() + std::clamp(connect_timeout_, milliseconds{0}, longest_timeout);
    zmq::pollitem_t items[] = {{sockets_->socket.handle(), 0, ZMQ_POLLOUT, 0},
                               {sockets_->handshakes->handle(), 0, ZMQ_POLLIN, 0}};
    while (Clock::now() < deadline) {
        try {
            zmq::poll(items, 2, std::chrono::ceil<milliseconds>(deadline - Clock::now()));
            if (items[0].revents & ZMQ_POLLOUT) return sockets_->handshakes->forget();
            sockets_->handshakes->check();
        } catch (const zmq::error_t& error) {
            if (error.num() != EINTR) throw;
        } catch (const Error&) {
            connect();  // a socket does not retry after its handshake was refused
            throw;
        }
    }
    throw ConnectionError("No daemon is listening at " + endpoint_ + " (waited " +
                          std::to_string(connect_timeout_.count()) + " ms). Start it, or check the endpoint.");
}

void Connection::send(const std::string& envelope, const proto::Frames& frames) {
    try {
        const auto more = [&](std::size_t sent) {
            return sent < frames.size() ? zmq::send_flags::sndmore : zmq::send_flags::none;
        };
        if (!sockets_->socket.send(zmq::buffer(envelope), more(0) | zmq::send_flags::dontwait)) {
            wait_until_connected();
            if (!sockets_->socket.send(zmq::buffer(envelope), more(0)))
                throw ConnectionError("The daemon at " + endpoint_ + " disconnected.");
        }
        for (std::size_t i = 0; i < frames.size(); ++i)
            sockets_->socket.send(zmq::buffer(frames[i].bytes()), more(i + 1));
        sent_ = Clock::now();
    } catch (const zmq::error_t& error) {
        throw ConnectionError("Sending to " + endpoint_ + " failed: " + error.what() + ".");
    }
}

proto::Frames Connection::receive(Clock::time_point deadline) {
    try {
        while (true) {
            check_process();
            const auto left = std::chrono::ceil<milliseconds>(deadline - Clock::now());
            if (left <= milliseconds{0}) return {};
            sockets_->socket.set(zmq::sockopt::rcvtimeo, static_cast<int>(left.count()));
            proto::Frames frames;
            zmq::message_t part;
            if (!look_for(part, deadline) && !receive_part(part)) continue;
            for (bool more = true; more;) {  // the parts of a message arrive together
                more = part.more();
                frames.emplace_back(std::exchange(part, {}));
                while (more && !receive_part(part)) {
                }
            }
            return frames;
        }
    } catch (const zmq::error_t& error) {
        throw ConnectionError("Receiving from " + endpoint_ + " failed: " + error.what() + ".");
    }
}

/// Polls for the time spin_ after the request was sent.
bool Connection::look_for(zmq::message_t& part, Clock::time_point deadline) {
    for (const auto end = std::min(sent_ + spin_, deadline); Clock::now() < end; std::this_thread::yield())
        if (sockets_->socket.recv(part, zmq::recv_flags::dontwait)) return true;
    return false;
}

bool Connection::receive_part(zmq::message_t& part) {
    try {
        return sockets_->socket.recv(part).has_value();
    } catch (const zmq::error_t& error) {
        if (error.num() != EINTR) throw;
        return false;
    }
}

std::shared_ptr<const proto::AnswerText> Connection::envelope_for(const std::string& id, std::string_view text) const {
    auto document = proto::AnswerText::parsed(text);
    if (!document || !document->root().is_object())
        throw ProtocolError("The message from " + endpoint_ +
                            " is not a JSON object. Check that a contactd daemon is listening there.");
    const proto::AnswerValue answer = document->root();
    const auto answered = answer.find("id");
    // An error with the id null answers an unreadable request, which is the last one sent.
    const bool is_ours = !answered || answered->is_null() || (answered->is_string() && answered->text() == id);
    if (!is_ours) return nullptr;
    check_version(answer);
    check_schema(answer.contains("progress") ? "progress" : "reply", answer);
    return document;
}

}  // namespace contactd::client
