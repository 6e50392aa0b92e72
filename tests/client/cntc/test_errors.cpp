// Where errors go, and the second names of the functions.
#include <unistd.h>
#include <catch2/catch_test_macros.hpp>
#include <cstdio>

#include "client/cntc/calls.hpp"

using namespace contactd::cntc::test;

extern "C" {
void cntc_setcreepages_(int* ire, int* icp, double* vx, double* vy, double* phi);
void cntc_calculate_(int* ire, int* icp, int* ierror);
void cntc_getcontactforces_(int* ire, int* icp, double* fn, double* fx, double* fy, double* mz);
}

namespace {

/// What is written on standard error while `work` runs.
template <class Work>
std::string printed(const Work& work) {
    std::fflush(stderr);
    std::FILE* file = std::tmpfile();
    const int before = dup(STDERR_FILENO);
    dup2(fileno(file), STDERR_FILENO);
    work();
    std::fflush(stderr);
    dup2(before, STDERR_FILENO);
    close(before);
    std::rewind(file);
    std::string text;
    for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
    std::fclose(file);
    return text;
}

void say_errors(int wanted) {
    int count = 1, code = 2000;
    cntc_setglobalflags(&count, &code, &wanted);
}

}  // namespace

TEST_CASE("a sentence is printed once, and kept") {
    Case none(77001, 1, false);

    CHECK(printed([&] { none.forces(); }) == "contactd: cntc_getcontactforces: Result element 77001 does not exist.\n");

    CHECK(last_sentence() == "cntc_getcontactforces: Result element 77001 does not exist.");
    CHECK(printed([&] { none.forces(); }).empty());
    CHECK(last_code() == -31);
}

TEST_CASE("who wants no output gets none, and can ask") {
    say_errors(0);
    Case none(77002, 1, false);

    CHECK(printed([&] { none.forces(); }).empty());

    CHECK(last_code() == -31);
    say_errors(1);
    CHECK_FALSE(printed([&] { none.forces(); }).empty());
}

TEST_CASE("the last call's error is gone with the next call") {
    Case none(77003, 1, false);
    none.forces();
    CHECK(last_code() == -31);

    wheel(1);

    CHECK(last_code() == 0);
    CHECK(last_sentence().empty());
}

TEST_CASE("names with an underscore are the same functions") {
    Case contact = wheel(1);
    REQUIRE(contact.calculate() == 0);
    const ContactForces expected = contact.forces();
    double vx = 0.002, vy = 0.001, phi = 1e-4;
    ContactForces found;
    int error = -1000;

    cntc_setcreepages_(contact.ire(), contact.icp(), &vx, &vy, &phi);
    cntc_calculate_(contact.ire(), contact.icp(), &error);
    cntc_getcontactforces_(contact.ire(), contact.icp(), &found.fn, &found.fx, &found.fy, &found.mz);

    CHECK(error == 0);
    CHECK(found == expected);
}

TEST_CASE("what a list holds beyond its numbers is not read") {
    Case contact = wheel(1);
    contact.friction(0, {0.3, 0.3, no_number, no_number});
    contact.hertz(-3, {25, 25, 6, 4, 1.1, no_number});
    CHECK(contact.calculate() == 0);
}
