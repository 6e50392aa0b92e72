#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "contactd/proto/schema.hpp"
#include "methods/all_methods.hpp"

using namespace contactd;
using namespace contactd::server;

TEST_CASE("Every method of the wire has its handler, and no other is there") {
    const MethodTable methods = all_methods();
    std::vector<std::string> described = proto::method_names();
    std::sort(described.begin(), described.end());

    CHECK(methods.names() == described);
    for (const std::string& name : described) {
        const Method& method = *methods.find(name);
        CHECK((method.handle == nullptr) != (method.queue == nullptr));
    }
    CHECK(methods.find("server.restart") == nullptr);
}

TEST_CASE("A method that waits for nothing does not count, all others do") {
    const MethodTable methods = all_methods();
    CHECK_FALSE(methods.find("server.health")->counts);
    CHECK(methods.find("health.watch")->counts);
    CHECK(methods.find("contact.solve")->counts);
    CHECK_FALSE(methods.find("contact.solve")->is_immediate);
}

TEST_CASE("Steps of a session go before solves, and these before many of them") {
    const MethodTable methods = all_methods();
    CHECK(methods.find("session.step")->priority == proto::Priority::high);
    CHECK(methods.find("contact.solve")->priority == proto::Priority::normal);
    CHECK(methods.find("contact.solve_many")->priority == proto::Priority::low);
}
