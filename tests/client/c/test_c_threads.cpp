// Tests threads, cancellation, timeouts, the log and forks of the C interface.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>
#include <vector>

#include "client/cpp/own_daemon.hpp"
#include "every_call.hpp"

using namespace std::chrono_literals;
using Catch::Approx;

namespace {

struct Lines {
    std::mutex mutex;
    std::vector<std::pair<std::int32_t, std::string>> all;
};

void keep_line(void* user, std::int32_t level, const char* text) {
    auto& lines = *static_cast<Lines*>(user);
    const std::scoped_lock lock(lines.mutex);
    lines.all.emplace_back(level, text);
}

/// Calls contactd_step in a thread until it is ended. Who looks whether it has begun uses the contact, too, and is
/// waited for.
struct Stepping {
    explicit Stepping(contactd_contact* contact)
        : thread([this, contact] {
              do {
                  code = contactd_step(contact);
                  reason = contactd_last_reason(contact);
              } while (reason == "CONCURRENT_USE");
          }) {}
    void join() { thread.join(); }
    std::int32_t code = -1;
    std::string reason;
    std::thread thread;
};

/// Waits until another thread has its turn.
void wait_until_used(contactd_contact* contact) {
    double step = 0;
    for (int times = 0; times < 20000; ++times) {
        if (contactd_get(contact, "step", &step) != CONTACTD_OK) return;
        std::this_thread::sleep_for(1ms);
    }
    FAIL("The contact was not used within 20 s.");
}

}  // namespace

TEST_CASE("Ten threads with a contact each come to the same", "[c]") {
    Daemon daemon;
    const Place place(daemon.endpoint());
    std::vector<Read> answers(10);
    std::atomic<int> failures = 0;
    {
        std::vector<std::jthread> threads;
        for (Read& answer : answers)
            threads.emplace_back([&] {
                contactd_contact* contact = nullptr;
                std::int32_t code = contactd_new(place, &contact);
                for (const auto& [path, value] : sphere_fields)
                    if (!code) code = contactd_set(contact, path, value);
                if (!code) code = contactd_set(contact, "friction.mu", 0.4);
                if (!code) code = contactd_set(contact, "friction.rigid_shift.x", 1e-3);
                if (!code) code = contactd_start(contact);
                for (int i = 0; i < 5 && !code; ++i) code = contactd_step(contact);
                if (!code) code = contactd_get(contact, "forces.Fn", &answer.Fn);
                if (!code) code = contactd_get(contact, "forces.Fx", &answer.Fx);
                if (contactd_free(contact) != CONTACTD_OK || code != CONTACTD_OK) ++failures;
            });
    }
    CHECK(failures == 0);
    CHECK(answers[0].Fx < 0);
    CHECK(answers == std::vector<Read>(10, answers[0]));
}

TEST_CASE("A contact that a thread uses refuses every call of another, and is cancelled by it", "[c]") {
    Daemon daemon;
    const Place place(daemon.endpoint());
    const Handle contact(place);
    set_long(contact);
    require_ok(contactd_start(contact), contact);
    Stepping stepping(contact);
    wait_until_used(contact);
    Arguments arguments;
    for (const auto& [name, call] : every_call(arguments)) {
        if (name == "contactd_cancel") continue;
        INFO(name);
        CHECK(call(contact) == CONTACTD_FAILED_PRECONDITION);
        CHECK(contactd_last_reason(contact) == std::string("CONCURRENT_USE"));
    }

    CHECK(contactd_cancel(contact) == CONTACTD_OK);

    stepping.join();
    CHECK(stepping.code == CONTACTD_CANCELLED);
    CHECK(stepping.reason == "REQUEST_CANCELLED");
    CHECK(get(contact, "step") == 0);
    set(contact, "friction.rolling.steps", 1);
    require_ok(contactd_step(contact), contact);     // it goes on
    CHECK(contactd_cancel(contact) == CONTACTD_OK);  // nothing runs: nothing happens
    require_ok(contactd_step(contact), contact);
}

