#include "endpoint.hpp"

#include <spdlog/spdlog.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

namespace contactd::server {

using proto::Status;
using proto::StatusCode;

namespace {

constexpr int messages_per_look = 64;
constexpr auto stop_time = std::chrono::seconds(5);  // for builders that do not end immediately
constexpr auto look_interval = std::chrono::milliseconds(5);

const Status& client_gone() {
    static const Status status{
        StatusCode::cancelled, "The client disconnected.", std::string(proto::reason::client_gone), {}, 0};
    return status;
}

AnsweringSocket::NoteAnswer noted_by(const DaemonParts& parts) {
    return [&parts](const Answer& answer) { parts.note(answer); };
}

}  // namespace

Endpoint::Endpoint(const Config& config, Service& service)
    : config_(config),
      service_(service),
      parts_(service.parts()),
      access_(config, context_),
      socket_(context_, access_, config, noted_by(parts_)),
      connections_(context_, socket_.router(), config.max_inbox_bytes, parts_.counters.connections),
      memory_(parts_.budget, parts_.workers),
      intake_(config, service, socket_) {
    memory_.add(intake_.reader());
    socket_.bind(config.endpoint);
}

void Endpoint::run(int signal_fd, const Notifier& notifier, const std::function<void()>& reload) {
    parts_.health.set_listening();
    notifier.ready("Serving at " + address());
    auto notified = Clock::now();
    while (Clock::now() < end_ && !(is_draining() && is_idle())) {
        const bool is_signalled = wait(signal_fd, notifier);
        if (notifier.interval().count() > 0 && Clock::now() - notified >= notifier.interval()) {
            notifier.alive();
            notified = Clock::now();
        }
        socket_.deliver();
        receive();
        socket_.deliver();  // Sends immediate answers.
        end_overdue();
        parts_.sessions.expire(Clock::now());
        unused_ = parts_.engine.forget_unused(Clock::now());
        memory_.look(Clock::now(), parts_.workers.waiting() + parts_.workers.running() > 0,
                     parts_.sessions.bytes() + parts_.engine.influences().usage().bytes);
        connections_.bound_input(Clock::now());
        connections_.read();
        end_gone();
        access_.answer_all();
        note_levels();
        signalfd_siginfo signal{};
        if (is_signalled && ::read(signal_fd, &signal, sizeof signal) == sizeof signal)
            handle_signal(static_cast<int>(signal.ssi_signo), notifier, reload);
    }
    stop();
}

/// Waits for events. Returns true if a signal has arrived.
bool Endpoint::wait(int signal_fd, const Notifier& notifier) {
    const auto next = std::min({parts_.open_calls.next_deadline(), parts_.sessions.next_expiry(),
                                connections_.next_look(), memory_.next_look(), unused_, end_});
    long timeout = -1;
    if (next != Clock::time_point::max()) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now());
        timeout = std::max(0L, static_cast<long>(left.count()));
    }
    if (const long interval = notifier.interval().count(); interval > 0)
        timeout = timeout < 0 ? interval : std::min(timeout, interval);
    return socket_.wait(signal_fd, std::array{connections_.handle(), access_.handle()}, timeout);
}

bool Endpoint::receive() {
    for (int n = 0; n < messages_per_look; ++n) {
        std::optional<Message> message = socket_.receive();
        if (!message) return false;
        const bool is_there = connections_.note_message(message->connection, message->route.identity);
        if (is_there) intake_.take(std::move(*message));
    }
    return true;
}

void Endpoint::note_levels() {
    parts_.counters.outbox_bytes = static_cast<long long>(socket_.backlog_bytes());
    parts_.counters.open_requests = static_cast<long long>(parts_.open_calls.count());
}

void Endpoint::handle_signal(int signal, const Notifier& notifier, const std::function<void()>& reload) {
    if (signal == SIGHUP) {
        notifier.reloading();
        reload();
        access_.reload();
        end_revoked();
        return notifier.ready("Serving at " + address());
    }
    spdlog::info("ending on {}", ::strsignal(signal));
    if (is_draining())
        end_ = Clock::now();
    else
        begin_drain(notifier);
}

// --- requests that end before their work does ------------------------------------------------------------------------

void Endpoint::end_overdue() {
    const std::vector<CallPtr> overdue = parts_.open_calls.overdue(Clock::now());
    for (const CallPtr& call : overdue) call->check_deadline();
    if (!overdue.empty()) parts_.drop_abandoned();
}

/// Ends the requests of disconnected clients.
void Endpoint::end_gone() {
    const std::vector<std::string> clients = connections_.take_gone();
    for (const std::string& client : clients) {
        for (const auto& [number, entry] : parts_.open_calls.of(client)) {
            if (entry.call && entry.call->outlives_client()) continue;
            if (entry.call) {
                entry.call->fail(client_gone());
                continue;
            }
            Answer answer = refusal(entry.route, "", client_gone());
            answer.number = number;
            socket_.post(std::move(answer));
        }
    }
    if (!clients.empty()) parts_.drop_abandoned();
}

/// Ends the requests of users who are no longer allowed.
void Endpoint::end_revoked() {
    for (const auto& [route, call] : parts_.open_calls.all())
        if (call && !access_.knows(route.user)) call->fail(key_revoked());
    parts_.drop_abandoned();
}

// --- the end ---------------------------------------------------------------------------------------------------------

bool Endpoint::is_idle() {
    socket_.deliver();  // Sends answers posted since the last check.
    return parts_.open_calls.count() == 0 && !socket_.has_backlog();
}

void Endpoint::begin_drain(const Notifier& notifier) {
    const std::chrono::seconds time(config_.shutdown.drain_seconds);
    end_ = Clock::now() + time;
    socket_.wake_at_answers();
    service_.begin_drain();
    notifier.stopping("Finishing accepted requests",
                      time + std::chrono::ceil<std::chrono::seconds>(2 * AnsweringSocket::linger) + stop_time);
    if (const auto open = parts_.open_calls.count())
        spdlog::info("up to {} s for {} open requests", time.count(), open);
}

void Endpoint::stop() {
    for (const auto& [route, call] : parts_.open_calls.take_all()) {
        if (call)
            call->fail(Service::stop_status());
        else
            socket_.post(refusal(route, "", Service::stop_status()));
    }
    service_.begin_stop();
    socket_.deliver();
    intake_.stop();  // The reader's unread requests have been answered above.
    service_.finish_stop();
    const auto deadline = Clock::now() + AnsweringSocket::linger;
    do {
        while (receive() && Clock::now() < deadline) socket_.deliver();  // Refuses requests that arrive now.
        socket_.deliver();
        std::this_thread::sleep_for(look_interval);
    } while (Clock::now() < deadline && !socket_.has_settled());
}

}  // namespace contactd::server
