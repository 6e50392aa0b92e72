// Many threads: result elements are independent, and one that is shared takes turns.
#include <catch2/catch_test_macros.hpp>
#include <thread>

#include "client/cntc/calls.hpp"

using namespace contactd::cntc::test;

namespace {

constexpr int threads = 10, cases = 12;

Creepages creepage(int thread, int k) {
    return {1e-4 * (k + 1) * (thread % 2 == 0 ? 1 : -1), 5e-5 * (thread + 1), 1e-5 * k};
}

/// Forces of a thread's cases, one after the other.
std::vector<ContactForces> solve(Case contact, int thread) {
    std::vector<ContactForces> result;
    contact.hertz(-3, {15.0 + thread, 15, 6, 4, 1.1});
    for (int k = 0; k < cases; ++k) {
        const auto [vx, vy, phi] = creepage(thread, k);
        contact.creepages(vx, vy, phi);
        if (contact.calculate() == 0) result.push_back(contact.forces());
    }
    return result;
}

}  // namespace

TEST_CASE("ten threads with result elements of their own answer what one thread answers") {
    std::vector<std::vector<ContactForces>> found(threads), expected(threads);
    std::vector<std::thread> running;
    for (int t = 0; t < threads; ++t)
        running.emplace_back([t, &found] { found[static_cast<std::size_t>(t)] = solve(wheel(100 + t), t); });
    for (std::thread& thread : running) thread.join();

    for (int t = 0; t < threads; ++t) expected[static_cast<std::size_t>(t)] = solve(wheel(200 + t), t);

    CHECK(found == expected);
    for (const auto& of_thread : found) CHECK(of_thread.size() == cases);
    cntc_finalizelast();
}

TEST_CASE("threads that share a contact problem, make and end it leave it whole") {
    wheel(1);
    std::vector<std::thread> running;
    for (int t = 0; t < threads; ++t)
        running.emplace_back([t] {
            Case shared(1, 1, false);
            for (int k = 0; k < cases; ++k) {
                if (t == 0 && k % 4 == 3) {
                    int ire = 1;
                    cntc_finalize(&ire);
                    wheel(1, 1, false);
                }
                const auto [vx, vy, phi] = creepage(t, k);
                shared.creepages(vx, vy, phi);
                shared.calculate();
                shared.forces();
                shared.division();
                shared.hertz_back();
            }
        });
    for (std::thread& thread : running) thread.join();

    Case contact = wheel(1, 1, false);
    CHECK(contact.calculate() == 0);
    CHECK(contact.forces().fx < 0);
}

TEST_CASE("errors are those of the thread that made them") {
    Case none(999, 1, false);
    none.forces();
    REQUIRE(last_code() == -31);
    int other = -1;

    std::thread([&other] { other = last_code(); }).join();

    CHECK(other == 0);
    CHECK(last_code() == -31);
}
