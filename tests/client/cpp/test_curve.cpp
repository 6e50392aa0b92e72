#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include <zmq.hpp>

#include "contactd/client/client.hpp"
#include "support/temporary_folder.hpp"

namespace fs = std::filesystem;
using namespace contactd::client;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using contactd::StatusError;

namespace {

struct Pair {
    std::array<char, 41> open{}, secret{};
    Pair() { REQUIRE(::zmq_curve_keypair(open.data(), secret.data()) == 0); }
};

/// Creates key files that are removed with the test.
class KeyFiles {
   public:
    fs::path write(const std::string& name, const Pair& keys, bool with_secret) const {
        const fs::path file = folder_.path() / name;
        std::ofstream text(file);
        text << "curve\n    public-key = \"" << keys.open.data() << "\"\n";
        if (with_secret) text << "    secret-key = \"" << keys.secret.data() << "\"\n";
        text.close();
        fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
        return file;
    }

   private:
    const contactd::TemporaryFolder folder_;
};

/// Provides a socket that completes handshakes, without or with encryption, and never answers.
class Listener {
   public:
    explicit Listener(const Pair* keys) : socket_(context_, zmq::socket_type::router) {
        socket_.set(zmq::sockopt::linger, 0);
        if (keys) {
            socket_.set(zmq::sockopt::curve_server, true);
            socket_.set(zmq::sockopt::curve_secretkey, keys->secret.data());
        }
        socket_.bind("tcp://127.0.0.1:*");
    }
    std::string endpoint() const { return socket_.get(zmq::sockopt::last_endpoint); }

   private:
    zmq::context_t context_;
    zmq::socket_t socket_;
};

auto says(const std::string& text) {
    return MessageMatches(ContainsSubstring(text));
}

}  // namespace

TEST_CASE("A client that encrypts gets through to a daemon that does", "[client]") {
    const KeyFiles files;
    const Pair server, own;
    const Listener listener(&server);
    ClientOptions options;
    options.timeout = std::chrono::milliseconds(10);
    options.server_key = files.write("server.key", server, false);
    options.own_key = files.write("own.key_secret", own, true);
    Client client(listener.endpoint(), options);
    CHECK_THROWS_AS(client.health(), TimeoutError);  // sent, and not answered
}

TEST_CASE("Without keys a daemon that encrypts is no silence but UNAUTHENTICATED", "[client]") {
    const Pair server;
    const Listener listener(&server);
    Client client(listener.endpoint());
    for (int attempt = 0; attempt < 2; ++attempt)
        CHECK_THROWS_MATCHES(client.health(), StatusError, says("give server_key and own_key"));
}

TEST_CASE("The wrong key of the daemon is named", "[client]") {
    const KeyFiles files;
    const Pair server, other, own;
    const Listener listener(&server);
    ClientOptions options;
    options.server_key = files.write("server.key", other, false);
    options.own_key = files.write("own.key_secret", own, true);
    Client client(listener.endpoint(), options);
    CHECK_THROWS_MATCHES(client.health(), StatusError, says("server_key is not the daemon's key"));
}

TEST_CASE("A daemon that does not encrypt is named", "[client]") {
    const KeyFiles files;
    const Pair server, own;
    const Listener listener(nullptr);
    ClientOptions options;
    options.server_key = files.write("server.key", server, false);
    options.own_key = files.write("own.key_secret", own, true);
    Client client(listener.endpoint(), options);
    CHECK_THROWS_MATCHES(client.health(), StatusError, says("not use encryption"));
}

TEST_CASE("Key files that cannot be used are refused before anything is sent", "[client]") {
    const KeyFiles files;
    const Pair keys;
    ClientOptions options;
    const auto refusal = [&](const std::string& text) {
        CHECK_THROWS_MATCHES(Client("tcp://127.0.0.1:1", options), contactd::Error, says(text));
    };
    options.server_key = files.write("server.key", keys, false);
    refusal("own_key is missing");
    options.own_key = options.server_key;
    refusal("contains no secret key");
    options.own_key = "/nonexistent/own.key_secret";
    refusal("/nonexistent/own.key_secret");
    options.own_key = files.write("own.key_secret", keys, true);
    fs::permissions(options.own_key, fs::perms::others_read, fs::perm_options::add);
    refusal("chmod 600");
}
