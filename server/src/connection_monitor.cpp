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
    events_.connect(channel);
}

ConnectionMonitor::~ConnectionMonitor() {
    ::zmq_socket_monitor(watched_.handle(), nullptr, 0);
}

void ConnectionMonitor::read(Counters::Count& connections) {
    // Two frames: event (16 bits) and its value (32 bits), then an address.
    zmq::message_t frame;
    while (events_.recv(frame, zmq::recv_flags::dontwait)) {
        std::uint16_t event = 0;
        if (frame.size() >= sizeof event) std::memcpy(&event, frame.data(), sizeof event);
        while (frame.more() && events_.recv(frame, zmq::recv_flags::none)) continue;
        if (event == ZMQ_EVENT_ACCEPTED) ++connections;
        if (event == ZMQ_EVENT_DISCONNECTED && connections > 0) --connections;
    }
}

}  // namespace contactd::server
