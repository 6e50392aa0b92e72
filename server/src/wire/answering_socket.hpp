// Wraps the ROUTER socket with its lock and its outbox: receives requests, and sends answers from any thread.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>
#include <zmq.hpp>

#include "access/access_control.hpp"
#include "config/config.hpp"
#include "config/socket_file.hpp"
#include "jobs/call.hpp"
#include "mailbox.hpp"
#include "operation/request_log.hpp"
#include "outbox.hpp"

namespace contactd::server {

/// Holds a received message and its parts.
struct Message {
    Route route;
    int connection = -1;  ///< file descriptor of its connection
    std::string envelope;
    proto::Frames frames;  ///< follow the envelope; one more than allowed if there are too many, for the limit check
};

/// Belongs to the thread that creates it, which holds the lock except while it waits. Another thread with an answer
/// sends it itself if it gets the lock immediately, because waking the owner would take longer. Otherwise it leaves the
/// answer to the owner. Only the owner waits for the lock, for the time of sending one answer.
class AnsweringSocket {
   public:
    using Clock = Call::Clock;
    /// Called with every outgoing answer, except progress, under the lock.
    using NoteAnswer = std::function<void(const Answer&)>;

    /// Answers for slow clients are kept for this time when the socket closes.
    static constexpr auto linger = std::chrono::milliseconds(2000);

    AnsweringSocket(zmq::context_t& context, const AccessControl& access, const Config& config, NoteAnswer note);

    /// Binds the socket. Throws Error if the address cannot be used.
    void bind(const std::string& endpoint);
    /// Returns the address that clients connect to, with the actual port.
    std::string address() const { return socket_.get(zmq::sockopt::last_endpoint); }
    /// Returns the handle for monitoring its connections.
    zmq::socket_t& router() { return socket_; }

    // Any thread:

    /// Sends an answer, now or soon. May be called with other locks held, because it waits only for those of the
    /// mailbox and of `note`.
    void post(Answer answer);
    /// Wakes the owner.
    void wake() { mailbox_.wake(); }
    bool is_owner() const { return std::this_thread::get_id() == owner_; }

    // The owner:

    /// Waits, without the lock, until a message or an answer arrives, one of `others` or `descriptor` can be read, the
    /// timeout passes (negative: none), or a retry for a slow client is due. Returns true if `descriptor` can be read.
    /// After a message it polls for the next one before it sleeps (spin_microseconds).
    bool wait(int descriptor, std::span<void* const> others, long milliseconds);
    /// Returns the next message, if there is one.
    std::optional<Message> receive();
    /// Sends answers left by other threads, and retries those for slow clients.
    void deliver();
    /// Returns whether answers wait to be sent.
    bool has_backlog() const { return !mailbox_.empty() || !outbox_.empty(); }
    std::size_t backlog_bytes() const { return outbox_.bytes(); }
    /// Lets each answer sent by other threads wake the owner from now on.
    void wake_at_answers() { wakes_at_answers_ = true; }
    /// Returns whether all answers were sent long enough ago that closing the socket cuts none off.
    bool has_settled() const;

   private:
    std::optional<RequestLine> send(Answer answer);

    const std::size_t max_frames_;
    const std::chrono::microseconds spin_;
    const AccessControl& access_;
    const NoteAnswer note_;
    const std::thread::id owner_ = std::this_thread::get_id();
    Mailbox<Answer> mailbox_;
    std::mutex mutex_;  // guards the members below
    std::unique_lock<std::mutex> held_{mutex_};
    zmq::socket_t socket_;
    std::optional<SocketFile> file_;  // ZeroMQ leaves it
    Outbox outbox_;
    bool wakes_at_answers_ = false;
    Clock::time_point sent_{};      // time when the last answer was sent
    Clock::time_point received_{};  // time when the last message arrived
};

}  // namespace contactd::server
