// Tests a program that distributes its contacts over threads by OpenMP.
#include <catch2/catch_test_macros.hpp>

#include <omp.h>

#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "contactd/client/client.hpp"
#include "own_daemon.hpp"

using namespace contactd;
using client::Client;

namespace {

constexpr int contacts = 48, threads = 4;

ContactProblem contact(int number) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(12, 12, 0.2, 0.2);
    problem.bodies = {{200, 0.42}, {200, 0.42}};
    problem.gap = Paraboloid{50, 50};
    problem.approach = 0.005 + 0.0003 * number;
    return problem;
}

/// One after the other (N).
std::vector<double> expected_forces(const std::string& endpoint) {
    Client client(endpoint, {.connect_timeout = std::chrono::seconds(20)});
    std::vector<double> forces;
    for (int n = 0; n < contacts; ++n) forces.push_back(client.solve(contact(n)).solution.forces.Fn);
    return forces;
}

}  // namespace

TEST_CASE("A client for each thread of OpenMP gives the answers of one after the other", "[client][daemon]") {
    Daemon daemon;
    const std::vector<double> expected = expected_forces(daemon.endpoint());
    std::vector<double> forces(contacts);

#pragma omp parallel num_threads(threads)
    {
        Client client(daemon.endpoint());
#pragma omp for
        for (int n = 0; n < contacts; ++n) forces[n] = client.solve(contact(n)).solution.forces.Fn;
    }

    CHECK(forces == expected);
}

TEST_CASE("One client for all threads of OpenMP gives right answers or says what is wrong", "[client][daemon]") {
    Daemon daemon;
    const std::vector<double> expected = expected_forces(daemon.endpoint());
    Client client(daemon.endpoint());
    std::vector<std::optional<double>> forces(contacts);
    std::vector<std::string> refusals(contacts), others(contacts);

#pragma omp parallel for num_threads(threads)
    for (int n = 0; n < contacts; ++n) {
        try {
            forces[n] = client.solve(contact(n)).solution.forces.Fn;
        } catch (const client::ConcurrencyError& error) {
            refusals[n] = error.what();
        } catch (const std::exception& error) {
            others[n] = error.what();
        }
    }

    int answered = 0;
    for (int n = 0; n < contacts; ++n) {
        CAPTURE(n, others[n]);
        CHECK(others[n].empty());
        CHECK(forces[n].has_value() == refusals[n].empty());
        if (forces[n]) CHECK(*forces[n] == expected[n]);
        if (!forces[n]) CHECK(refusals[n].find("one client per thread") != std::string::npos);
        answered += forces[n].has_value();
    }
    CHECK(answered > 0);
}
