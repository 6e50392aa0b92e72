#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <chrono>
#include <future>
#include <string>
#include <thread>
#include <vector>
#include <zmq.hpp>

#include "contactd/error.hpp"
#include "wire/answering_socket.hpp"

using namespace contactd::server;
using namespace std::chrono_literals;

namespace {

constexpr int nothing = -1;  // no descriptor to wait for
constexpr long long_enough_ms = 30'000;

Answer answer_to(const std::string& client, const std::string& text) {
    Answer answer;
    answer.route.identity = client;
    answer.envelope = text;
    answer.status = "OK";
    return answer;
}

/// Holds a socket that this thread owns, and a client of it.
struct Wire {
    Config config = contactd::server::config_from_json({{"limits", {{"max_frames", 3}}}});
    zmq::context_t context;
    AccessControl access{config, context};
    std::vector<std::string> noted;
    AnsweringSocket socket{context, access, config, [this](const Answer& a) { noted.push_back(a.envelope); }};
    zmq::socket_t client{context, zmq::socket_type::dealer};

    Wire() {
        socket.bind("inproc://answers");
        client.set(zmq::sockopt::routing_id, "client");
        client.set(zmq::sockopt::rcvtimeo, static_cast<int>(long_enough_ms));
        client.connect("inproc://answers");
        send({"hello"});  // from now on it is known
        receive();
    }

    void send(const std::vector<std::string>& parts) {
        for (std::size_t n = 0; n < parts.size(); ++n)
            client.send(zmq::buffer(parts[n]), n + 1 < parts.size() ? zmq::send_flags::sndmore : zmq::send_flags::none);
    }
    Message receive() {
        std::optional<Message> message;
        while (!(message = socket.receive())) socket.wait(nothing, {}, long_enough_ms);
        return *message;
    }
    std::string heard() {
        zmq::message_t part;
        return client.recv(part) ? part.to_string() : "nothing";
    }
};

}  // namespace

TEST_CASE("A message is taken apart into its client, its envelope and its frames") {
    Wire wire;
    wire.send({"{}", "one", "two"});
    const Message message = wire.receive();

    CHECK(message.route.identity == "client");
    CHECK_FALSE(message.route.empty_delimiter);
    CHECK(message.envelope == "{}");
    CHECK(message.frames == contactd::proto::Frames{"one", "two"});
    CHECK_FALSE(wire.socket.receive());
}

TEST_CASE("The empty part of a REQ socket is noted, and is no envelope") {
    Wire wire;
    wire.send({"", "{}", ""});
    const Message message = wire.receive();

    CHECK(message.route.empty_delimiter);
    CHECK(message.envelope == "{}");
    CHECK(message.frames == contactd::proto::Frames{""});
}

TEST_CASE("Of too many frames one more than allowed is kept") {
    Wire wire;
    wire.send({"{}", "1", "2", "3", "4", "5"});

    CHECK(wire.receive().frames == contactd::proto::Frames{"1", "2", "3"});
}

TEST_CASE("What the owner answers goes with the next delivery, and is noted then") {
    Wire wire;
    wire.socket.post(answer_to("client", "first"));
    CHECK(wire.noted.empty());
    CHECK(wire.socket.has_backlog());

    wire.socket.deliver();

    CHECK(wire.noted == std::vector<std::string>{"first"});
    CHECK(wire.heard() == "first");
    CHECK_FALSE(wire.socket.has_backlog());
    CHECK_FALSE(wire.socket.has_settled());
}

TEST_CASE("While the owner waits, another thread sends its answer itself") {
    Wire wire;
    auto client = std::async(std::launch::async, [&] {
        wire.socket.post(answer_to("client", "from outside"));
        const std::string heard = wire.heard();
        wire.socket.wake();
        return heard;
    });
    // The answer arrives exactly once, whether the lock was free or not.
    while (client.wait_for(0s) != std::future_status::ready) {
        wire.socket.wait(nothing, {}, long_enough_ms);
        wire.socket.deliver();
    }

    CHECK(client.get() == "from outside");
    CHECK(wire.noted == std::vector<std::string>{"from outside"});
}

TEST_CASE("While the owner works, an answer of another thread is left to it and ends its wait") {
    Wire wire;
    std::thread([&] { wire.socket.post(answer_to("client", "left")); }).join();
    CHECK(wire.noted.empty());

    wire.socket.wait(nothing, {}, long_enough_ms);
    wire.socket.deliver();

    CHECK(wire.heard() == "left");
}

TEST_CASE("Answers of many threads arrive all") {
    Wire wire;
    constexpr int threads = 4, answers = 50;
    std::atomic<int> ended = 0;
    std::vector<std::jthread> posting;
    for (int n = 0; n < threads; ++n)
        posting.emplace_back([&] {
            for (int k = 0; k < answers; ++k) wire.socket.post(answer_to("client", "x"));
            ++ended;
            wire.socket.wake();
        });
    auto heard = std::async(std::launch::async, [&] {
        int count = 0;
        while (count < threads * answers && wire.heard() == "x") ++count;
        wire.socket.wake();
        return count;
    });
    while (ended < threads || heard.wait_for(0s) != std::future_status::ready) {
        wire.socket.wait(nothing, {}, 50);
        wire.socket.deliver();
    }

    CHECK(heard.get() == threads * answers);
    CHECK(wire.noted.size() == threads * answers);
}

TEST_CASE("Progress goes unnoted") {
    Wire wire;
    Answer progress = answer_to("client", "half");
    progress.is_progress = true;
    wire.socket.post(progress);
    wire.socket.deliver();

    CHECK(wire.heard() == "half");
    CHECK(wire.noted.empty());
    CHECK(wire.socket.has_settled());
}

TEST_CASE("An address that cannot be listened at is named") {
    Wire wire;
    CHECK_THROWS_AS(wire.socket.bind("tcp://999.0.0.1:1"), contactd::Error);
}
