// Uses one DEALER socket: sends a request, and waits for its reply.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#include <zmq.hpp>

#include "contactd/proto/answer_text.hpp"
#include "contactd/proto/message.hpp"
#include "curve.hpp"

namespace contactd::client {

/// Holds the unparsed result of a call, with the frames of its arrays.
struct Answer {
    proto::Frame text;
    std::shared_ptr<const proto::AnswerText> document;  ///< of the text
    proto::AnswerValue result;                          ///< in the document
    proto::Frames frames;
};

using ProgressHandler = std::function<void(const nlohmann::json&)>;

class Connection {
   public:
    /// Throws ConnectionError.
    Connection(std::string endpoint, std::chrono::milliseconds connect_timeout, MessageLimits limits,
               std::optional<CurveKeys> keys, std::chrono::microseconds spin);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// Sends a request and waits for its reply, which has passed the schemas. Answers to abandoned calls are
    /// discarded. Throws ConnectionError, TimeoutError, ProtocolError, StatusError, and ConcurrencyError while another
    /// call runs.
    Answer call(const std::string& method, nlohmann::json params, proto::Frames frames,
                std::chrono::milliseconds timeout, const ProgressHandler& on_progress, const std::stop_token& stop);

   private:
    using Clock = std::chrono::steady_clock;

    struct Sockets {
        zmq::context_t context;
        zmq::socket_t socket;
        std::unique_ptr<HandshakeMonitor> handshakes;  // of socket
    };

    /// Abandons the sockets of the parent permanently: their threads are in the parent, and freeing the sockets would
    /// wait for them.
    void start_over();
    void check_process() const;
    Answer await(const std::string& id, const std::string& method, std::chrono::milliseconds timeout,
                 const ProgressHandler& on_progress, const std::stop_token& stop);
    /// Tells the daemon that the request is abandoned. Later answers to it are dropped.
    void cancel(const std::string& id) noexcept;
    void connect();
    void wait_until_connected();
    void send(const std::string& envelope, const proto::Frames& frames);
    /// Returns the frames of the next message, or none at the `deadline`.
    proto::Frames receive(Clock::time_point deadline);
    bool look_for(zmq::message_t& part, Clock::time_point deadline);
    /// Returns false after the timeout or a signal.
    bool receive_part(zmq::message_t& part);
    /// Returns the envelope if the message belongs to request `id`, otherwise null.
    std::shared_ptr<const proto::AnswerText> envelope_for(const std::string& id, std::string_view text) const;

    std::string endpoint_;
    std::chrono::milliseconds connect_timeout_;
    MessageLimits limits_;
    std::string id_prefix_;
    std::uint64_t calls_ = 0;
    int made_ = 0;  // number of sockets up to now
    std::optional<CurveKeys> keys_;
    const std::chrono::microseconds spin_;
    Clock::time_point sent_{};  // when the last request went out
    std::unique_ptr<Sockets> sockets_;
    int process_;  // to which sockets_ belong
    std::atomic<int> user_ = 0;
};

}  // namespace contactd::client