TEST_CASE("A step ends at its timeout", "[c]") {
    Daemon daemon;
    const Place place(daemon.endpoint());
    const Handle contact(place);
    set_long(contact);
    require_ok(contactd_set_step_timeout(contact, 0.05), contact);
    require_ok(contactd_start(contact), contact);
    CHECK(contactd_step(contact) == CONTACTD_DEADLINE_EXCEEDED);
    CHECK(contactd_last_reason(contact) == std::string("DEADLINE_PASSED"));
}

TEST_CASE("The log tells warnings and failures, and may not use the contact", "[c]") {
    Daemon daemon;
    Lines lines;
    const Place place(daemon.endpoint());
    require_ok(contactd_set_log(place, keep_line, &lines), place);
    const Handle contact(place);
    set_sphere(contact);
    set(contact, "approach", 0.2);  // beyond the grid
    require_ok(contactd_start(contact), contact);
    require_ok(contactd_step(contact), contact);
    const double warnings = get(contact, "warnings");
    REQUIRE(warnings > 0);
    char cut[5];
    const std::string text = get_word(contact, "warnings[0]"),
                      beyond = "warnings[" + std::to_string(int(warnings)) + "]";
    REQUIRE(contactd_get_word(contact, "warnings[0]", cut, 5) == CONTACTD_OK);
    CHECK(text.substr(0, 4) == cut);
    CHECK(contactd_get_word(contact, beyond.c_str(), cut, 5) == CONTACTD_NOT_FOUND);
    CHECK(contactd_get_word(contact, "warnings[0]", cut, 0) == CONTACTD_INVALID_ARGUMENT);

    REQUIRE(lines.all.size() >= static_cast<std::size_t>(warnings) + 2);
    CHECK(lines.all[0] == std::pair<std::int32_t, std::string>(CONTACTD_LOG_WARNING, text));
    CHECK(lines.all.back().first == CONTACTD_LOG_ERROR);

    struct Reentering {
        contactd_contact* contact;
        std::int32_t code = -1;
    } reentering{contact};
    const contactd_log reenter = [](void* user, std::int32_t, const char*) {
        auto& mine = *static_cast<Reentering*>(user);
        mine.code = contactd_step(mine.contact);
    };
    require_ok(contactd_set_log(place, reenter, &reentering), place);
    const Handle later(place);
    reentering.contact = later;
    CHECK(contactd_step(later) == CONTACTD_FAILED_PRECONDITION);  // was not started
    CHECK(reentering.code == CONTACTD_FAILED_PRECONDITION);
}

TEST_CASE("A log that throws ends its call, and no more", "[c]") {
    const Place place("ipc:///nowhere/contactd");
    require_ok(contactd_set_log(place, [](void*, std::int32_t, const char*) { throw 7; }, nullptr), place);
    const Handle contact(place);
    CHECK(contactd_step(contact) == CONTACTD_UNKNOWN);
    CHECK(contactd_last_error(contact) == std::string("A callback threw an exception."));
}

#ifndef __SANITIZE_THREAD__  // which ends a forked process that starts threads
TEST_CASE("A forked process makes contacts of its own, and leaves those of its parent alone", "[c]") {
    Daemon daemon;
    const Place place(daemon.endpoint());
    const Handle contact(place);
    set_sphere(contact);
    require_ok(contactd_start(contact), contact);
    const Read first = stepped(contact);
    const pid_t child = ::fork();
    if (child == 0) {
        contactd_contact* own = nullptr;
        double pmax = 0;
        int wrong = contactd_step(contact) != CONTACTD_FAILED_PRECONDITION;
        wrong += std::string(contactd_last_reason(contact)) != "CONCURRENT_USE";
        std::int32_t code = contactd_new(place, &own);
        for (const auto& [path, value] : sphere_fields)
            if (!code) code = contactd_set(own, path, value);
        if (!code) code = contactd_start(own);
        if (!code) code = contactd_step(own);
        if (!code) code = contactd_get(own, "pmax", &pmax);
        if (!code) code = contactd_free(own);
        contactd_free(contact);
        ::_exit(wrong + (code != CONTACTD_OK) + (pmax != first.pmax));
    }
    int status = -1;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    CHECK(stepped(contact).pmax == Approx(first.pmax));  // it still exists and starts from the previous step
}
#endif
