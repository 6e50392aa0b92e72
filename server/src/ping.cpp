#include "ping.hpp"

#include <nlohmann/json.hpp>
#include <zmq.hpp>

#include "contactd/proto/message.hpp"

namespace contactd::server {

using nlohmann::json;

PingResult ping(const std::string& endpoint, std::chrono::milliseconds patience) {
    try {
        zmq::context_t context;
        zmq::socket_t socket(context, zmq::socket_type::dealer);
        socket.set(zmq::sockopt::linger, 0);
        socket.set(zmq::sockopt::rcvtimeo, static_cast<int>(patience.count()));
        socket.connect(endpoint);
        const json request{{"contactd", proto::protocol_version}, {"id", "ping"}, {"method", "server.health"}};
        socket.send(zmq::buffer(request.dump()), zmq::send_flags::none);
        zmq::message_t reply;
        if (!socket.recv(reply))
            return {false, "No answer from " + endpoint + " within " + std::to_string(patience.count()) + " ms."};
        const json answer = json::parse(reply.to_string_view());
        const json& status = answer.at("status");
        if (status.at("code") != 0) return {false, status.at("message").get<std::string>()};
        const std::string state = answer.at("result").at("state");
        return {state == "serving", state};
    } catch (const std::exception& error) {
        return {false, endpoint + " cannot be asked: " + error.what() + "."};
    }
}

}  // namespace contactd::server
