// Measures the overhead of the daemon: the time of a request minus that of the same solve in this process. A bare
// ZeroMQ echo of the same frames is measured for comparison. All alternate, so that a busy machine disturbs them
// equally.
//
//     bench_service ROUNDS SPIN ENDPOINT...     prints one JSON object; bench/service.py starts the daemons
//
// SPIN is the time that the client polls for an answer before it sleeps (us), as for the daemons.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>
#include <zmq.hpp>

#include "contactd/client/client.hpp"
#include "contactd/half_space.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/solve_contact.hpp"

namespace {

using namespace contactd;
using nlohmann::json;
using proto::Frames;

/// Returns the paper's Cattaneo problem on n x n elements.
ContactProblem cattaneo(int n, bool friction) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, 2.4 / n, 2.4 / n);
    problem.bodies = {{200, 0.42}, {200, 0.42}};
    problem.gap = Paraboloid{50, 50};
    problem.approach = 0.02;
    if (friction) {
        problem.friction = FrictionLaw{{0.4}};
        problem.motion = Shift{{0.00817, 0}};
    }
    return problem;
}

ContactInfluence influence_of(const ContactProblem& problem) {
    IcSpec spec;
    spec.material = problem.bodies.upper.material;
    spec.dx = problem.grid.dx;
    spec.dy = problem.grid.dy;
    spec.nx = problem.grid.nx;
    spec.ny = problem.grid.ny;
    const IcTable body = half_space_table(spec);
    return make_influence(problem, pair_of(body, body));
}

/// Frames of a request and of its answer, with the same lengths as the daemon's.
struct Sizes {
    Frames request, reply;
};

Sizes sizes_of(const ContactProblem& problem, const SolveReply& reply) {
    proto::ArrayWriter sent(proto::ArrayEncoding::frame), received(proto::ArrayEncoding::frame);
    const std::string request = proto::dump(proto::encode_problem(problem, sent));
    const std::string result = proto::dump(proto::encode_solve_reply(reply, problem.grid, received));
    Sizes sizes{{request + std::string(90, ' ')}, {result + std::string(90, ' ')}};  // the envelope adds 90 bytes
    for (auto& frame : sent.take_frames()) sizes.request.push_back(std::move(frame));
    for (auto& frame : received.take_frames()) sizes.reply.push_back(std::move(frame));
    return sizes;
}

void send(zmq::socket_t& socket, const Frames& frames) {
    for (std::size_t n = 0; n < frames.size(); ++n)
        (void)socket.send(zmq::buffer(frames[n].bytes()),
                          n + 1 < frames.size() ? zmq::send_flags::sndmore : zmq::send_flags::none);
}

/// Receives a message and returns the number of its frames.
std::size_t receive(zmq::socket_t& socket, Frames& frames) {
    frames.clear();
    zmq::message_t part;
    do {
        if (!socket.recv(part)) return 0;
        frames.push_back(part.to_string());
    } while (part.more());
    return frames.size();
}

/// Connects a ROUTER that answers each message with given frames, and a DEALER that sends it messages.
class Echo {
   public:
    Echo(const std::string& endpoint, Frames request, Frames reply) : request_(std::move(request)) {
        zmq::socket_t router(context_, zmq::socket_type::router);
        router.bind(endpoint);
        dealer_.connect(router.get(zmq::sockopt::last_endpoint));
        server_ = std::thread([router = std::move(router), reply = std::move(reply)]() mutable {
            Frames frames;
            while (receive(router, frames) > 2 || frames.at(1).size() > 0) {
                (void)router.send(zmq::buffer(frames[0].bytes()), zmq::send_flags::sndmore);
                send(router, reply);
            }
        });
    }
    ~Echo() {
        (void)dealer_.send(zmq::message_t(), zmq::send_flags::none);
        server_.join();
    }
    Echo(const Echo&) = delete;
    Echo& operator=(const Echo&) = delete;

    void ask() {
        send(dealer_, request_);
        receive(dealer_, frames_);
    }

   private:
    Frames request_, frames_;
    zmq::context_t context_;
    zmq::socket_t dealer_{context_, zmq::socket_type::dealer};
    std::thread server_;
};

template <class Act>
double milliseconds(const Act& act) {
    const auto start = std::chrono::steady_clock::now();
    act();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Returns the time that the solvers measured themselves.
double solver_milliseconds(const ContactSolution& solution) {
    return 1e3 * (solution.evidence.normal.seconds +
                  (solution.evidence.tangential ? solution.evidence.tangential->seconds : 0));
}

json summary(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto at = [&](double q) { return values[static_cast<std::size_t>(q * double(values.size() - 1))]; };
    return {{"min", values.front()}, {"median", at(0.5)}, {"p99", at(0.99)}};
}

/// Measures one endpoint: request, echo and health, alternating with the solve in this process.
json measure(const std::string& endpoint, std::chrono::microseconds spin, const ContactProblem& problem, int rounds) {
    client::ClientOptions options;
    options.spin = spin;
    client::Client client(endpoint, options);
    const ContactInfluence influence = influence_of(problem);
    Observer observer;
    const SolveReply first = client.solve(problem);
    Sizes sizes = sizes_of(problem, first);
    const std::string echo_endpoint = endpoint.starts_with("ipc") ? "ipc://*" : "tcp://127.0.0.1:*";
    Echo echo(echo_endpoint, sizes.request, sizes.reply);

    std::vector<double> local, request, bare, health, overhead, slower, over_echo;
    double difference = 0;
    for (int n = 0; n < rounds; ++n) {
        ContactSolution here, there;
        local.push_back(milliseconds([&] { here = solve_contact(problem, influence, observer); }));
        request.push_back(milliseconds([&] { there = client.solve(problem).solution; }));
        difference = std::max(difference, std::abs(there.forces.Fn / here.forces.Fn - 1));
        slower.push_back(solver_milliseconds(there) - solver_milliseconds(here));
        bare.push_back(milliseconds([&] { echo.ask(); }));
        health.push_back(milliseconds([&] { (void)client.health(); }));
        overhead.push_back(request.back() - local.back());
        over_echo.push_back(overhead.back() / bare.back());
    }
    if (difference > 1e-9) throw Error("The daemon's forces differ by " + std::to_string(difference) + ".");
    std::size_t bytes = 0;
    for (const auto& frame : sizes.reply) bytes += frame.size();
    return {{"endpoint", endpoint.substr(0, 3)},
            {"spin", spin.count()},
            {"n", problem.grid.nx},
            {"friction", problem.friction.has_value()},
            {"rounds", rounds},
            {"solve", summary(local)},
            {"request", summary(request)},
            {"overhead", summary(overhead)},
            {"over_echo", summary(over_echo)},
            {"slower", summary(slower)},
            {"echo", summary(bare)},
            {"health", summary(health)},
            {"reply_frames", sizes.reply.size()},
            {"reply_bytes", bytes}};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::cerr << "bench_service ROUNDS SPIN ENDPOINT...\n";
        return 2;
    }
    json rows = json::array();
    try {
        const std::chrono::microseconds spin(std::atoi(argv[2]));
        for (int n = 3; n < argc; ++n)
            for (const int size : {10, 25})
                for (const bool friction : {false, true})
                    rows.push_back(measure(argv[n], spin, cattaneo(size, friction), std::atoi(argv[1])));
    } catch (const std::exception& error) {
        std::cerr << "bench_service: " << error.what() << "\n";
        return 1;
    }
    std::cout << rows.dump() << "\n";
}
