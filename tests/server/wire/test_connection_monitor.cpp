#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <catch2/catch_test_macros.hpp>
#include <string>
#include <zmq.hpp>

#include "wire/connection_monitor.hpp"

using namespace contactd::server;

namespace {

bool connect_and_leave(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const bool connected = ::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    ::close(fd);
    return connected;
}

}  // namespace

TEST_CASE("News of connections that nobody reads keep nothing from ending", "[server]") {
    zmq::context_t context;
    zmq::socket_t router(context, zmq::socket_type::router);
    Counters::Count connections = 0;
    ConnectionMonitor monitor(context, router, 1 << 20, connections);
    router.bind("tcp://127.0.0.1:*");
    const std::string address = router.get(zmq::sockopt::last_endpoint);
    const int port = std::stoi(address.substr(address.rfind(':') + 1));

    int connected = 0;
    for (int n = 0; n < 1500; ++n) connected += connect_and_leave(port);  // two events each, more than ZeroMQ's default

    CHECK(connected == 1500);
}
