#include "outbox.hpp"

#include <spdlog/spdlog.h>

#include <cerrno>

namespace contactd::server {
namespace {

std::size_t bytes_of(const Answer& answer) {
    std::size_t bytes = answer.envelope.size();
    for (const auto& frame : answer.frames) bytes += frame.size();
    return bytes;
}

}  // namespace

Outbox::Sent Outbox::try_send(const Answer& answer) {
    // ROUTER answers for the whole message at its first part: EAGAIN when the client's queue is full, EHOSTUNREACH when
    // the client has gone. Later parts follow without waiting.
    const auto part = [&](const std::string& bytes, bool more) {
        socket_.send(zmq::buffer(bytes), more ? zmq::send_flags::sndmore : zmq::send_flags::none);
    };
    try {
        const auto first = zmq::send_flags::sndmore | zmq::send_flags::dontwait;
        if (!socket_.send(zmq::buffer(answer.route.identity), first)) return Sent::later;
        if (answer.route.empty_delimiter) part("", true);
        part(answer.envelope, !answer.frames.empty());
        for (std::size_t n = 0; n < answer.frames.size(); ++n) part(answer.frames[n], n + 1 < answer.frames.size());
        return Sent::yes;
    } catch (const zmq::error_t& error) {
        if (error.num() == EAGAIN) return Sent::later;
        return Sent::never;
    }
}

void Outbox::send(Answer answer) {
    const auto backlog = backlogs_.find(answer.route.identity);
    if (backlog == backlogs_.end()) {
        const Sent sent = try_send(answer);
        if (sent == Sent::never) spdlog::debug("answer dropped: its client has gone");
        if (sent != Sent::later) return;
    }
    if (answer.is_progress) return;
    Backlog& kept = backlogs_[answer.route.identity];
    kept.bytes += bytes_of(answer);
    if (kept.bytes > max_bytes_per_client_) {
        spdlog::warn("answers dropped: a client does not read what it asked for");
        backlogs_.erase(answer.route.identity);
        return;
    }
    kept.answers.push_back(std::move(answer));
}

void Outbox::flush() {
    for (auto client = backlogs_.begin(); client != backlogs_.end();) {
        Backlog& kept = client->second;
        Sent sent = Sent::yes;
        while (!kept.answers.empty() && sent == Sent::yes) {
            sent = try_send(kept.answers.front());
            if (sent != Sent::yes) break;
            kept.bytes -= bytes_of(kept.answers.front());
            kept.answers.pop_front();
        }
        client = kept.answers.empty() || sent == Sent::never ? backlogs_.erase(client) : std::next(client);
    }
}

}  // namespace contactd::server
