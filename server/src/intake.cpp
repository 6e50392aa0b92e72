#include "intake.hpp"

#include <memory>
#include <utility>

namespace contactd::server {
namespace {

constexpr std::size_t small_envelope = 64 << 10;

std::size_t bytes_of(const Message& message) {
    std::size_t bytes = message.envelope.size();
    for (const auto& frame : message.frames) bytes += frame.size();
    return bytes;
}

QueueTicket ticket_of(const Route& route) {
    return {.client = route.identity, .user = route.user};
}

}  // namespace

Intake::Intake(const Config& config, Service& service, AnsweringSocket& socket)
    : config_(config),
      service_(service),
      socket_(socket),
      open_calls_(service.parts().open_calls),
      rate_limit_(config.security.per_user.requests_per_second, config.security.per_user.burst) {}

void Intake::take(Message message) {
    const auto received = Clock::now();
    const bool is_small = message.envelope.size() <= small_envelope;
    ++service_.parts().counters.requests;
    if (!admit(message.route, is_small ? message.envelope : "", received)) return;
    if (is_small || stopped_) return read(std::move(message), received, {});
    try {
        OpenCalls::Admission admission = open_calls_.admit(message.route, bytes_of(message));
        QueueTicket ticket = ticket_of(message.route);
        reader_.post(std::move(ticket),
                     [this, received, message = std::move(message), admission = std::move(admission)]() mutable {
                         read(std::move(message), received, std::move(admission));
                     });
    } catch (const std::exception& error) {
        socket_.post(refusal(message.route, "", status_of(error)));
    }
}

/// Returns false, after an answer, if the sender may not send requests, or not now. Finds the id of the request in
/// `envelope`.
bool Intake::admit(const Route& route, std::string_view envelope, Clock::time_point received) {
    const bool revoked = route.user.empty();
    const auto wait = revoked ? std::chrono::milliseconds{0} : rate_limit_.take(route.user, received);
    if (!revoked && wait.count() == 0) return true;
    std::string id;
    try {
        if (!envelope.empty()) proto::parse_request(envelope, {}, config_.limits, id);
    } catch (const std::exception&) {
        // Only the id was needed, if there was one.
    }
    socket_.post(refusal(route, id, revoked ? key_revoked() : rate_limit_.refusal(wait)));
    return false;
}

void Intake::read(Message message, Clock::time_point received, OpenCalls::Admission admission) {
    const CallNumber number = admission.number;
    std::string id;
    try {
        open(message.route, proto::parse_request(message.envelope, std::move(message.frames), config_.limits, id),
             received, std::move(admission));
    } catch (const std::exception& error) {
        Answer answer = refusal(message.route, id, status_of(error));
        answer.number = number;
        socket_.post(std::move(answer));
    }
}

void Intake::open(const Route& route, proto::Request request, Clock::time_point received,
                  OpenCalls::Admission admission) {
    CallPtr call = service_.open(route, std::move(request), received, std::move(admission),
                                 [&socket = socket_](Answer answer) { socket.post(std::move(answer)); });
    if (!call) return;  // It was answered while it was read.
    if (call->request.method == "request.cancel" && open_calls_.has_unread(route.identity)) {
        // The unread request may be the one to cancel, so wait until it has been read.
        return reader_.post(ticket_of(route), [this, call] { service_.handle(call); });
    }
    const bool has_deadline = call->request.timeout_ms > 0;
    service_.handle(std::move(call));
    if (has_deadline && !socket_.is_owner()) socket_.wake();  // The wait must consider the new deadline.
}

void Intake::stop() {
    reader_.stop();
    stopped_ = true;
}

}  // namespace contactd::server
