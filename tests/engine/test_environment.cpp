// Tests settings of an engine by the environment.
#include "engine/environment.hpp"

#include <catch2/catch_test_macros.hpp>
#include <cstdlib>
#include <map>
#include <string>

using namespace contactd;
using namespace contactd::engine;

namespace {

/// Sets or removes variables for the duration of a test.
class Environment {
   public:
    explicit Environment(const std::map<std::string, const char*>& variables) {
        for (const auto& [name, value] : variables) {
            const char* before = std::getenv(name.c_str());
            before_[name] = before ? std::optional<std::string>(before) : std::nullopt;
            value ? ::setenv(name.c_str(), value, 1) : ::unsetenv(name.c_str());
        }
    }
    ~Environment() {
        for (const auto& [name, value] : before_)
            value ? ::setenv(name.c_str(), value->c_str(), 1) : ::unsetenv(name.c_str());
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

   private:
    std::map<std::string, std::optional<std::string>> before_;
};

}  // namespace

TEST_CASE("Tables lie where daemons keep them, unless a variable says otherwise") {
    const Environment environment(
        {{"XDG_CACHE_HOME", "/cache"}, {"CONTACTD_STORE", nullptr}, {"CONTACTD_IC", nullptr}});
    CHECK(settings_of_environment().store_folder == "/cache/contactd/store");
    CHECK(settings_of_environment().tables.command.program == "contactd-ic");
    const Environment named({{"CONTACTD_STORE", "/tables"}, {"CONTACTD_IC", "/opt/contactd-ic"}});
    CHECK(settings_of_environment().store_folder == "/tables");
    CHECK(settings_of_environment().tables.command.program == "/opt/contactd-ic");
}

TEST_CASE("Without a place for tables half-spaces are solved, and a table is refused") {
    const Environment environment({{"XDG_CACHE_HOME", nullptr}, {"HOME", nullptr}, {"CONTACTD_STORE", nullptr}});
    Engine engine(settings_of_environment());
    Observer observer;
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.5;
    spec.nx = spec.ny = 2;
    CHECK(engine.table(spec, observer).origin == "closed_form");
    spec.source = IcSource::fem;
    CHECK_THROWS_AS(engine.table(spec, observer), StoreError);
}
