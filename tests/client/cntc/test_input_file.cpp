// cntc_readinpfile: a file sets what the functions set.
#include <unistd.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <filesystem>
#include <fstream>

#include "client/cntc/calls.hpp"
#include "client/cntc/rail_calls.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A file that lasts as long as this.
class InputFile {
   public:
    explicit InputFile(const std::string& text)
        : path_(std::filesystem::temp_directory_path() / ("contactd-" + std::to_string(getpid()) + ".inp")) {
        std::ofstream(path_) << text;
    }
    ~InputFile() { std::filesystem::remove(path_); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    int read(Case& contact) const {
        int type = 1, length = static_cast<int>(path_.string().size()), error = -1000;
        cntc_readinpfile(contact.ire(), &type, path_.c_str(), &length, &error);
        return error;
    }

   private:
    std::filesystem::path path_;
};

/// A ball that rolls.
const std::string rolling =
    "3 MODULE\n203100\n022020\n000001\n999 30 30 1 1e-6\n9000. 1e-3 2e-4 1e-4\n0.3 0.3\n0.d 0.4 2000.\n.28 .28 82000. "
    "82000.\n"
    "-3\n20 20 4. 4. 1.1\n";
const std::string end = "0 MODULE\n";

}  // namespace

TEST_CASE("a file sets what the functions set", "[input]") {
    Case by_calls(71), by_file(72);
    by_calls.flag(1972, 3);
    by_calls.tolerance(1e-6);
    by_calls.material(.28, .28, 82000, 82000);
    by_calls.coulomb(0.3);
    by_calls.hertz(-3, {20, 20, 4, 4, 1.1});
    by_calls.normal_force(9000);
    by_calls.creepages(1e-3, 2e-4, 1e-4);
    by_calls.rolling_step(0, 0.4);
    by_calls.velocity(2000);
    by_file.flag(1933, 1935);  // metres, which hold for what is read back and not for the file
    CHECK(InputFile(rolling + end).read(by_file) == 0);
    CHECK(by_file.get_flag(1933) == 1935);
    by_file.flag(1933, 1934);
    CHECK(by_calls.calculate() == by_file.calculate());
    CHECK(by_calls.forces() == by_file.forces());
    CHECK(by_file.forces().fn > 0);
}

TEST_CASE("each contact problem of a result element has its own case", "[input]") {
    Case first(73, 1), second(73, 2, false), alone(74);
    const std::string of_second =
        "3 73 2\n203100\n022020\n000001\n999 30 30 1 1e-6\n4500. 1e-3 2e-4 1e-4\n0.3 0.3\n0.d 0.4 2000.\n.28 .28 "
        "82000. 82000.\n-3\n20 20 4. 4. 1.1\n";
    const InputFile file("3 73 1" + rolling.substr(1) + of_second + end);
    CHECK(file.read(first) == 0);
    first.calculate();
    second.calculate();
    CHECK(std::abs(first.forces().fn / second.forces().fn - 2) < 1e-4);
    CHECK(file.read(alone) == -39);
    CHECK_THAT(last_sentence(), ContainsSubstring("There is no case for result element 74"));
}

TEST_CASE("what the library does not have is refused by its name", "[input]") {
    Case contact(75);
    const auto refused = [&](std::string text, const std::string& from, const std::string& to, int code,
                             const std::string& sentence) {
        if (!from.empty()) text.replace(text.find(from), from.size(), to);
        CHECK(InputFile(text + end).read(contact) == code);
        CHECK_THAT(last_sentence(), ContainsSubstring(sentence));
    };
    refused(rolling, "022020", "022120", -39, "line");
    refused(rolling, ".28 .28", ".28 abc", -39, "line 9, column 5, has \"abc\"");
    refused(rolling + "3 MODULE\n203100\n100000\n100001\n1. 0. 0. 0.\n", "", "", -39,
            "A second case begins in line 13");
    refused(rolling, "022020\n", "022020 2\n", -39, "line");  // reads damping, which the file does not have
    std::string damped = rolling;
    damped.replace(damped.find("022020\n"), 7, "022020 2\n");
    refused(damped, "82000.\n", "82000.\n0.01 0. 1. 1.\n", -39, "CDAMPN and CDAMPT");
    refused(
        "1 MODULE\n1201100\n0022033\n0000001\n999 30 30 1 1e-6\n.3 .3\n.28 .28 1. 1.\n.2 .2 1. 1. 8. 4.\n14. 0 1435. "
        "0.\n'a.prr' 0 1. 0.\n0 0 0 0 0 0\n1360. -70. 460.\n'b.prw' 0 1. 0.\n0 0 1. 0 0 0\n0 0 0 0 0 0\n",
        "", "", -39, "The case in line 2 is of module 1, but the result element was initialized for module 3");
}

