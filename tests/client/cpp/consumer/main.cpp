// Uses the installed client, and succeeds if the client reports that no daemon listens.
#include <chrono>

#include <contactd/client/client.hpp>
#include <contactd/client/session.hpp>

#ifdef NLOHMANN_JSON_VERSION_MAJOR
#error "The client's headers bring nlohmann-json along, of which its users need to know nothing."
#endif

int main() {
    contactd::client::ClientOptions options;
    options.connect_timeout = std::chrono::milliseconds(50);
    contactd::client::Client client("tcp://127.0.0.1:1", options);
    try {
        client.health();
    } catch (const contactd::client::ConnectionError&) {
        return 0;
    }
    return 1;
}
