#include "endpoint.hpp"

#include <poll.h>
#include <spdlog/spdlog.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <thread>
#include <utility>

#include "contactd/error.hpp"
#include "log.hpp"

namespace contactd::server {

using Clock = Call::Clock;
using proto::Status;
using proto::StatusCode;

namespace {

/// Envelopes up to this size are read by the I/O thread itself; larger ones would keep others waiting.
constexpr std::size_t small_envelope = 64 << 10;
constexpr int messages_per_turn = 64;
constexpr int queue_retry_ms = 500;
constexpr int messages_in_socket = 32;
constexpr int backlog_poll_ms = 5;
constexpr auto linger = std::chrono::milliseconds(2000);  // of answers, for a client that reads slowly

// Closing a socket cuts off an answer that its client is still reading, lingering or not: it stays open so much longer.
constexpr auto settling = std::chrono::milliseconds(300);
constexpr auto stop_time = std::chrono::seconds(5);  // builders that do not end at once

constexpr std::string_view ipc_prefix = "ipc://";

/// The file of an ipc endpoint; empty for others, abstract names among them.
std::string socket_file(const std::string& endpoint) {
    if (!endpoint.starts_with(ipc_prefix) || endpoint.starts_with("ipc://@")) return {};
    return endpoint.substr(ipc_prefix.size());
}

/// True when a process accepts connections at the Unix socket `file`.
bool somebody_listens(const std::string& file) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (file.size() >= sizeof address.sun_path) return false;
    std::copy(file.begin(), file.end(), address.sun_path);
    const int fd = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const bool accepted = ::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    ::close(fd);
    return accepted;
}

void bind(zmq::socket_t& socket, const std::string& endpoint) {
    // ZeroMQ would take the path over from a daemon that still listens there.
    if (const std::string file = socket_file(endpoint); !file.empty() && somebody_listens(file))
        throw Error("endpoint is \"" + endpoint + "\"; another process listens there already.");
    const mode_t previous = ::umask(0077);  // an ipc socket is for this user only
    try {
        socket.bind(endpoint);
        ::umask(previous);
    } catch (const zmq::error_t& error) {
        ::umask(previous);
        throw Error("endpoint is \"" + endpoint + "\"; it cannot be listened at: " + error.what() + ".");
    }
}

/// A client as the log calls it: the identity of its connection in hexadecimal.
std::string name_of(const std::string& identity) {
    constexpr const char* digits = "0123456789abcdef";
    std::string name;
    for (const unsigned char byte : identity.substr(0, 16)) name += {digits[byte >> 4], digits[byte & 15]};
    return name;
}

/// One line a request: enough to find it again, nothing of what it holds.
void log_answer(const Answer& answer) {
    log_event(spdlog::level::info, "request",
              {{"id", answer.id},
               {"method", answer.method},
               {"status", answer.status},
               {"ms", std::round(answer.milliseconds * 1000) / 1000},
               {"client", name_of(answer.route.identity)}});
}

Status queue_full() {
    return {StatusCode::resource_exhausted,
            "Too many requests wait for an answer; try again later.",
            std::string(proto::reason::queue_full),
            {},
            queue_retry_ms};
}

}  // namespace

Endpoint::Endpoint(const Config& config, Service& service)
    : config_(config),
      service_(service),
      socket_(context_, zmq::socket_type::router),
      monitor_(context_, socket_),
      outbox_(socket_, config.max_outbox_bytes) {
    socket_.set(zmq::sockopt::router_mandatory, true);
    socket_.set(zmq::sockopt::linger, static_cast<int>(linger.count()));
    // ZeroMQ counts messages, not bytes: what it holds for each client must be few, so that our budgets mean something.
    socket_.set(zmq::sockopt::sndhwm, messages_in_socket);
    socket_.set(zmq::sockopt::rcvhwm, messages_in_socket);
    // A frame above this costs its sender the connection, without a word; up to it we can answer in words.
    socket_.set(zmq::sockopt::maxmsgsize, static_cast<std::int64_t>(2 * config.limits.max_frame_bytes));
    bind(socket_, config.endpoint);
}

Endpoint::~Endpoint() {
    const std::string file = socket_file(address());
    if (!file.empty()) ::unlink(file.c_str());  // ZeroMQ leaves it
}

std::string Endpoint::address() const {
    return socket_.get(zmq::sockopt::last_endpoint);
}

void Endpoint::run(int signal_fd, const Notifier& notifier, const std::function<void()>& reload) {
    std::array<zmq::pollitem_t, 4> items{{{socket_.handle(), 0, ZMQ_POLLIN, 0},
                                          {nullptr, mailbox_.fd(), ZMQ_POLLIN, 0},
                                          {nullptr, signal_fd, ZMQ_POLLIN, 0},
                                          {monitor_.handle(), 0, ZMQ_POLLIN, 0}}};
    service_.set_serving();
    notifier.ready("Serving at " + address());
    auto told = Clock::now();
    while (Clock::now() < end_ && !(is_draining() && is_idle())) {
        long wait = poll_milliseconds();
        if (const long interval = notifier.interval().count(); interval > 0)
            wait = wait < 0 ? interval : std::min(wait, interval);
        zmq::poll(items, std::chrono::milliseconds(wait));
        if (notifier.interval().count() > 0 && Clock::now() - told >= notifier.interval()) {
            notifier.alive();
            told = Clock::now();
        }
        deliver();
        if (items[0].revents & ZMQ_POLLIN) receive();
        end_overdue();
        if (items[3].revents & ZMQ_POLLIN) monitor_.read(service_.counters().connections);
        note_levels();
        signalfd_siginfo signal{};
        if (items[2].revents & ZMQ_POLLIN && ::read(signal_fd, &signal, sizeof signal) == sizeof signal)
            handle_signal(static_cast<int>(signal.ssi_signo), notifier, reload);
    }
    stop();
}

