#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <filesystem>
#include <fstream>

#include "config/config.hpp"
#include "config/endpoint_rules.hpp"
#include "contactd/error.hpp"

using namespace contactd::server;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using nlohmann::json;

TEST_CASE("An empty configuration gives the defaults, which are safe") {
    const Config config = config_from_json(json::object());

    CHECK(config.endpoint == "tcp://127.0.0.1:5555");
    CHECK(config.workers == 2);
    CHECK(config.spin.count() == 0);
    CHECK(config.builds.concurrent == 1);
    CHECK(config.builds.launcher.empty());
    CHECK(config.builds.program.filename() == "contactd-ic");
    CHECK(config.store.folder.filename() == "store");
    CHECK(config.max_queue == 256);
    CHECK(config.max_inbox_bytes == 512u << 20u);
    CHECK(config.max_outbox_bytes == 512u << 20u);
    CHECK(config.http.address.empty());
    CHECK(config.shutdown.drain_seconds == 10);
    CHECK(config.log.format == "text");
    CHECK(config.max_queue_per_client == 128);
    CHECK(config.max_queue_bytes == 1u << 30);
    CHECK(config.sessions.max_sessions == 256);
    CHECK(config.sessions.max_bytes == std::size_t{1} << 30u);
    CHECK(config.sessions.max_states == 64);
    CHECK(config.sessions.lease_seconds == 300);
    CHECK(config.sessions.max_lease_seconds == 86400);
}

TEST_CASE("What is given wins over the defaults, the rest of its section keeps them") {
    const Config config = config_from_json({{"builds", {{"launcher", {"mpirun", "-np", "2"}}}}, {"workers", 7}});

    CHECK(config.workers == 7);
    CHECK(config.builds.launcher.size() == 3);
    CHECK(config.builds.concurrent == 1);
}

TEST_CASE("A printed configuration reads back as itself") {
    const Config config = config_from_json({{"workers", 3}, {"log", {{"level", "off"}}}});

    CHECK(to_json(config_from_json(to_json(config))) == to_json(config));
}

TEST_CASE("Every problem of a configuration is named with its field") {
    struct Case {
        json given;
        const char* field;
    };
    const auto [given, field] = GENERATE(
        Case{{{"wokers", 2}}, "wokers"}, Case{{{"workers", 0}}, "workers"}, Case{{{"workers", "two"}}, "workers"},
        Case{{{"endpoint", "http://somewhere"}}, "endpoint"}, Case{{{"store", {{"path", "x"}}}}, "store.path"},
        Case{{{"log", {{"level", "loud"}}}}, "log.level"}, Case{{{"log", {{"format", "xml"}}}}, "log.format"},
        Case{{{"http", {{"address", "localhost:80"}}}}, "http.address"},
        Case{{{"http", {{"address", "9465"}}}}, "http.address"},
        Case{{{"http", {{"address", "127.0.0.1:65536"}}}}, "http.address"},
        Case{{{"shutdown", {{"drain_seconds", -1}}}}, "shutdown.drain_seconds"},
        Case{{{"builds", {{"launcher", "mpirun"}}}}, "builds.launcher"},
        Case{{{"limits", {{"max_frames", -1}}}}, "limits.max_frames"},
        Case{{{"sessions", {{"lease_seconds", 0}}}}, "sessions.lease_seconds"});

    CHECK_THROWS_MATCHES(config_from_json(given), contactd::Error, MessageMatches(ContainsSubstring(field)));
}

TEST_CASE("Methods that there are can be switched off and given to users") {
    const Config config = config_from_json(
        {{"methods",
          {{"disabled", {"ic.delete"}},
           {"allowed_users",
            {{"ic.import", {"alice", "uid:1000", "192.168.0.7", "::1", "b_o.b-2@x"}}, {"builds", json::array()}}}}}});

    CHECK(config.methods.disabled == std::vector<std::string>{"ic.delete"});
    CHECK(config.methods.allowed_users.at("ic.import").size() == 5);
    CHECK(config.methods.allowed_users.at("builds").empty());
    CHECK(to_json(config_from_json(to_json(config))) == to_json(config));
    CHECK(public_part(config)["methods"] == to_json(config)["methods"]);
}

