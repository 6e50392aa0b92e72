// The ROUTER socket, its lock and its outbox: requests come in, answers go out from any thread.
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

/// A message as it came, taken apart.
struct Message {
    Route route;
    int connection = -1;  ///< the file descriptor it came through
    std::string envelope;
    proto::Frames frames;  ///< behind the envelope; of too many one more than allowed, for who checks limits
};

/// Belongs to the thread that makes it, which holds the lock whenever it does not wait. Another thread that has an
/// answer sends it itself if it gets the lock at once: waking the owner would take longer. Otherwise it leaves the
/// answer to the owner. Only the owner waits for the lock, for the time of sending one answer.
class AnsweringSocket {
   public:
    using Clock = Call::Clock;
    /// Hears of every answer that goes out, progress excepted, under the lock.
    using NoteAnswer = std::function<void(const Answer&)>;

    /// How long answers stay when the socket closes, for a client that reads slowly.
    static constexpr auto linger = std::chrono::milliseconds(2000);

    AnsweringSocket(zmq::context_t& context, const AccessControl& access, const Config& config, NoteAnswer note);

    /// Throws Error when the address cannot be used.
    void bind(const std::string& endpoint);
    /// The address that clients connect to, with the port that was taken.
    std::string address() const { return socket_.get(zmq::sockopt::last_endpoint); }
    /// For whoever watches its connections.
    zmq::socket_t& router() { return socket_; }

    // Any thread:

    /// Sends an answer, now or soon. Whoever holds other locks may call this, since it waits for none but those of the
    /// mailbox and of what `note` does.
    void post(Answer answer);
    /// Ends a wait of the owner.
    void wake() { mailbox_.wake(); }
    bool is_owner() const { return std::this_thread::get_id() == owner_; }

    // The owner:

    /// Waits, without the lock, until a message or an answer has come, one of `others` or `descriptor` can be read, or
    /// it is time (negative: no time), or time to try again what a client had no room for. True when `descriptor` can
    /// be read. After a message it looks for the next one before it sleeps (spin_microseconds).
    bool wait(int descriptor, std::span<void* const> others, long milliseconds);
    /// The next message that has arrived, if there is one.
    std::optional<Message> receive();
    /// Sends what others have left, and tries again what clients had no room for.
    void deliver();
    /// Whether answers wait to be sent.
    bool has_backlog() const { return !mailbox_.empty() || !outbox_.empty(); }
    std::size_t backlog_bytes() const { return outbox_.bytes(); }
    /// From now on each answer that others send ends a wait.
    void wake_at_answers() { wakes_at_answers_ = true; }
    /// Whether all answers have gone, long enough ago for closing the socket not to cut one off.
    bool has_settled() const;

   private:
    std::optional<RequestLine> send(Answer answer);

    const std::size_t max_frames_;
    const std::chrono::microseconds spin_;
    const AccessControl& access_;
    const NoteAnswer note_;
    const std::thread::id owner_ = std::this_thread::get_id();
    Mailbox<Answer> mailbox_;
    std::mutex mutex_;  // guards what follows
    std::unique_lock<std::mutex> held_{mutex_};
    zmq::socket_t socket_;
    std::optional<SocketFile> file_;  // ZeroMQ leaves it
    Outbox outbox_;
    bool wakes_at_answers_ = false;
    Clock::time_point sent_{};      // when the last answer went out
    Clock::time_point received_{};  // when the last message came
};

}  // namespace contactd::server
