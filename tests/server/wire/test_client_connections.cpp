#include <catch2/catch_test_macros.hpp>
#include <string>

#include "wire/client_connections.hpp"

using namespace contactd::server;

namespace {

/// Returns an identity as assigned by ROUTER: a zero byte and a number.
std::string given(char number) {
    return {'\0', 0, 0, 0, number};
}

}  // namespace

TEST_CASE("A client goes with its connection, once") {
    ClientConnections connections;
    connections.note_connection(7);
    CHECK_FALSE(connections.knows(7, given(1)));
    CHECK(connections.note_message(7, given(1)));
    CHECK(connections.knows(7, given(1)));
    CHECK(connections.take_gone().empty());

    connections.note_end(7);
    connections.note_end(7);

    CHECK(connections.take_gone() == std::vector{given(1)});
    CHECK(connections.take_gone().empty());
}

TEST_CASE("What a client sent before it went is noticed as too late") {
    ClientConnections connections;
    connections.note_connection(7);
    connections.note_end(7);

    CHECK_FALSE(connections.note_message(7, given(1)));
    CHECK(connections.take_gone().empty());
}

TEST_CASE("The next connection with the same number is another client's") {
    ClientConnections connections;
    connections.note_connection(7);
    connections.note_message(7, given(1));
    connections.note_end(7);
    connections.note_connection(7);
    CHECK_FALSE(connections.knows(7, given(2)));
    CHECK(connections.note_message(7, given(2)));

    CHECK(connections.take_gone() == std::vector{given(1)});
    connections.note_end(7);
    CHECK(connections.take_gone() == std::vector{given(2)});
}

TEST_CASE("A client with an identity of its own choice may come back") {
    ClientConnections connections;
    connections.note_connection(7);
    CHECK(connections.note_message(7, "mine"));
    connections.note_end(7);

    CHECK(connections.note_message(7, "mine"));
    CHECK(connections.take_gone().empty());
}
