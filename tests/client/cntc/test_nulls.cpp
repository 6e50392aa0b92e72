// Every function with every choice of null pointers, and numbers that are none: errors, and no crash.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <tuple>
#include <utility>

#include "client/cntc/calls.hpp"
#include "client/cntc/rail_calls.hpp"

using namespace contactd::cntc::test;

namespace {

/// What a pointer of an argument may point at: room enough, whatever number tells the length.
struct Argument {
    std::vector<int> ints = std::vector<int>(64, 1);
    Values doubles = Values(64, no_number);

    void point(int*& pointer) { pointer = ints.data(); }
    void point(double*& pointer) { pointer = doubles.data(); }
    void point(const char*& pointer) { pointer = ""; }
};

/// Calls it with all choices of null pointers; returns how many of the calls were refused.
template <class... Arguments>
int refused_calls(void (*function)(Arguments...)) {
    int refused = 0;
    for (unsigned given = 0; given < 1U << sizeof...(Arguments); ++given) {
        std::array<Argument, sizeof...(Arguments) + 1> memory;
        std::tuple<Arguments...> arguments{};
        const auto fill = [&]<std::size_t... i>(std::index_sequence<i...>) {
            ((given >> i & 1U ? memory[i].point(std::get<i>(arguments)) : void()), ...);
        };
        fill(std::index_sequence_for<Arguments...>{});
        std::apply(function, arguments);
        if (last_code() != 0) ++refused;
        CHECK((last_code() == 0) == last_sentence().empty());
    }
    return refused;
}

struct Function {
    const char* name;
    int (*refused)();
    int choices;
};

template <auto function>
int run() {
    return refused_calls(function);
}

template <class... Arguments>
constexpr int choices(void (*)(Arguments...)) {
    return 1 << sizeof...(Arguments);
}

#define ENTRY(name)                     \
    Function {                          \
        #name, run<name>, choices(name) \
    }

const std::vector<Function> functions{ENTRY(cntc_initializefirst),
                                      ENTRY(cntc_initializefirst_new),
                                      ENTRY(cntc_initialize),
                                      ENTRY(cntc_finalize),
                                      ENTRY(cntc_setglobalflags),
                                      ENTRY(cntc_setflags),
                                      ENTRY(cntc_getflags),
                                      ENTRY(cntc_setmetadata),
                                      ENTRY(cntc_setsolverflags),
                                      ENTRY(cntc_setmaterialparameters),
                                      ENTRY(cntc_setfrictionmethod),
                                      ENTRY(cntc_getparameters),
                                      ENTRY(cntc_sethertzcontact),
                                      ENTRY(cntc_setpotcontact),
                                      ENTRY(cntc_setundeformeddistc),
                                      ENTRY(cntc_gethertzcontact),
                                      ENTRY(cntc_getpotcontact),
                                      ENTRY(cntc_getnumelements),
                                      ENTRY(cntc_getgriddiscretization),
                                      ENTRY(cntc_setpenetration),
                                      ENTRY(cntc_setnormalforce),
                                      ENTRY(cntc_settimestep),
                                      ENTRY(cntc_setreferencevelocity),
                                      ENTRY(cntc_setrollingstepsize),
                                      ENTRY(cntc_setcreepages),
                                      ENTRY(cntc_settangentialforces),
                                      ENTRY(cntc_setextrarigidslip),
                                      ENTRY(cntc_getpenetration),
                                      ENTRY(cntc_getcreepages),
                                      ENTRY(cntc_getreferencevelocity),
                                      ENTRY(cntc_calculate),
                                      ENTRY(cntc_getcontactforces),
                                      ENTRY(cntc_getcontactpatchareas),
                                      ENTRY(cntc_getmaximumpressure),
                                      ENTRY(cntc_getmaximumtraction),
                                      ENTRY(cntc_getelementdivision),
                                      ENTRY(cntc_gettractions),
                                      ENTRY(cntc_getmicroslip),
                                      ENTRY(cntc_getdisplacements),
                                      ENTRY(cntc_getfielddata),
                                      ENTRY(cntc_getsensitivities),
                                      ENTRY(cntc_getcalculationtime),
                                      ENTRY(cntc_resetcalculationtime),
                                      ENTRY(subs_addblock),
                                      ENTRY(subs_calculate),
                                      ENTRY(subs_getblocksize),
                                      ENTRY(subs_getresults),
                                      ENTRY(cntc_readinpfile),
                                      ENTRY(cntc_settemperaturedata),
                                      ENTRY(cntc_getmaximumtemperature),
                                      ENTRY(cntc_setverticalforce),
                                      ENTRY(cntc_setprofileinputfname),
                                      ENTRY(cntc_setprofileinputvalues),
                                      ENTRY(cntc_settrackdimensions),
                                      ENTRY(cntc_setwheelsetdimensions),
                                      ENTRY(cntc_setwheelsetposition),
                                      ENTRY(cntc_setwheelsetvelocity),
                                      ENTRY(cntc_setwheelsetflexibility),
                                      ENTRY(cntc_getnumcontactpatches),
                                      ENTRY(cntc_getcontactlocation),
                                      ENTRY(cntc_getglobalforces),
                                      ENTRY(cntc_getwheelsetposition),
                                      ENTRY(cntc_getwheelsetvelocity),
                                      ENTRY(cntc_getprofilevalues),
                                      ENTRY(cntc_getprofilevalues_new),
                                      ENTRY(cntc_setfileunits),
                                      ENTRY(cntc_getmaxnumthreads),
                                      ENTRY(cntc_calculate1),
                                      ENTRY(cntc_calculate3)};

}  // namespace

TEST_CASE("every function takes every choice of null pointers, before a solve and after one") {
    REQUIRE(functions.size() == 69);  // and cntc_finalizelast, which has no arguments
    const bool solved = GENERATE(false, true);
    for (const Function& function : functions) {
        CAPTURE(function.name, solved);
        cntc_finalizelast();
        Case contact = wheel(1);
        if (solved) REQUIRE(contact.calculate() == 0);

        const int refused = function.refused();

        // Of a function with a result element those without its number, at the least; of starting those without ierror.
        CHECK(refused >= function.choices / 2);
        Case other = wheel(2);
        CHECK(other.calculate() == 0);
    }
}

TEST_CASE("every function takes every choice of null pointers of a wheel on a rail") {
    const bool solved = GENERATE(false, true);
    for (const Function& function : functions) {
        CAPTURE(function.name, solved);
        cntc_finalizelast();
        RailCase rail = manchester_wheel(1, contactd::Side::right);
        rail.whole.potential(0, {1, 1, 0});
        place(rail, contactd::test::manchester_cases[11]);
        if (solved) REQUIRE(rail.whole.calculate() == 0);

        CHECK(function.refused() >= function.choices / 2);
    }
}
