// What cannot be done is refused with a code and a sentence, and never answered with a number.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include "client/cntc/calls.hpp"

using namespace contactd::cntc::test;

TEST_CASE("what was refused refuses the solve, until it is set well") {
    struct Setting {
        int code;
        void (*bad)(Case&);
        void (*good)(Case&);
    };
    const Setting setting = GENERATE(
        Setting{-39, [](Case& c) { c.flag(1971, 1); }, [](Case& c) { c.flag(1971, 0); }},
        Setting{-39, [](Case& c) { c.flag(1933, 1937); }, [](Case& c) { c.flag(1933, 1934); }},
        Setting{-39, [](Case& c) { c.flag(1978, 4); }, [](Case& c) { c.flag(1978, 2); }},
        Setting{-39, [](Case& c) { c.flag(1972, 4); }, [](Case& c) { c.flag(1972, 3); }},
        Setting{-39, [](Case& c) { c.flag(1982, 2); }, [](Case& c) { c.flag(1982, 0); }},
        Setting{-33, [](Case& c) { c.coulomb(-0.1); }, [](Case& c) { c.coulomb(0.3); }},
        Setting{-33, [](Case& c) { c.friction(0, {0.3, 0.2}); }, [](Case& c) { c.coulomb(0.3); }},
        Setting{-33, [](Case& c) { c.friction(7, {0.2, 0.1, 50, 0, 1, 0, 1}); }, [](Case& c) { c.coulomb(0.3); }},
        Setting{-33, [](Case& c) { c.friction(10, {0.3, 0.3}); }, [](Case& c) { c.coulomb(0.3); }},
        Setting{-33, [](Case& c) { c.friction(4, {0.2, 0.1, 50, -0.1, 1, 0, 1}); }, [](Case& c) { c.coulomb(0.3); }},
        Setting{-33, [](Case& c) { c.friction(2, {0.2, 0.1, 50, 0, 1, -0.1, 1}); }, [](Case& c) { c.coulomb(0.3); }},
        Setting{-39, [](Case& c) { c.friction(4, {0.2, 0.1}); }, [](Case& c) { c.coulomb(0.3); }},
        Setting{-39, [](Case& c) { c.coulomb(no_number); }, [](Case& c) { c.coulomb(0.3); }},
        Setting{-39, [](Case& c) { c.material(0.28, 0.6, 1, 1); }, [](Case& c) { c.material(0.3, 0.3, 1, 1); }},
        Setting{-39, [](Case& c) { c.material(0.28, 0.28, -1, 1); }, [](Case& c) { c.material(0.3, 0.3, 1, 1); }},
        Setting{-39, [](Case& c) { c.material(no_number, 0.28, 1, 1); }, [](Case& c) { c.material(0.3, 0.3, 1, 1); }},
        Setting{-34, [](Case& c) { c.hertz(-7, {25, 25, 6, 4, 4, 1.1}); },
                [](Case& c) { c.hertz(-3, {25, 25, 6, 4, 1.1}); }},
        Setting{-34, [](Case& c) { c.hertz(-3, {0, 25, 6, 4, 1.1}); },
                [](Case& c) { c.hertz(-3, {25, 25, 6, 4, 1.1}); }},
        Setting{-34, [](Case& c) { c.hertz(-3, {1e5, 1e5, 6, 4, 1.1}); },
                [](Case& c) { c.hertz(-3, {25, 25, 6, 4, 1.1}); }},
        Setting{-39, [](Case& c) { c.hertz(-3, {25, 25.5, 6, 4, 1.1}); },
                [](Case& c) { c.hertz(-3, {25, 25, 6, 4, 1.1}); }},
        Setting{-39, [](Case& c) { c.hertz(-3, {25, 25, 6, 4}); }, [](Case& c) { c.hertz(-3, {25, 25, 6, 4, 1.1}); }},
        Setting{-34, [](Case& c) { c.potential(1, {5, 5, 0, 0, -1, 1}); },
                [](Case& c) { c.hertz(-3, {25, 25, 6, 4, 1.1}); }},
        Setting{-34, [](Case& c) { c.potential(4, {1, 5, 0, 0, 1, 1}); },
                [](Case& c) { c.hertz(-3, {25, 25, 6, 4, 1.1}); }},
        Setting{-34, [](Case& c) { c.potential(5, {5, 5, 0, 0, 1, 1}); },
                [](Case& c) { c.hertz(-3, {25, 25, 6, 4, 1.1}); }},
        Setting{-39, [](Case& c) { c.distance(4, {1, 1}); }, [](Case& c) { c.distance(1, {1, 0, 1, 0, 0, 0}); }},
        Setting{-39, [](Case& c) { c.distance(9, {1, no_number}); },
                [](Case& c) { c.distance(1, {1, 0, 1, 0, 0, 0}); }},
        Setting{-39, [](Case& c) { c.normal_force(-1); }, [](Case& c) { c.normal_force(50000); }},
        Setting{-39, [](Case& c) { c.penetration(no_number); }, [](Case& c) { c.penetration(0.05); }},
        Setting{-39, [](Case& c) { c.creepages(no_number, 0, 0); }, [](Case& c) { c.creepages(0, 0, 0); }},
        Setting{-39, [](Case& c) { c.velocity(0); }, [](Case& c) { c.velocity(1); }},
        Setting{-39, [](Case& c) { c.time_step(-1); }, [](Case& c) { c.time_step(1); }},
        Setting{-39, [](Case& c) { c.rolling_step(0, 0); }, [](Case& c) { c.rolling_step(0, 1); }},
        Setting{-39, [](Case& c) { c.tolerance(0); }, [](Case& c) { c.tolerance(1e-6); }},
        Setting{-39, [](Case& c) { c.tangential_forces(no_number, 0); }, [](Case& c) { c.tangential_forces(0, 0); }});
    Case contact = wheel(1);

    setting.bad(contact);

    CHECK(last_code() == setting.code);
    CHECK(last_sentence().starts_with("cntc_set"));
    CHECK(contact.calculate() == setting.code);
    CHECK(last_sentence().starts_with("cntc_calculate"));
    CHECK(std::isnan(contact.forces().fn));
    setting.good(contact);
    CHECK(last_code() == 0);
    CHECK(last_sentence().empty());
    CHECK(contact.calculate() == 0);
}