void Endpoint::note_levels() {
    Counters& counters = service_.counters();
    counters.outbox_bytes = static_cast<long long>(outbox_.bytes());
    const std::scoped_lock lock(mutex_);
    counters.open_requests = static_cast<long long>(open_.size());
}

void Endpoint::handle_signal(int signal, const Notifier& notifier, const std::function<void()>& reload) {
    if (signal == SIGHUP) {
        notifier.reloading();
        reload();
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
        Route route{part.to_string(), false};
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
        accept(std::move(route), std::move(envelope), std::move(frames));
    }
    return true;
}

void Endpoint::accept(Route route, std::string envelope, std::vector<std::string> frames) {
    const auto received = Clock::now();
    const bool is_small = envelope.size() <= small_envelope;
    ++service_.counters().requests;
    if (!is_small && parsing_ >= static_cast<int>(config_.max_queue))
        return mailbox_.put(refusal(std::move(route), "", queue_full()));
    auto parse = [this, received, route = std::move(route), envelope = std::move(envelope),
                  frames = std::move(frames)]() mutable {
        std::string id;
        try {
            open_call(route, proto::parse_request(envelope, std::move(frames), config_.limits, id), received);
        } catch (const std::exception& error) {
            mailbox_.put(refusal(route, id, status_of(error)));
        }
    };
    if (is_small || workers_ended_) return parse();
    ++parsing_;
    service_.defer([this, parse = std::move(parse)]() mutable {
        parse();
        --parsing_;
    });
}

void Endpoint::open_call(Route route, proto::Request request, Clock::time_point received) {
    auto call = std::make_shared<Call>(std::move(route), std::move(request), received,
                                       [this](Answer answer) { mailbox_.put(std::move(answer)); });
    if (!service_.is_quick(call->request.method)) {
        const std::scoped_lock lock(mutex_);
        std::erase_if(open_, [](const CallPtr& known) { return known->answered(); });
        if (open_.size() >= config_.max_queue) return call->fail(queue_full());
        open_.push_back(call);
    }
    service_.handle(std::move(call));
}

// --- out -------------------------------------------------------------------------------------------------------------

void Endpoint::deliver() {
    outbox_.flush();
    for (Answer& answer : mailbox_.take_all()) {
        if (!answer.is_progress) {
            if (answer.status != "OK") ++service_.counters().requests_failed;
            service_.request_metrics().record(answer);
            log_answer(answer);
            sent_ = Clock::now();
        }
        outbox_.send(std::move(answer));
    }
}

void Endpoint::end_overdue() {
    const auto now = Clock::now();
    std::vector<CallPtr> overdue;
    {
        const std::scoped_lock lock(mutex_);
        std::erase_if(open_, [](const CallPtr& call) { return call->answered(); });
        std::copy_if(open_.begin(), open_.end(), std::back_inserter(overdue),
                     [&](const CallPtr& call) { return call->deadline() <= now; });
    }
    for (const CallPtr& call : overdue)
        call->fail({StatusCode::deadline_exceeded,
                    "The answer was not ready within " + std::to_string(call->request.timeout_ms) + " ms.",
                    std::string(proto::reason::deadline_passed),
                    {},
                    0});
}

long Endpoint::poll_milliseconds() {
    auto next = Clock::time_point::max();
    {
        const std::scoped_lock lock(mutex_);
        for (const CallPtr& call : open_)
            if (!call->answered()) next = std::min(next, call->deadline());
    }
    long wait = -1;
    next = std::min(next, end_);
    if (next != Clock::time_point::max())
        wait =
            std::max(0L, static_cast<long>(std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now()).count()));
    if (!outbox_.empty()) wait = wait < 0 ? backlog_poll_ms : std::min<long>(wait, backlog_poll_ms);
    return wait;
}

// --- the end ---------------------------------------------------------------------------------------------------------

bool Endpoint::is_idle() {
    deliver();  // what was answered since the last look
    const std::scoped_lock lock(mutex_);
    std::erase_if(open_, [](const CallPtr& call) { return call->answered(); });
    return open_.empty() && parsing_ == 0 && mailbox_.empty() && outbox_.empty();
}

void Endpoint::begin_drain(const Notifier& notifier) {
    const std::chrono::seconds time(config_.shutdown.drain_seconds);
    end_ = Clock::now() + time;
    service_.begin_drain();
    notifier.stopping("Finishing what was accepted",
                      time + std::chrono::ceil<std::chrono::seconds>(2 * linger) + stop_time);
    const std::scoped_lock lock(mutex_);
    if (!open_.empty()) spdlog::info("up to {} s for {} open requests", time.count(), open_.size());
}

void Endpoint::stop() {
    std::vector<CallPtr> open;
    {
        const std::scoped_lock lock(mutex_);
        open.swap(open_);
    }
    for (const CallPtr& call : open) call->fail(Service::stop_status());
    service_.begin_stop();
    deliver();
    // Large envelopes that workers still read are answered too; what the workers do has been told to end.
    for (const auto patience = Clock::now() + stop_time; parsing_ > 0 && Clock::now() < patience;)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    service_.finish_stop();
    workers_ended_ = true;
    const auto patience = Clock::now() + linger;
    do {
        while (receive() && Clock::now() < patience) deliver();  // what arrives now is refused
        deliver();
        std::this_thread::sleep_for(std::chrono::milliseconds(backlog_poll_ms));
    } while (Clock::now() < patience && (!outbox_.empty() || Clock::now() < sent_ + settling));
}

}  // namespace contactd::server
