#include "in_process.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <shared_mutex>
#include <thread>

#include "config/config.hpp"
#include "contactd/error.hpp"
#include "contactd/proto/json_reader.hpp"
#include "operation/versions.hpp"
#include "service.hpp"

namespace contactd::server {
namespace {

Config config_from_text(std::string_view text) {
    nlohmann::json given;
    proto::read_json(text, max_config_values, given, "The configuration");
    return config_from_json(given);
}

Host host_with(const InProcess::Log& log) {
    Host host{.libraries = service_library_versions(), .callers_wait = true};
    if (log)
        host.log = [log](engine::LogLevel level, const std::string& line) {
            log(static_cast<InProcess::Level>(level), line);
        };
    return host;
}

/// Passes messages to the single waiting thread.
class Messages {
   public:
    void put(Exchange::Message message) {
        {
            const std::scoped_lock lock(mutex_);
            messages_.push_back(std::move(message));
            has_some_ = true;
        }
        changed_.notify_one();
    }
    /// Polls for a message for the time `spin` before it sleeps.
    std::optional<Exchange::Message> take(Exchange::Clock::time_point until, std::chrono::microseconds spin) {
        for (const auto end = Exchange::Clock::now() + spin; !has_some_ && Exchange::Clock::now() < end;)
            std::this_thread::yield();
        std::unique_lock lock(mutex_);
        if (!changed_.wait_until(lock, until, [this] { return !messages_.empty(); })) return std::nullopt;
        Exchange::Message first = std::move(messages_.front());
        messages_.pop_front();
        has_some_ = !messages_.empty();
        return first;
    }

   private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Exchange::Message> messages_;
    std::atomic<bool> has_some_ = false;
};

Exchange::Message message_of(Answer answer) {
    Exchange::Message message{std::move(answer.envelope)};
    std::move(answer.frames.begin(), answer.frames.end(), std::back_inserter(message));
    return message;
}

}  // namespace

struct InProcess::State {
    State(std::string_view text, const Log& log) : config(config_from_text(text)), service(config, host_with(log)) {
        service.parts().health.set_listening();
    }

    void note(const Answer& answer) {
        const std::scoped_lock lock(noting);
        service.parts().note(answer);
        service.parts().counters.open_requests = static_cast<long long>(service.parts().open_calls.count());
    }

    const Config config;
    std::mutex noting;
    std::atomic<unsigned long long> last_client = 0;
    std::shared_mutex closing;  // Each request holds a shared lock.
    bool closed = false;
    Service service;  // is destroyed first, because its threads use everything above
};

namespace {

class OpenExchange final : public Exchange {
   public:
    OpenExchange(std::shared_ptr<void> owner, const DaemonParts& parts)
        : owner_(std::move(owner)), parts_(parts), spin_(parts.config.spin) {}
    ~OpenExchange() override {
        if (::getpid() == process_) give_up();  // A forked process must not, because locks may stay locked there.
    }
    OpenExchange(const OpenExchange&) = delete;
    OpenExchange& operator=(const OpenExchange&) = delete;

    std::optional<Message> next(Clock::time_point until) override {
        const auto deadline = call_ ? call_->deadline() : Clock::time_point::max();
        if (auto message = messages_->take(std::min(until, deadline), std::exchange(spin_, {}))) return message;
        if (Clock::now() < deadline) return std::nullopt;
        call_->check_deadline();
        parts_.drop_abandoned();
        return messages_->take(until, {});
    }
    void cancel() override { give_up(); }

    const std::shared_ptr<Messages>& messages() const { return messages_; }
    void wait_for(CallPtr call) { call_ = std::move(call); }

   private:
    void give_up() {
        if (!call_ || call_->answered()) return;
        call_->fail({proto::StatusCode::cancelled,
                     "The request was cancelled by its client.",
                     std::string(proto::reason::request_cancelled),
                     {},
                     0});
        parts_.drop_abandoned();
    }

    const int process_ = ::getpid();
    const std::shared_ptr<void> owner_;  // of the parts
    const DaemonParts& parts_;
    std::chrono::microseconds spin_;  // is used once, at the first wait for the answer
    const std::shared_ptr<Messages> messages_ = std::make_shared<Messages>();
    CallPtr call_;  // is null for an unreadable message
};

}  // namespace

InProcess::InProcess(std::string_view config, Log log)
    : owner_(::getpid()), state_(std::make_shared<State>(config, log)) {}

InProcess::~InProcess() {
    if (::getpid() == owner_)
        close();
    else
        new std::shared_ptr<State>(std::move(state_));  // kept for ever
}

std::unique_ptr<Exchange> InProcess::ask(const std::string& envelope, proto::Frames frames) {
    if (::getpid() != owner_) throw Error("The service belongs to process " + std::to_string(owner_) + ".");
    const std::shared_lock open(state_->closing);
    if (state_->closed) throw Error("The service is closed.");
    const auto received = Call::Clock::now();
    State& state = *state_;
    const DaemonParts& parts = state.service.parts();
    ++parts.counters.requests;
    parts.sessions.expire(received);
    parts.engine.forget_unused(received);
    auto exchange = std::make_unique<OpenExchange>(state_, parts);
    const auto post = [&state, messages = exchange->messages()](Answer answer) {
        if (!answer.is_progress) state.note(answer);
        messages->put(message_of(std::move(answer)));
    };
    // Each request counts as a separate client, as with a daemon, where simultaneous calls use separate sockets.
    const Route route{.identity = std::to_string(++state.last_client), .user = "local"};
    std::string id;
    try {
        CallPtr call = state.service.open(
            route, proto::parse_request(envelope, std::move(frames), state.config.limits, id), received, {}, post);
        exchange->wait_for(call);
        state.service.handle(std::move(call));
    } catch (const std::exception& error) {
        post(refusal(route, id, status_of(error)));
    }
    return exchange;
}

void InProcess::close() {
    {
        const std::unique_lock nobody_asks(state_->closing);
        if (std::exchange(state_->closed, true)) return;
    }
    state_->service.begin_drain();
    for (const auto& [route, call] : state_->service.parts().open_calls.take_all())
        if (call) call->fail(Service::stop_status());
    state_->service.begin_stop();
    state_->service.finish_stop();
}

}  // namespace contactd::server
