// Tests answers to clients that read, that are slow, and that do not read at all.
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <thread>

#include "wire/outbox.hpp"

using namespace contactd::server;

namespace {

constexpr int queue_of_socket = 2;

/// Holds a ROUTER like the daemon's, and the address clients connect to.
struct Server {
    zmq::context_t context;
    zmq::socket_t router{context, zmq::socket_type::router};

    Server() {
        router.set(zmq::sockopt::router_mandatory, true);
        router.set(zmq::sockopt::sndhwm, queue_of_socket);
        router.set(zmq::sockopt::linger, 0);
        router.bind("inproc://outbox");
    }
};

/// Waits up to ten seconds until `condition` holds.
void eventually(const std::function<bool()>& condition) {
    for (int n = 0; n < 10'000 && !condition(); ++n) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Holds a client that has sent a message, so that the ROUTER knows it.
struct Client {
    zmq::socket_t dealer;

    Client(Server& server, const std::string& name) : dealer(server.context, zmq::socket_type::dealer) {
        dealer.set(zmq::sockopt::routing_id, name);
        dealer.set(zmq::sockopt::rcvhwm, queue_of_socket);
        dealer.set(zmq::sockopt::linger, 0);
        dealer.connect("inproc://outbox");
        (void)dealer.send(zmq::str_buffer("hello"));
        zmq::message_t identity, hello;
        REQUIRE(server.router.recv(identity));
        REQUIRE(server.router.recv(hello));
    }

    /// Returns the next answer's envelope; empty if there is none.
    std::string read() {
        zmq::message_t part;
        if (!dealer.recv(part, zmq::recv_flags::dontwait)) return {};
        std::string text = part.to_string();
        while (part.more()) REQUIRE(dealer.recv(part));
        return text;
    }

    /// Returns the next answer's envelope, which `outbox` may still have to send, because ZeroMQ notices free space
    /// after a moment.
    std::string read_from(Outbox& outbox) {
        std::string text;
        eventually([&] {
            outbox.flush();
            text = read();
            return !text.empty();
        });
        return text;
    }
};

Answer answer_to(const std::string& name, const std::string& text, std::size_t frame_bytes = 0) {
    Answer answer{{name, false}, text, {}, false, {}, {}, {}, 0, {}, {}, 0};
    if (frame_bytes > 0) answer.frames.emplace_back(std::string(frame_bytes, 'x'));
    return answer;
}

}  // namespace

TEST_CASE("A slow client gets every answer, in order", "[outbox]") {
    Server server;
    Client slow(server, "slow");
    Outbox outbox(server.router, 1u << 20u);
    for (int n = 0; n < 100; ++n) outbox.send(answer_to("slow", std::to_string(n), 10));
    CHECK_FALSE(outbox.empty());
    for (int n = 0; n < 100; ++n) {
        CHECK(slow.read_from(outbox) == std::to_string(n));
    }
    CHECK(outbox.empty());
    CHECK(outbox.bytes() == 0);
}

TEST_CASE("Progress does not wait for a slow client", "[outbox]") {
    Server server;
    Client slow(server, "slow");
    Outbox outbox(server.router, 1u << 20u);
    int sent = 0;
    while (outbox.empty()) outbox.send(answer_to("slow", std::to_string(sent++)));
    Answer progress = answer_to("slow", "progress");
    progress.is_progress = true;
    const std::size_t kept = outbox.bytes();
    outbox.send(progress);
    CHECK(outbox.bytes() == kept);
    for (int n = 0; n < sent; ++n) {
        CHECK(slow.read_from(outbox) == std::to_string(n));
    }
    CHECK(slow.read().empty());
}

TEST_CASE("Beyond the budget of all clients the one with the most loses its answers", "[outbox]") {
    Server server;
    Client silent(server, "silent"), slow(server, "slow");
    constexpr std::size_t budget = 100'000;
    Outbox outbox(server.router, budget);
    std::size_t most = 0;
    for (int n = 0; n < 1000; ++n) {
        outbox.send(answer_to("silent", "large", 5000));
        if (n < 20) outbox.send(answer_to("slow", std::to_string(n)));
        most = std::max(most, outbox.bytes());
    }
    CHECK(most > budget / 2);
    CHECK(most <= budget);
    for (int n = 0; n < 20; ++n) {
        CHECK(slow.read_from(outbox) == std::to_string(n));
    }
}

TEST_CASE("What waits for a client goes with it", "[outbox]") {
    Server server;
    Outbox outbox(server.router, 1u << 20u);
    {
        Client leaving(server, "leaving");
        for (int n = 0; n < 20; ++n) outbox.send(answer_to("leaving", "text"));
        CHECK_FALSE(outbox.empty());
    }
    eventually([&] {
        zmq::message_t part;
        (void)server.router.recv(part, zmq::recv_flags::dontwait);  // where ZeroMQ learns that the client has gone
        outbox.flush();
        return outbox.empty();
    });
    CHECK(outbox.empty());
    CHECK(outbox.bytes() == 0);
}
