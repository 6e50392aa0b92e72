#include "endpoint.hpp"

#include <poll.h>
#include <spdlog/spdlog.h>
#include <sys/signalfd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <thread>
#include <utility>

#include "config/socket_file.hpp"
#include "contactd/error.hpp"

namespace contactd::server {

using Clock = Call::Clock;
using proto::Status;
using proto::StatusCode;

namespace {

/// Envelopes up to this size are read by the I/O thread itself; larger ones would keep others waiting.
constexpr std::size_t small_envelope = 64 << 10;
constexpr int messages_per_turn = 64;
constexpr int messages_in_socket = 32;
constexpr int backlog_poll_ms = 5;
constexpr auto linger = std::chrono::milliseconds(2000);  // of answers, for a client that reads slowly

// Closing a socket cuts off an answer that its client is still reading, lingering or not: it stays open so much longer.
constexpr auto settling = std::chrono::milliseconds(300);
constexpr auto stop_time = std::chrono::seconds(5);  // builders that do not end at once

void bind(zmq::socket_t& socket, const std::string& endpoint) {
    // ZeroMQ removes whatever it finds at the path, and takes it over from a daemon that still listens there.
    if (const std::string problem = socket_file_problem(endpoint); !problem.empty()) throw Error(problem);
    const mode_t previous = ::umask(0077);  // an ipc socket is for this user only
    try {
        socket.bind(endpoint);
        ::umask(previous);
    } catch (const zmq::error_t& error) {
        ::umask(previous);
        throw Error("endpoint is \"" + endpoint + "\"; it cannot be listened at: " + error.what() + ".");
    }
}

/// Whether something can be read from `socket`. Not known from its descriptor, which becomes readable when something
/// has changed since the socket was last used.
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

Endpoint::Endpoint(const Config& config, Service& service)
    : config_(config),
      service_(service),
      access_(config, context_),
      rate_limit_(config.security.per_user.requests_per_second, config.security.per_user.burst),
      socket_(context_, zmq::socket_type::router),
      monitor_(context_, socket_),
      unfinished_(config.max_inbox_bytes),
      outbox_(socket_, config.max_outbox_bytes),
      thread_(std::this_thread::get_id()) {
    socket_.set(zmq::sockopt::router_mandatory, true);
    socket_.set(zmq::sockopt::linger, static_cast<int>(linger.count()));
    // ZeroMQ counts messages, not bytes: what it holds for each client must be few, so that our budgets mean something.
    socket_.set(zmq::sockopt::sndhwm, messages_in_socket);
    socket_.set(zmq::sockopt::rcvhwm, messages_in_socket);
    // A frame above this costs its sender the connection, without a word; up to it we can answer in words.
    socket_.set(zmq::sockopt::maxmsgsize, static_cast<std::int64_t>(2 * config.limits.max_frame_bytes));
    access_.protect(socket_);
    bind(socket_, config.endpoint);
    file_.emplace(socket_file(address()));
}

std::string Endpoint::address() const {
    return socket_.get(zmq::sockopt::last_endpoint);
}

void Endpoint::run(int signal_fd, const Notifier& notifier, const std::function<void()>& reload) {
    SocketLock lock(socket_mutex_);
    service_.parts().health.set_listening();
    notifier.ready("Serving at " + address());
    auto told = Clock::now();
    while (Clock::now() < end_ && !(is_draining() && is_idle())) {
        long patience = poll_milliseconds();
        if (const long interval = notifier.interval().count(); interval > 0)
            patience = patience < 0 ? interval : std::min(patience, interval);
        const bool is_signalled = wait(lock, signal_fd, patience);
        if (notifier.interval().count() > 0 && Clock::now() - told >= notifier.interval()) {
            notifier.alive();
            told = Clock::now();
        }
        deliver();
        receive();
        deliver();  // what has been answered at once
        end_overdue();
        service_.parts().sessions.expire(Clock::now());
        unfinished_.enforce(Clock::now());
        read_monitor();
        drop_gone();
        access_.answer_all();
        note_levels();
        signalfd_siginfo signal{};
        if (is_signalled && ::read(signal_fd, &signal, sizeof signal) == sizeof signal)
            handle_signal(static_cast<int>(signal.ssi_signo), notifier, reload);
    }
    stop();
}

/// Waits for something to do, without the lock. True when a signal has come.
bool Endpoint::wait(SocketLock& lock, int signal_fd, long milliseconds) {
    const std::array sockets{socket_.handle(), monitor_.handle(), access_.handle()};
    if (std::any_of(sockets.begin(), sockets.end(), has_input)) milliseconds = 0;
    std::array<pollfd, 5> items{{{signal_fd, POLLIN, 0}, {mailbox_.fd(), POLLIN, 0}}};
    std::transform(sockets.begin(), sockets.end(), items.begin() + 2, descriptor_of);
    lock.unlock();
    const int ready = ::poll(items.data(), items.size(), static_cast<int>(milliseconds));
    lock.lock();
    return ready > 0 && (items[0].revents & POLLIN) != 0;
}

void Endpoint::note_levels() {
    Counters& counters = service_.parts().counters;
    counters.outbox_bytes = static_cast<long long>(outbox_.bytes());
    counters.open_requests = static_cast<long long>(service_.parts().open_calls.count());
}

void Endpoint::handle_signal(int signal, const Notifier& notifier, const std::function<void()>& reload) {
    if (signal == SIGHUP) {
        notifier.reloading();
        reload();
        reload_keys();
        return notifier.ready("Serving at " + address());
    }
    spdlog::info("ending on {}", ::strsignal(signal));
    if (is_draining())
        end_ = Clock::now();
    else
        begin_drain(notifier);
}

// --- in --------------------------------------------------------------------------------------------------------------

bool Endpoint::receive() {
    for (int n = 0; n < messages_per_turn; ++n) {
        zmq::message_t part;
        if (!socket_.recv(part, zmq::recv_flags::dontwait)) return false;
        Route route{part.to_string(), false, access_.user_of(part)};
        const int connection = zmq_msg_get(part.handle(), ZMQ_SRCFD);
        unfinished_.note_message(connection);
        if (!clients_.knows(connection, route.identity)) read_monitor();
        const bool has_gone = !clients_.note_message(connection, route.identity);
        std::vector<std::string> frames;
        std::size_t count = 0;
        while (part.more()) {
            if (!socket_.recv(part, zmq::recv_flags::none)) break;
            if (count == 0 && frames.empty() && part.size() == 0 && part.more() && !route.empty_delimiter) {
                route.empty_delimiter = true;
                continue;
            }
            // One more than allowed is kept, for the limit check to see; the rest is not worth its memory.
            if (++count <= config_.limits.max_frames + 1) frames.push_back(part.to_string());
        }
        std::string envelope = frames.empty() ? std::string() : std::move(frames.front());
        if (!frames.empty()) frames.erase(frames.begin());
        if (!has_gone) accept(std::move(route), std::move(envelope), std::move(frames));
    }
    return true;
}

void Endpoint::accept(Route route, std::string envelope, std::vector<std::string> frames) {
    const auto received = Clock::now();
    ++service_.parts().counters.requests;
    if (!admit(route, envelope.size() <= small_envelope ? envelope : "", received)) return;
    if (envelope.size() <= small_envelope || parser_ended_)
        return parse_now(route, envelope, std::move(frames), received, {});
    // In a thread of its own rather than a worker, which may be long in coming, while the deadline is not known yet.
    try {
        std::size_t bytes = envelope.size();
        for (const auto& frame : frames) bytes += frame.size();
        OpenCalls::Admission admission = service_.parts().open_calls.admit(route, bytes);
        Turn turn{.client = route.identity, .user = route.user};
        parser_.post(std::move(turn), [this, received, route = std::move(route), envelope = std::move(envelope),
                                       frames = std::move(frames), admission = std::move(admission)]() mutable {
            parse_now(route, envelope, std::move(frames), received, std::move(admission));
        });
    } catch (const std::exception& error) {
        mailbox_.put(refusal(route, "", status_of(error)));
    }
}

void Endpoint::parse_now(const Route& route, const std::string& envelope, std::vector<std::string> frames,
                         Clock::time_point received, OpenCalls::Admission admission) {
    const CallNumber number = admission.number;
    std::string id;
    try {
        open_call(route, proto::parse_request(envelope, std::move(frames), config_.limits, id), received,
                  std::move(admission));
    } catch (const std::exception& error) {
        Answer answer = refusal(route, id, status_of(error));
        answer.number = number;
        mailbox_.put(std::move(answer));
    }
}

void Endpoint::open_call(const Route& route, proto::Request request, Clock::time_point received,
                         OpenCalls::Admission admission) {
    OpenCalls& open = service_.parts().open_calls;
    const Method* method = service_.method(request.method);
    const bool counts = method && method->counts;
    if (counts && admission.number == 0) admission = open.admit(route, request.bytes);
    const auto priority = request.priority.value_or(method ? method->priority : proto::Priority::normal);
    auto call = std::make_shared<Call>(route, std::move(request), received, priority, config_.limits,
                                       [this, admission](Answer answer) {
                                           if (!answer.is_progress) answer.number = admission.number;
                                           post(std::move(answer));
                                       });
    if (admission.number != 0 && !open.attach(admission.number, call)) return;  // answered while it was read
    if (call->request.method == "request.cancel" && open.has_unread(route.identity)) {
        // Perhaps it is the unread one that is meant: not before that has been read.
        return parser_.post({.client = route.identity, .user = route.user}, [this, call] { service_.handle(call); });
    }
    const bool has_deadline = call->request.timeout_ms > 0;
    service_.handle(std::move(call));
    if (counts && has_deadline && std::this_thread::get_id() != thread_) mailbox_.wake();  // its poll must know of it
}

/// False, and answered, when the sender may not ask for anything, or not now. The id of the request is looked for in
/// `envelope`.
bool Endpoint::admit(const Route& route, std::string_view envelope, Clock::time_point received) {
    const bool revoked = route.user.empty();
    const auto wait = revoked ? std::chrono::milliseconds{0} : rate_limit_.take(route.user, received);
    if (!revoked && wait.count() == 0) return true;
    std::string id;
    try {
        if (!envelope.empty()) proto::parse_request(envelope, {}, config_.limits, id);
    } catch (const std::exception&) {
        // The id, where there was one, is all that was wanted.
    }
    mailbox_.put(refusal(route, id, revoked ? key_revoked() : rate_limit_.refusal(wait)));
    return false;
}

/// What has happened to connections.
void Endpoint::read_monitor() {
    monitor_.read(service_.parts().counters.connections, unfinished_, clients_);
}

/// Ends the requests of clients that have gone: nobody would hear the answers.
void Endpoint::drop_gone() {
    static const Status gone{
        StatusCode::cancelled, "The client has gone.", std::string(proto::reason::client_gone), {}, 0};
    const std::vector<std::string> clients = clients_.take_gone();
    for (const std::string& client : clients) {
        for (const auto& [number, entry] : service_.parts().open_calls.of(client)) {
            if (entry.call && entry.call->outlives_client()) continue;
            if (entry.call) {
                entry.call->fail(gone);
                continue;
            }
            Answer answer = refusal(entry.route, "", gone);
            answer.number = number;
            mailbox_.put(std::move(answer));
        }
    }
    if (!clients.empty()) service_.parts().drop_abandoned();
}

/// Reads the allowed keys again, and ends the requests of those who are not allowed any more.
void Endpoint::reload_keys() {
    access_.reload();
    for (const auto& [route, call] : service_.parts().open_calls.all())
        if (call && !access_.knows(route.user)) call->fail(key_revoked());
    service_.parts().drop_abandoned();
}

// --- out -------------------------------------------------------------------------------------------------------------

/// From any thread. Another than the I/O thread sends the answer itself where the socket is free: waking the I/O thread
/// would take longer. Whoever holds other locks may call this, since it waits for none but those of the counters.
void Endpoint::post(Answer answer) {
    SocketLock lock(socket_mutex_, std::defer_lock);
    const bool is_other = std::this_thread::get_id() != thread_;
    if (!is_other || !lock.try_lock() || !mailbox_.empty()) return mailbox_.put(std::move(answer));
    const auto line = send(std::move(answer));
    // Sending takes note of what has arrived, so that the socket's descriptor does not tell of it any more.
    if (has_input(socket_.handle()) || !outbox_.empty() || is_draining()) mailbox_.wake();
    lock.unlock();
    if (line) write(*line);
}

/// What is to be written into the log then.
std::optional<RequestLine> Endpoint::send(Answer answer) {
    std::optional<RequestLine> line;
    if (!answer.is_progress) {
        if (answer.status != "OK") ++service_.parts().counters.requests_failed;
        service_.parts().request_metrics.record(answer);
        sent_ = Clock::now();
        service_.parts().open_calls.close(answer.number);
        line = line_of(answer);
    }
    outbox_.send(std::move(answer));
    return line;
}

void Endpoint::deliver() {
    outbox_.flush();
    std::vector<RequestLine> lines;
    for (Answer& answer : mailbox_.take_all())
        if (auto line = send(std::move(answer))) lines.push_back(std::move(*line));
    for (const RequestLine& line : lines) write(line);
}

void Endpoint::end_overdue() {
    const std::vector<CallPtr> overdue = service_.parts().open_calls.overdue(Clock::now());
    for (const CallPtr& call : overdue) call->check_deadline();
    if (!overdue.empty()) service_.parts().drop_abandoned();
}

long Endpoint::poll_milliseconds() {
    const auto next = std::min(
        {service_.parts().open_calls.next_deadline(), service_.parts().sessions.next_expiry(), unfinished_.next_look(), end_});
    long wait = -1;
    if (next != Clock::time_point::max())
        wait =
            std::max(0L, static_cast<long>(std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now()).count()));
    if (!outbox_.empty()) wait = wait < 0 ? backlog_poll_ms : std::min<long>(wait, backlog_poll_ms);
    return wait;
}

// --- the end ---------------------------------------------------------------------------------------------------------

bool Endpoint::is_idle() {
    deliver();  // what was answered since the last look
    return service_.parts().open_calls.count() == 0 && mailbox_.empty() && outbox_.empty();
}

void Endpoint::begin_drain(const Notifier& notifier) {
    const std::chrono::seconds time(config_.shutdown.drain_seconds);
    end_ = Clock::now() + time;
    service_.begin_drain();
    notifier.stopping("Finishing what was accepted",
                      time + std::chrono::ceil<std::chrono::seconds>(2 * linger) + stop_time);
    if (const auto open = service_.parts().open_calls.count())
        spdlog::info("up to {} s for {} open requests", time.count(), open);
}

void Endpoint::stop() {
    for (const auto& [route, call] : service_.parts().open_calls.take_all()) {
        if (call)
            call->fail(Service::stop_status());
        else
            mailbox_.put(refusal(route, "", Service::stop_status()));
    }
    service_.begin_stop();
    deliver();
    parser_.stop();  // what it had not read yet has been answered above
    parser_ended_ = true;
    service_.finish_stop();
    const auto patience = Clock::now() + linger;
    do {
        while (receive() && Clock::now() < patience) deliver();  // what arrives now is refused
        deliver();
        std::this_thread::sleep_for(std::chrono::milliseconds(backlog_poll_ms));
    } while (Clock::now() < patience && (!outbox_.empty() || Clock::now() < sent_ + settling));
}

}  // namespace contactd::server