TEST_CASE("heat without numbers is refused, and no heat is none") {
    Case contact = wheel(1);
    int method = 3, count = 0;
    cntc_settemperaturedata(contact.ire(), contact.icp(), &method, &count, nullptr);
    CHECK(contact.calculate() < 0);
    method = 0;
    cntc_settemperaturedata(contact.ire(), contact.icp(), &method, &count, nullptr);
    CHECK(contact.calculate() == 0);
}

TEST_CASE("what is missing is named") {
    struct Missing {
        int code;
        const char* function;
        void (*set)(Case&);
    };
    // In the order in which they are missed.
    const std::vector<Missing> all{
        {-39, "cntc_setmaterialparameters", [](Case& c) { c.material(0.28, 0.28, 82000, 82000); }},
        {-34, "cntc_sethertzcontact or cntc_setpotcontact", [](Case& c) { c.potential(1, {20, 20, -10, -10, 1, 1}); }},
        {-39, "cntc_setundeformeddistc", [](Case& c) { c.distance(1, {1e-3, 0, 1e-3, 0, 0, 0}); }},
        {-39, "cntc_setnormalforce", [](Case& c) { c.normal_force(20000); }},
        {-33, "cntc_setfrictionmethod", [](Case& c) { c.friction(4, {0.2, 0.1, 50, 0, 1, 0, 1}); }},
        {0, "", [](Case& c) { c.creepages(1e-3, 0, 0); }},
        {0, "", [](Case& c) { c.flag(1972, 2); }},
        {-34, "cntc_setrollingstepsize", [](Case& c) { c.rolling_step(0, 1); }},
        {0, "", [](Case& c) { c.flag(1974, 1); }},
        {-39, "cntc_settangentialforces", [](Case& c) { c.tangential_forces(0.1, 0); }},
        {0, "", [](Case& c) { c.flag(1980, 9); }},
        {-39, "cntc_setextrarigidslip", [](Case& c) { c.extra_slip(Values(400), Values(400)); }},
        {0, "", [](Case& c) { c.flag(1972, 1); }},
        {-33, "cntc_settimestep", [](Case& c) { c.time_step(1e-3); }}};
    Case contact(1);
    contact.flag(1970, 2);

    for (const auto& [code, function, set] : all) {
        CHECK(contact.calculate() == code);
        CAPTURE(last_sentence());
        CHECK(last_sentence().find(function) != std::string::npos);
        set(contact);
        CHECK(last_code() == 0);
    }
    CHECK(contact.calculate() == 0);
}

TEST_CASE("arrays of other elements are refused") {
    Case contact = wheel(1);
    contact.extra_slip(Values(10), Values(10));
    CHECK(contact.calculate() == -39);
    contact.flag(1980, 0);
    CHECK(contact.calculate() == 0);
    contact.potential(1, {20, 20, -10, -10, 1, 1});
    contact.distance(9, Values(399));
    CHECK(contact.calculate() == -39);
}

