#include "connection_monitor.hpp"

#include <cstdint>
#include <cstring>

namespace contactd::server {
namespace {

constexpr const char* channel = "inproc://contactd-connections";

}  // namespace

ConnectionMonitor::ConnectionMonitor(zmq::context_t& context, zmq::socket_t& watched)
    : watched_(watched), events_(context, zmq::socket_type::pair) {
    if (::zmq_socket_monitor(watched_.handle(), channel, ZMQ_EVENT_ACCEPTED | ZMQ_EVENT_DISCONNECTED) != 0)
        throw zmq::error_t();
    events_.set(zmq::sockopt::linger, 0);
    // Were there a limit, ZeroMQ's own thread would wait for this one to read, also at the end, when it reads no more.
    events_.set(zmq::sockopt::rcvhwm, 0);
    events_.connect(channel);
}

ConnectionMonitor::~ConnectionMonitor() {
    ::zmq_socket_monitor(watched_.handle(), nullptr, 0);
}

void ConnectionMonitor::read(Counters::Count& connections, UnfinishedInput& input, ClientConnections& clients) {
    // Two frames: event (16 bits) and its value (32 bits, here the file descriptor), then an address.
    zmq::message_t frame;
    while (events_.recv(frame, zmq::recv_flags::dontwait)) {
        std::uint16_t event = 0;
        std::int32_t fd = -1;
        if (frame.size() >= sizeof event + sizeof fd) {
            std::memcpy(&event, frame.data(), sizeof event);
            std::memcpy(&fd, static_cast<const char*>(frame.data()) + sizeof event, sizeof fd);
        }
        while (frame.more() && events_.recv(frame, zmq::recv_flags::none)) continue;
        if (event == ZMQ_EVENT_ACCEPTED) {
            ++connections;
            input.note_connection(fd);
            clients.note_connection(fd);
        }
        if (event == ZMQ_EVENT_DISCONNECTED) {
            if (connections > 0) --connections;
            input.note_end(fd);
            clients.note_end(fd);
        }
    }
}

}  // namespace contactd::server
