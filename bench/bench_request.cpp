// Compares the time of an empty request with the lower bound for the same transport: an echo between two ZeroMQ
// sockets. Requires a daemon's endpoint in CONTACTD_ENDPOINT (bench/run.py starts one).
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <zmq.hpp>

#include "contactd/client/client.hpp"

namespace {

void echo(zmq::socket_t& router) {
    for (;;) {
        zmq::message_t identity, body;
        if (!router.recv(identity) || !router.recv(body)) return;
        const bool is_end = body.size() == 0;
        (void)router.send(identity, zmq::send_flags::sndmore);
        (void)router.send(body, zmq::send_flags::none);
        if (is_end) return;
    }
}

void zeromq_echo(benchmark::State& state) {
    zmq::context_t context;
    zmq::socket_t router(context, zmq::socket_type::router), dealer(context, zmq::socket_type::dealer);
    router.bind("ipc://*");
    dealer.connect(router.get(zmq::sockopt::last_endpoint));
    std::thread server([&] { echo(router); });
    const std::string request(100, 'x');
    zmq::message_t reply;
    for (auto _ : state) {
        (void)dealer.send(zmq::buffer(request));
        (void)dealer.recv(reply);
    }
    (void)dealer.send(zmq::message_t(), zmq::send_flags::none);
    server.join();
}
BENCHMARK(zeromq_echo)->UseRealTime()->Unit(benchmark::kMicrosecond);

void server_health(benchmark::State& state) {
    const char* endpoint = std::getenv("CONTACTD_ENDPOINT");
    if (!endpoint) return state.SkipWithError("CONTACTD_ENDPOINT names no daemon");
    contactd::client::Client client(endpoint);
    for (auto _ : state) benchmark::DoNotOptimize(client.health());
}
BENCHMARK(server_health)->UseRealTime()->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