TEST_CASE("arrays that are too short get no numbers, and nothing beyond their end") {
    Case contact = wheel(1);
    REQUIRE(contact.calculate() == 0);
    constexpr double guard = 12345;
    Values pn(626, guard), px(626, guard), py(626, guard);
    int length = 624, code = 5;

    cntc_gettractions(contact.ire(), contact.icp(), &length, pn.data(), px.data(), py.data());
    CHECK(last_code() == -39);
    for (const Values* values : {&pn, &px, &py}) {
        CHECK(std::isnan(values->front()));
        CHECK(std::isnan((*values)[623]));
        CHECK((*values)[624] == guard);
    }
    std::vector<int> division(626, 77);
    cntc_getelementdivision(contact.ire(), contact.icp(), &length, division.data());
    CHECK(last_code() == -39);
    CHECK(division[623] == -1);
    CHECK(division[624] == 77);
    length = 626;
    cntc_getfielddata(contact.ire(), contact.icp(), &code, &length, pn.data());
    CHECK(last_code() == 0);
    CHECK(std::isnan(pn[625]));  // there is no such element
    length = -1;
    cntc_getfielddata(contact.ire(), contact.icp(), &code, &length, pn.data());
    CHECK(last_code() == -39);
}

TEST_CASE("there is no other module, and no handle that was not made") {
    int ire = 50, icp = 1, module = 2, version = 0, error = 0, length = 0;
    cntc_initialize(&ire, &module, &version, &error, "", &length);
    CHECK(error == -99);
    Case other = wheel(50, 1, false);
    CHECK(last_code() == -31);
    CHECK(other.calculate() == -31);

    CHECK(Case(12345, 1, false).calculate() == -31);
    CHECK(Case(0, 1, false).calculate() == -31);
    Case(0, 1, false).coulomb(0.3);
    CHECK(last_code() == -31);
    Case contact = wheel(1);
    CHECK(Case(1, 2, false).calculate() == -31);
    CHECK(Case(1, 0, false).calculate() == -31);
    Case(1, -2, false).coulomb(0.3);
    CHECK(last_code() == -31);
    CHECK(std::isnan(Case(1, -1, false).forces().fn));
    CHECK(last_code() == -31);
    int none = 321;
    cntc_finalize(&none);
    CHECK(last_code() == -31);
    cntc_finalize(contact.ire());
    CHECK(last_code() == 0);
    CHECK(contact.calculate() == -31);
    cntc_calculate(&ire, &icp, nullptr);
    CHECK(last_code() == -31);
}

TEST_CASE("a result element that was not initialized is when it is set") {
    cntc_finalizelast();
    Case contact = wheel(7, 2, false);
    CHECK(contact.calculate() == 0);
    cntc_finalizelast();
    CHECK(contact.calculate() == -31);
}

TEST_CASE("flags of output mean nothing, unknown ones are named, and neither is in the way") {
    Case contact = wheel(1);
    for (const int code : {0, 1981, 1984, 1985, 1987, 1991, 1992, 1993, 2000, 2002, 2003}) {
        contact.flag(code, 1);
        CHECK(last_code() == 0);
    }
    contact.flag(4711, 1);
    CHECK(last_code() == -39);
    CHECK(contact.calculate() == 0);
    CHECK(contact.get_flag(4711) == -1);
    CHECK(contact.get_flag(1972) == 3);
    CHECK(contact.get_flag(1973) == 1);
    CHECK(contact.get_flag(1970) == 2);
    contact.penetration(0.05);
    CHECK(contact.get_flag(1973) == 0);
}

TEST_CASE("solvers that may not go on say so") {
    Case contact = wheel(1);
    int method = 0, ints = 4, reals = 1;
    std::array bounds{1, 1, 1, 1};
    double eps = 1e-6;
    cntc_setsolverflags(contact.ire(), contact.icp(), &method, &ints, bounds.data(), &reals, &eps);

    CHECK(contact.calculate() == -27);

    CHECK(contact.forces().fn > 0);  // the best that was found
    bounds = {999, 1, 1, 2};
    contact.material(0.28, 0.1, 82000, 8200);
    cntc_setsolverflags(contact.ire(), contact.icp(), &method, &ints, bounds.data(), &reals, &eps);
    CHECK(contact.calculate() == -29);
}

TEST_CASE("without heat the largest temperatures are zero, and without a solution there are none") {
    Case contact = wheel(1);
    double first = 1, second = 1;
    cntc_getmaximumtemperature(contact.ire(), contact.icp(), &first, &second);
    CHECK(last_code() < 0);
    CHECK((std::isnan(first) && std::isnan(second)));
    REQUIRE(contact.calculate() == 0);
    cntc_getmaximumtemperature(contact.ire(), contact.icp(), &first, &second);
    CHECK(last_code() == 0);
    CHECK((first == 0 && second == 0));
}

TEST_CASE("pressures over two half ellipses, and the flag that asks for them, need each other") {
    Case contact = wheel(1);
    contact.flag(1971, 4);
    CHECK(contact.calculate() == -39);
    contact.hertz(-6, {25, 25, 6, 3, 5, 1.1});
    CHECK(contact.calculate() == 0);
    contact.flag(1971, 0);
    CHECK(contact.calculate() == -39);
    CHECK(last_sentence().find("Control digit B = 4 (flag 1971) and IPOTCN = -6") != std::string::npos);
}
