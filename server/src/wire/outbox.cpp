#include "outbox.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <memory>
#include <utility>

namespace contactd::server {
namespace {

/// Includes the overhead of an entry, so that empty answers also count.
std::size_t bytes_of(const Answer& answer) {
    std::size_t bytes = sizeof answer + answer.route.identity.size() + answer.envelope.size();
    for (const auto& frame : answer.frames) bytes += sizeof frame + frame.size();
    return bytes;
}

/// Holds a frame that ZeroMQ sends without a copy, and the counter of its bytes.
struct KeptFrame {
    proto::Frame frame;
    std::shared_ptr<const void> counted;
};

/// Called by ZeroMQ's own thread after the frame was sent.
void free_sent_frame(void*, void* frame) {
    delete static_cast<const KeptFrame*>(frame);
}

/// Keeps large frames until ZeroMQ has sent them, instead of copying them.
zmq::message_t message_of(proto::Frame frame, const std::shared_ptr<const void>& counted) {
    constexpr std::size_t large = 1 << 16;
    if (frame.size() < large) return zmq::message_t(frame.bytes());
    auto kept = std::make_unique<KeptFrame>(KeptFrame{std::move(frame), counted});
    // ZeroMQ requires a non-const pointer but does not change the data.
    zmq::message_t message(const_cast<char*>(kept->frame.data()), kept->frame.size(), free_sent_frame, kept.get());
    (void)kept.release();
    return message;
}

}  // namespace

Outbox::Sent Outbox::try_send(Answer& answer) {
    // ROUTER decides on the whole message at its first part: EAGAIN if the client's queue is full, EHOSTUNREACH if the
    // client disconnected. Later parts are sent without waiting.
    const auto part = [&](proto::Frame frame, bool more) {
        socket_.send(message_of(std::move(frame), answer.counted),
                     more ? zmq::send_flags::sndmore : zmq::send_flags::none);
    };
    try {
        const auto first = zmq::send_flags::sndmore | zmq::send_flags::dontwait;
        if (!socket_.send(zmq::buffer(answer.route.identity), first)) return Sent::later;
        if (answer.route.empty_delimiter) part("", true);
        part(std::move(answer.envelope), !answer.frames.empty());
        for (std::size_t n = 0; n < answer.frames.size(); ++n)
            part(std::move(answer.frames[n]), n + 1 < answer.frames.size());
        return Sent::yes;
    } catch (const zmq::error_t& error) {
        if (error.num() == EAGAIN) return Sent::later;
        return Sent::never;
    }
}

void Outbox::send(Answer answer) {
    if (!backlogs_.contains(answer.route.identity)) {
        const Sent sent = try_send(answer);
        if (sent == Sent::never) spdlog::debug("answer dropped: its client disconnected");
        if (sent != Sent::later) return;
    }
    if (!answer.is_progress) keep(std::move(answer));
}

void Outbox::keep(Answer answer) {
    const std::size_t bytes = bytes_of(answer);
    Backlog& kept = backlogs_[answer.route.identity];
    kept.answers.push_back(std::move(answer));
    kept.bytes += bytes;
    bytes_ += bytes;
    while (bytes_ > max_bytes_) {
        const auto most = std::max_element(backlogs_.begin(), backlogs_.end(), [](const auto& a, const auto& b) {
            return a.second.bytes < b.second.bytes;
        });
        spdlog::warn("{} answers dropped: a client does not read its answers", most->second.answers.size());
        drop(most);
    }
}

Outbox::Backlogs::iterator Outbox::drop(Backlogs::iterator client) {
    bytes_ -= client->second.bytes;
    return backlogs_.erase(client);
}

void Outbox::flush() {
    for (auto client = backlogs_.begin(); client != backlogs_.end();) {
        Backlog& kept = client->second;
        Sent sent = Sent::yes;
        while (!kept.answers.empty()) {
            const std::size_t bytes = bytes_of(kept.answers.front());
            sent = try_send(kept.answers.front());
            if (sent != Sent::yes) break;
            kept.bytes -= bytes;
            bytes_ -= bytes;
            kept.answers.pop_front();
        }
        client = kept.answers.empty() || sent == Sent::never ? drop(client) : std::next(client);
    }
}

}  // namespace contactd::server