TEST_CASE("a file that is not there is refused", "[input]") {
    Case contact(76);
    int type = 1, length = 12, error = 0;
    cntc_readinpfile(contact.ire(), &type, "no/such.file", &length, &error);
    CHECK(error == -39);
    CHECK_THAT(last_sentence(), ContainsSubstring("cannot be read"));
    length = 0;
    cntc_readinpfile(contact.ire(), &type, "", &length, &error);
    CHECK(error == -39);
}

TEST_CASE("a file sets a wheel on a rail as the functions set it, with profiles beside it", "[input]") {
    const auto folder = std::filesystem::temp_directory_path() / ("contactd-rail-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder / "profiles");
    const auto write = [&](const char* name, const Values& values) {
        std::ofstream file(folder / "profiles" / name);
        file.precision(17);
        for (std::size_t i = 0; i < values.size(); i += 2) file << values[i] << " " << values[i + 1] << "\n";
    };
    write("rail.txt", rail_60e1());
    write("wheel.txt", s1002());
    const auto write_case = [&](const std::string& most_elements) {
        std::ofstream(folder / "case.inp")
            << "1 MODULE\n1203100\n0022035\n0000001\n999 100 30 1 1e-6" << most_elements
            << "\n.3 .3\n.28 .28 82000. 82000.\n"
               ".2 .2 1. 1.5707963267948966 8. 4.\n-1. 760.532353 -0.000023 0.\n'profiles\\rail.txt' 0 1. 0.\n"
               "0.1 0 0 0 0 0\n1360. -70. 460.\n'profiles\\wheel.txt' 0 1. 0.\n0 2. 10000. -1.128e-4 4.8e-3 0\n"
               "2000. 0 0 0 0 -4.3459197\n0 0.2 0 1e-3 0 0\n0 0 0 0 0 0\n0 MODULE\n";
    };
    write_case("");

    RailCase by_calls(77), by_file(78);
    by_calls.whole.flag(1967, 1);
    by_calls.whole.material(0.28, 0.28, 82000, 82000);
    by_calls.whole.coulomb(0.3);
    by_calls.whole.tolerance(1e-6);
    by_calls.whole.potential(-1, {0.2, 0.2, 1.5707963267948966, 8, 4, 12});
    by_calls.profile_file((folder / "profiles/rail.txt").string(), {0});
    by_calls.profile_file((folder / "profiles/wheel.txt").string(), {1});
    by_calls.track(3, {-1, 760.532353, -0.000023, 0, 0, 0, 0.1, 0, 0, 0, 0, 0});
    by_calls.wheelset(3, {1360, -70, 460});
    by_calls.position(2, {0, 2, 0, -1.128e-4, 4.8e-3, 0});
    by_calls.velocity(2, {2000, 0, 0, 0, 0, -4.3459197});
    by_calls.flexibility(5, {0, 0.2, 0, 1e-3, 0, 0, 0, 0, 0, 0, 0, 0});
    by_calls.vertical_force(10000);

    const std::string name = (folder / "case.inp").string();
    int ire = 78, type = 1, length = static_cast<int>(name.size()), error = -1000;
    cntc_readinpfile(&ire, &type, name.c_str(), &length, &error);
    CHECK(error == 0);
    CHECK(by_calls.whole.calculate() == 0);
    CHECK(by_file.whole.calculate() == 0);
    CHECK(by_file.patch(1).forces().fn > 9000);
    CHECK(by_file.patch(1).forces() == by_calls.patch(1).forces());

    write_case(" 1000");
    cntc_readinpfile(&ire, &type, name.c_str(), &length, &error);
    CHECK(by_file.whole.calculate() == 0);
    const Values coarse = by_file.patch(1).potential_back();
    CHECK(coarse[0] * coarse[1] < 1000);
    CHECK(coarse[4] == 0.4);

    std::filesystem::remove_all(folder / "profiles");
    cntc_readinpfile(&ire, &type, name.c_str(), &length, &error);
    CHECK(error == -32);
    CHECK_THAT(last_sentence(), ContainsSubstring("rail.txt"));
    std::filesystem::remove_all(folder);
}

TEST_CASE("a file sets no damping, distances, half ellipses and estimates as the functions set them", "[input]") {
    Case by_calls(79), by_file(80);
    by_calls.tolerance(1e-6);
    by_calls.material(.28, .28, 82000, 82000);
    by_calls.coulomb(0.3);
    by_calls.normal_force(9000);
    by_calls.creepages(1e-3, 2e-4, 1e-4);
    by_calls.rolling_step(0, 0.4);
    by_calls.velocity(2000);
    std::string text = rolling;
    const auto replace = [&](const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
    };
    const std::string hertz = "-3\n20 20 4. 4. 1.1", area = "1\n20 20 -4. -4. .4 .4\n";
    SECTION("damping that is zero") {
        replace("022020\n", "022020 2\n");
        replace("82000.\n", "82000.\n0. 0. 1. 1.\n");
        by_calls.hertz(-3, {20, 20, 4, 4, 1.1});
    }
    SECTION("a profile across") {
        replace(hertz, area + "2 1\n2 0. 400. -1. 2.\n0. .005");
        by_calls.potential(1, {20, 20, -4, -4, 0.4, 0.4});
        by_calls.distance(2, {2, 0, 400, -1, 2, 0, 0.005});
    }
    SECTION("waves") {
        replace(hertz, area + "3 1\n1e-3 1. 0. 1e-3 2. 0. 400. 400.");
        by_calls.potential(1, {20, 20, -4, -4, 0.4, 0.4});
        by_calls.distance(3, {1e-3, 1, 0, 1e-3, 2, 0, 400, 400});
    }
    SECTION("two half ellipses") {
        replace("203100", "243100");
        replace(hertz, "-6\n20 20 4. 3. 5. 1.1");
        by_calls.flag(1971, 4);
        by_calls.hertz(-6, {20, 20, 4, 3, 5, 1.1});
    }
    CAPTURE(text);
    CHECK(InputFile(text + end).read(by_file) == 0);
    CHECK(last_sentence().empty());
    const int code = by_calls.calculate();
    REQUIRE(code >= 0);
    CHECK(by_file.calculate() == code);
    CHECK(by_calls.forces() == by_file.forces());
}

TEST_CASE("a file sets spin and friction that no function sets as motions that functions set", "[input]") {
    Case by_calls(83), by_file(84);
    by_calls.tolerance(1e-6);
    by_calls.material(.28, .28, 82000, 82000);
    by_calls.coulomb(0.3);
    by_calls.normal_force(9000);
    by_calls.rolling_step(0, 0.4);
    by_calls.velocity(2000);
    by_calls.hertz(-3, {20, 20, 4, 4, 1.1});
    std::string text = rolling;
    const auto replace = [&](const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
    };
    SECTION("a centre of spin") {
        replace("1e-4\n", "1e-4 1. 2.\n");
        by_calls.creepages(1e-3 + 2 * 1e-4, 2e-4 - 1 * 1e-4, 1e-4);
    }
    SECTION("spin that acts along x alone") {
        replace("022020\n", "022022\n");
        by_calls.creepages(1e-3, 2e-4, 0);
        Values along(400), across(400, 0.0);
        for (int iy = 0; iy < 20; ++iy)
            for (int ix = 0; ix < 20; ++ix) along[20 * iy + ix] = -1e-4 * (-4.4 + (iy + 0.5) * 0.44);
        by_calls.extra_slip(along, across);
    }
    SECTION("friction that is the same in all rows") {
        replace("022020\n", "3022020\n");
        replace("0.3 0.3\n", "");
        replace(
            "-3\n20 20 4. 4. 1.1\n", "-3\n20 20 4. 4. 1.1\n" + [] {
                std::string rows;
                for (int row = 0; row < 20; ++row) rows += "0.3 0.3\n";
                return rows;
            }());
        by_calls.creepages(1e-3, 2e-4, 1e-4);
    }
    SECTION("a sheet that yields nothing") {
        replace("203100", "213100");
        replace("82000.\n", "82000.\n0.\n");
        by_calls.creepages(1e-3, 2e-4, 1e-4);
    }
    CAPTURE(text);
    REQUIRE(InputFile(text + end).read(by_file) == 0);
    REQUIRE(by_calls.calculate() == 0);
    REQUIRE(by_file.calculate() == 0);
    CHECK(std::abs(by_file.forces().fx - by_calls.forces().fx) < 1e-9 * 2700);
    CHECK(std::abs(by_file.forces().fy - by_calls.forces().fy) < 1e-9 * 2700);
    CHECK(std::abs(by_file.forces().mz - by_calls.forces().mz) < 1e-9 * 2700);
}

TEST_CASE("a first case that goes on from none is named, and taken as one that starts anew", "[input]") {
    Case contact(85);
    std::string text = rolling;
    text.replace(text.find("203100"), 6, "003100");
    CHECK(InputFile(text + end).read(contact) == 0);
    CHECK_THAT(last_sentence(), ContainsSubstring("Warning: ") && ContainsSubstring("P = 0"));
    CHECK(contact.get_flag(1970) == 2);
}

TEST_CASE("a file that cannot be set changes nothing, and nothing is solved until one can", "[input]") {
    Case contact(86);
    REQUIRE(InputFile(rolling + end).read(contact) == 0);
    std::string wrong = rolling;
    wrong.replace(wrong.find("9000."), 5, "5000.");
    wrong.replace(wrong.find("0.4 2000."), 9, "0.4 0.");
    CHECK(InputFile(wrong + end).read(contact) == -39);
    CHECK(contact.calculate() == -39);
    REQUIRE(InputFile(rolling + end).read(contact) == 0);
    REQUIRE(contact.calculate() == 0);
    CHECK(std::abs(contact.forces().fn - 9000) < 1e-3);
}
