#include "answering_socket.hpp"

#include <poll.h>
#include <sys/stat.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "contactd/error.hpp"

namespace contactd::server {
namespace {

constexpr int messages_in_socket = 32;
constexpr long retry_ms = 5;

// Closing a socket cuts off an answer that its client is still reading, even with linger, so it stays open for this
// time.
constexpr auto settling = std::chrono::milliseconds(300);

/// Returns whether `socket` can be read. Its descriptor does not show this, because it becomes readable only if
/// something has changed since the socket was last used.
bool has_input(void* socket) {
    int events = 0;
    std::size_t size = sizeof events;
    return ::zmq_getsockopt(socket, ZMQ_EVENTS, &events, &size) == 0 && (events & ZMQ_POLLIN) != 0;
}

pollfd descriptor_of(void* socket) {
    int fd = -1;
    std::size_t size = sizeof fd;
    if (::zmq_getsockopt(socket, ZMQ_FD, &fd, &size) != 0) throw zmq::error_t();
    return {fd, POLLIN, 0};
}

}  // namespace

AnsweringSocket::AnsweringSocket(zmq::context_t& context, const AccessControl& access, const Config& config,
                                 NoteAnswer note)
    : max_frames_(config.limits.max_frames),
      spin_(config.spin),
      access_(access),
      note_(std::move(note)),
      socket_(context, zmq::socket_type::router),
      outbox_(socket_, config.max_outbox_bytes) {
    socket_.set(zmq::sockopt::router_mandatory, true);
    socket_.set(zmq::sockopt::linger, static_cast<int>(linger.count()));
    // ZeroMQ counts messages, not bytes, so it may hold only a few for each client; otherwise our budgets would be
    // ineffective.
    socket_.set(zmq::sockopt::sndhwm, messages_in_socket);
    socket_.set(zmq::sockopt::rcvhwm, messages_in_socket);
    // ZeroMQ closes the connection of a larger frame silently; smaller ones can be answered with an error.
    socket_.set(zmq::sockopt::maxmsgsize, static_cast<std::int64_t>(2 * config.limits.max_frame_bytes));
    access_.protect(socket_);
}

void AnsweringSocket::bind(const std::string& endpoint) {
    // ZeroMQ removes any file at the path, even the socket of a running daemon.
    if (const std::string problem = socket_file_problem(endpoint); !problem.empty()) throw Error(problem);
    const mode_t previous = ::umask(0077);  // Makes an ipc socket accessible to this user only.
    try {
        socket_.bind(endpoint);
        ::umask(previous);
    } catch (const zmq::error_t& error) {
        ::umask(previous);
        throw Error("endpoint is \"" + endpoint + "\"; contactd cannot listen there: " + error.what() + ".");
    }
    file_.emplace(socket_file(address()));
}

void AnsweringSocket::post(Answer answer) {
    std::unique_lock lock(mutex_, std::defer_lock);
    if (is_owner() || !lock.try_lock() || !mailbox_.empty()) return mailbox_.put(std::move(answer));
    const auto line = send(std::move(answer));
    // Sending processes arrived events, so the socket's descriptor no longer signals them.
    if (has_input(socket_.handle()) || !outbox_.empty() || wakes_at_answers_) mailbox_.wake();
    lock.unlock();
    if (line) write(*line);
}

bool AnsweringSocket::wait(int descriptor, std::span<void* const> others, long milliseconds) {
    std::vector<void*> sockets{socket_.handle()};
    sockets.insert(sockets.end(), others.begin(), others.end());
    if (!outbox_.empty()) milliseconds = milliseconds < 0 ? retry_ms : std::min(milliseconds, retry_ms);
    if (std::any_of(sockets.begin(), sockets.end(), has_input)) milliseconds = 0;
    std::vector<pollfd> items{{descriptor, POLLIN, 0}, {mailbox_.fd(), POLLIN, 0}};
    std::transform(sockets.begin(), sockets.end(), std::back_inserter(items), descriptor_of);
    held_.unlock();
    int ready = 0;
    for (const auto end = received_ + spin_; ready == 0 && milliseconds != 0 && Clock::now() < end;) {
        ready = ::poll(items.data(), items.size(), 0);
        if (ready == 0) std::this_thread::yield();  // Gives way to a worker without a processor.
    }
    if (ready == 0) ready = ::poll(items.data(), items.size(), static_cast<int>(milliseconds));
    held_.lock();
    return ready > 0 && (items.front().revents & POLLIN) != 0;
}

std::optional<Message> AnsweringSocket::receive() {
    zmq::message_t part;
    if (!socket_.recv(part, zmq::recv_flags::dontwait)) return std::nullopt;
    Message message{{part.to_string(), false, access_.user_of(part)}, zmq_msg_get(part.handle(), ZMQ_SRCFD), {}, {}};
    std::size_t count = 0;  // counts the frames after the identity and the empty frame of a REQ socket
    for (bool more = part.more(); more;) {
        if (!socket_.recv(part, zmq::recv_flags::none)) break;
        more = part.more();
        if (count == 0 && part.size() == 0 && more && !message.route.empty_delimiter) {
            message.route.empty_delimiter = true;
            continue;
        }
        // Keeps one more than allowed for the check of limits, and drops the rest to save memory.
        if (++count > max_frames_ + 1) continue;
        if (count == 1)
            message.envelope = part.to_string();
        else
            message.frames.emplace_back(std::exchange(part, {}));
    }
    received_ = Clock::now();
    return message;
}

/// Sends the answer and returns its line for the log, to be written afterwards.
std::optional<RequestLine> AnsweringSocket::send(Answer answer) {
    std::optional<RequestLine> line;
    if (!answer.is_progress) {
        note_(answer);
        sent_ = Clock::now();
        line = line_of(answer);
    }
    outbox_.send(std::move(answer));
    return line;
}

void AnsweringSocket::deliver() {
    outbox_.flush();
    std::vector<RequestLine> lines;
    for (Answer& answer : mailbox_.take_all())
        if (auto line = send(std::move(answer))) lines.push_back(std::move(*line));
    for (const RequestLine& line : lines) write(line);
}

bool AnsweringSocket::has_settled() const {
    return outbox_.empty() && Clock::now() >= sent_ + settling;
}

}  // namespace contactd::server