TEST_CASE("A misspelt method or user is refused, since it would leave open what was meant to be closed") {
    const auto [given, sentence] = GENERATE(table<json, const char*>({
        {{{"disabled", {"ic.get", "ic.imprt"}}}, R"(methods.disabled[1] is "ic.imprt", which is not a method)"},
        {{{"disabled", {"builds"}}}, "methods.disabled[0]"},
        {{{"disabled", {"ic.*"}}}, "methods.disabled[0]"},
        {{{"disabled", "ic.get"}}, "methods.disabled"},
        {{{"allowed_users", {{"ic.Import", {"alice"}}}}},
         R"(methods.allowed_users is "ic.Import", which is not a method)"},
        {{{"allowed_users", {{"ic.import", "alice"}}}}, "methods.allowed_users"},
        {{{"allowed_users", {{"ic.import", {""}}}}}, "methods.allowed_users"},
        {{{"allowed_users", {{"ic.import", {"uid:alice"}}}}}, "methods.allowed_users"},
        {{{"allowed_users", {{"ic.import", {"uid: 1000"}}}}}, "methods.allowed_users"},
        {{{"allow_users", json::object()}}, "methods.allow_users"},
    }));

    CHECK_THROWS_MATCHES(config_from_json({{"methods", given}}), contactd::Error,
                         MessageMatches(ContainsSubstring(sentence)));
}

TEST_CASE("A configuration that is no JSON, no object or no file is refused with its name") {
    const auto path = std::filesystem::temp_directory_path() / "contactd-test-config.json";
    std::ofstream(path) << "{\"workers\": ";
    CHECK_THROWS_MATCHES(config_from_file(path), contactd::Error, MessageMatches(ContainsSubstring(path.string())));
    std::ofstream(path) << "[]";
    CHECK_THROWS_MATCHES(config_from_file(path), contactd::Error,
                         MessageMatches(ContainsSubstring("not a JSON object")));
    std::filesystem::remove(path);
    CHECK_THROWS_MATCHES(config_from_file(path.parent_path()), contactd::Error,
                         MessageMatches(ContainsSubstring("is a folder")));
    CHECK_THROWS_MATCHES(config_from_file("/dev/zero"), contactd::Error,
                         MessageMatches(ContainsSubstring("exceeds the limit of 1 MiB")));
    CHECK_THROWS_MATCHES(config_from_file(path), contactd::Error,
                         MessageMatches(ContainsSubstring("cannot be read: No such file")));
}

TEST_CASE("A field that stands twice in a configuration is refused with its name") {
    const auto path = std::filesystem::temp_directory_path() / "contactd-test-twice.json";
    std::ofstream(path) << R"({"workers": 3, "store": {"folder": "a", "folder": "b"}})";
    CHECK_THROWS_MATCHES(config_from_file(path), contactd::Error,
                         MessageMatches(ContainsSubstring(path.string() + ": store.folder is given twice")));
    std::filesystem::remove(path);
}

TEST_CASE("The configurations that come with contactd can be used") {
    for (const char* name : {"contactd.json", "mpi.json", "container.json"})
        CHECK_NOTHROW(config_from_file(std::filesystem::path(CONFIGS) / name));
}

TEST_CASE("An address that is not surely this machine's own needs keys, or the flag") {
    const std::string endpoint =
        GENERATE("tcp://*:5555", "tcp://0.0.0.0:5555", "tcp://[::]:5555", "tcp://eth0:5555", "tcp://no.such.host:5555",
                 "tcp://127.0.0.1@evil:1", "tcp://127.1:5555", "tcp://0x7f000001:5555", "tcp://[::ffff:127.0.0.1]:5555",
                 "tcp://[::1", "tcp://128.0.0.1:5555");
    CHECK_FALSE(is_local(endpoint));
    CHECK_THROWS_MATCHES(config_from_json({{"endpoint", endpoint}}), contactd::Error,
                         MessageMatches(ContainsSubstring("security.curve")));

    CHECK_NOTHROW(config_from_json({{"endpoint", endpoint}, {"security", {{"allow_unencrypted_remote", true}}}}));
    const json curve{{"secret_key_file", "a"}, {"allowed_keys", "b"}};
    CHECK_NOTHROW(config_from_json({{"endpoint", endpoint}, {"security", {{"curve", curve}}}}));
}

