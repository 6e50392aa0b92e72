#include "fake_daemon.hpp"

#include <chrono>

namespace fake {

using nlohmann::json;

Daemon::Daemon(Script script) : script_(std::move(script)), socket_(context_, zmq::socket_type::router) {
    socket_.set(zmq::sockopt::linger, 0);
    socket_.set(zmq::sockopt::rcvtimeo, 20);
    socket_.bind("tcp://127.0.0.1:*");
    endpoint_ = socket_.get(zmq::sockopt::last_endpoint);
    thread_ = std::thread([this] { run(); });
}

Daemon::~Daemon() {
    stop_ = true;
    thread_.join();
}

void Daemon::run() {
    while (!stop_) {
        Frames message;
        zmq::message_t part;
        if (!socket_.recv(part)) continue;
        message.push_back(part.to_string());
        while (part.more() && socket_.recv(part)) message.push_back(part.to_string());
        const Frames frames(message.begin() + 2, message.end());
        for (const Frames& answer : script_(json::parse(message[1].bytes()), frames)) {
            socket_.send(zmq::buffer(message[0].bytes()), zmq::send_flags::sndmore);
            for (std::size_t i = 0; i < answer.size(); ++i)
                socket_.send(zmq::buffer(answer[i].bytes()),
                             i + 1 < answer.size() ? zmq::send_flags::sndmore : zmq::send_flags::none);
        }
    }
}

std::string reply(const json& request, const json& result) {
    return json{{"contactd", 1},
                {"id", request["id"]},
                {"status", {{"code", 0}, {"name", "OK"}, {"message", ""}}},
                {"result", result}}
        .dump();
}

std::string failure(const json& request, const json& status) {
    return json{{"contactd", 1}, {"id", request["id"]}, {"status", status}}.dump();
}

std::string progress(const json& request, const json& values) {
    return json{{"contactd", 1}, {"id", request["id"]}, {"progress", values}}.dump();
}

}  // namespace fake
