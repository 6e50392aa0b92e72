#include "connection_monitor.hpp"

#include <cstdint>
#include <cstring>

namespace contactd::server {
namespace {

constexpr const char* channel = "inproc://contactd-connections";

}  // namespace

ConnectionMonitor::ConnectionMonitor(zmq::context_t& context, zmq::socket_t& watched, std::size_t max_input_bytes,
                                     Counters::Count& connections)
    : watched_(watched), events_(context, zmq::socket_type::pair), connections_(connections), input_(max_input_bytes) {
    if (::zmq_socket_monitor(watched_.handle(), channel, ZMQ_EVENT_ACCEPTED | ZMQ_EVENT_DISCONNECTED) != 0)
        throw zmq::error_t();
    events_.set(zmq::sockopt::linger, 0);
    // With a limit, ZeroMQ's own thread would wait for this one to read, even at the end, when it no longer reads.
    events_.set(zmq::sockopt::rcvhwm, 0);
    events_.connect(channel);
}

ConnectionMonitor::~ConnectionMonitor() {
    ::zmq_socket_monitor(watched_.handle(), nullptr, 0);
}

void ConnectionMonitor::read() {
    // Reads two frames: the event (16 bits) with its value (32 bits, here the file descriptor), then an address.
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
            ++connections_;
            input_.note_connection(fd);
            clients_.note_connection(fd);
        }
        if (event == ZMQ_EVENT_DISCONNECTED) {
            if (connections_ > 0) --connections_;
            input_.note_end(fd);
            clients_.note_end(fd);
        }
    }
}

bool ConnectionMonitor::note_message(int fd, const std::string& client) {
    input_.note_message(fd);
    if (!clients_.knows(fd, client)) read();
    return clients_.note_message(fd, client);
}

}  // namespace contactd::server