TEST_CASE(
    "An endpoint without a port that there is, or without a path, is refused, and the refusal states what would be "
    "right") {
    const std::string endpoint =
        GENERATE("tcp://127.0.0.1", "tcp://127.0.0.1:", "tcp://127.0.0.1:-5", "tcp://127.0.0.1:5x",
                 "tcp://127.0.0.1:65536", "tcp://127.0.0.1:70000", "tcp://:5555", "ipc://", "127.0.0.1:5555", "");
    CHECK_THROWS_MATCHES(
        config_from_json({{"endpoint", endpoint}}), contactd::Error,
        MessageMatches(ContainsSubstring("endpoint is \"" + endpoint + "\"; it must be tcp://ADDRESS:PORT") &&
                       ContainsSubstring("65535") && ContainsSubstring("ipc://PATH")));
}

TEST_CASE("The largest port is one") {
    CHECK_NOTHROW(config_from_json({{"endpoint", "tcp://127.0.0.1:65535"}}));
    CHECK_NOTHROW(config_from_json({{"endpoint", "tcp://127.0.0.1:0"}}));
}

TEST_CASE("A variable's name that cannot be one is refused with its place") {
    CHECK_THROWS_MATCHES(config_from_json({{"builds", {{"environment", {"PATH", "A-B"}}}}}), contactd::Error,
                         MessageMatches(ContainsSubstring("builds.environment[1] is \"A-B\"; it must be the name")));
}

TEST_CASE("Loopback and ipc need nothing") {
    const std::string endpoint =
        GENERATE("ipc:///tmp/s", "tcp://127.0.0.1:5555", "tcp://127.8.7.6:*", "tcp://[::1]:5555");
    CHECK(is_local(endpoint));
    CHECK_NOTHROW(config_from_json({{"endpoint", endpoint}}));
}

TEST_CASE("A name that stands for this machine alone is its address") {
    const Config config = config_from_json({{"endpoint", "tcp://localhost:5555"}});
    CHECK(is_local(config.endpoint));
    CHECK((config.endpoint == "tcp://127.0.0.1:5555" || config.endpoint == "tcp://[::1]:5555"));
}

TEST_CASE("A log that would be written into what the daemon keeps or reads is refused") {
    const json given{
        {"endpoint", "ipc:///tmp/contactd-x/s"},
        {"store", {{"folder", "/tmp/contactd-x/store"}}},
        {"builds", {{"program", "/tmp/contactd-x/contactd-ic"}}},
        {"security",
         {{"curve",
           {{"secret_key_file", "/tmp/contactd-x/daemon.key_secret"}, {"allowed_keys", "/tmp/contactd-x/keys"}}}}}};
    const auto with_log = [&](const std::string& file) {
        json changed = given;
        changed["log"]["file"] = file;
        return changed;
    };
    struct Case {
        const char *file, *field;
    };
    const auto [file, field] =
        GENERATE(Case{"/tmp/contactd-x/store/contactd.log", "store.folder"},
                 Case{"/tmp/contactd-x/store/../store/a/b.h5", "store.folder"},
                 Case{"/tmp/contactd-x/keys/ada.key", "security.curve.allowed_keys"},
                 Case{"/tmp/contactd-x/daemon.key_secret", "security.curve.secret_key_file"},
                 Case{"/tmp/contactd-x/contactd-ic", "builds.program"}, Case{"/tmp/contactd-x/s", "endpoint"});

    CHECK_THROWS_MATCHES(config_from_json(with_log(file)), contactd::Error,
                         MessageMatches(ContainsSubstring("log.file") && ContainsSubstring(field)));
    CHECK_NOTHROW(config_from_json(with_log("/tmp/contactd-x/store.log")));
}

TEST_CASE("An override is part of what is checked") {
    const auto path = std::filesystem::temp_directory_path() / "contactd-test-override.json";
    std::ofstream(path) << R"({"endpoint": "tcp://*:5555", "workers": 3})";
    const Config config = config_from_file(path, {{"endpoint", "ipc:///tmp/s"}});
    CHECK(config.endpoint == "ipc:///tmp/s");
    CHECK(config.workers == 3);
    CHECK_THROWS_AS(config_from_file(path), contactd::Error);
    std::filesystem::remove(path);
}
