// Runs contactd, which serves influence coefficients and contact solves.
//
//   contactd --config configs/contactd.json The daemon prints one JSON line with the endpoint when it listens, and logs
// to standard error. It shuts down on SIGTERM and SIGINT. On SIGHUP it reopens its log file and reads the allowed keys
// again. Exit status: 0; 2 for an invalid command line or configuration; 1 otherwise.
#include <spdlog/spdlog.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "access/curve_keys.hpp"
#include "check_config.hpp"
#include "config/config.hpp"
#include "config/endpoint_rules.hpp"
#include "contactd/version.hpp"
#include "endpoint.hpp"
#include "methods/collect_metrics.hpp"
#include "methods/cost_examples.hpp"
#include "operation/about.hpp"
#include "operation/log.hpp"
#include "operation/metrics/http_listener.hpp"
#include "operation/notify.hpp"
#include "operation/ping.hpp"
#include "service/service.hpp"

namespace {

using namespace contactd::server;

constexpr int status_unusable = 2;  // command line or configuration

/// Blocks SIGTERM, SIGINT and SIGHUP for this thread and the threads it starts. Returns the descriptor that receives
/// them instead.
int signal_descriptor() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&signals, signal);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::signal(SIGPIPE, SIG_IGN);  // A write error reveals a builder that died.
    return ::signalfd(-1, &signals, SFD_CLOEXEC);
}

std::unique_ptr<HttpListener> listen_to_http(const Config& config, const DaemonParts& parts) {
    if (config.http.address.empty()) return nullptr;
    auto http = std::make_unique<HttpListener>(
        config.http.address, HttpListener::Pages{[&parts] { return to_prometheus(collect_metrics(parts, true)); },
                                                 [&parts] { return parts.health.not_ready(); }});
    spdlog::info("metrics at http://{}/metrics", http->address());
    return http;
}

int serve(const Config& config) {
    const int signals = signal_descriptor();
    Log log(config);
    const Notifier notifier;
    Service service(config, {.libraries = daemon_library_versions(), .log = log_line});
    const auto http = listen_to_http(config, service.parts());
    Endpoint endpoint(config, service);
    if (!is_local(endpoint.address()) && config.security.curve.secret_key_file.empty())
        spdlog::warn("{} can be reached from other machines, and everyone who reaches it can use it",
                     endpoint.address());
    spdlog::info("contactd {} listens at {}, store {}", contactd::version(), endpoint.address(),
                 config.store.folder.string());
    nlohmann::json ready{{"ready", true}, {"endpoint", endpoint.address()}, {"pid", ::getpid()}};
    if (http) ready["http"] = http->address();
    std::cout << ready << std::endl;
    endpoint.run(signals, notifier, [&] { log.reopen(); });
    spdlog::info("ended");
    return 0;
}

int answer_ping(const std::string& endpoint, const PingKeys& keys) {
    const PingResult result = ping(endpoint, keys, std::chrono::seconds(5));
    (result.serving ? std::cout : std::cerr) << result.text << "\n";
    return result.serving ? 0 : 1;
}

int make_keys(const std::string& folder, const std::string& name) {
    try {
        const NewKeys files = generate_keys(folder, name);
        std::cout << "secret key, only for " << name << ":  " << files.secret_file.string() << "\n"
                  << "public key, for others:  " << files.public_file.string() << "\n";
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "contactd: " << error.what() << "\n";
        return 1;
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("contactd: influence coefficients and elastic contact, as a service.");
    std::string config_file, endpoint, ping_endpoint, key_name, key_folder = ".";
    PingKeys ping_keys;
    bool print_config = false, print_costs = false, only_check = false;
    app.add_option("-c,--config", config_file, "configuration file (JSON); default: built-in values");
    app.add_option("-e,--endpoint", endpoint, "address to listen at, instead of the configuration's endpoint");
    app.add_flag("--print-config", print_config, "print the configuration with its defaults, and exit");
    app.add_flag("--print-costs", print_costs,
                 "print the estimated cost of large requests of each method (JSON), and exit");
    app.add_flag("--check-config", only_check, "check the configuration for problems, and exit");
    CLI::Option* asks =
        app.add_option("--ping", ping_endpoint, "ask the daemon at this address whether it is serving, and exit");
    CLI::Option* server_key =
        app.add_option("--server-key", ping_keys.server, "for --ping: file with the public key of an encrypted daemon");
    CLI::Option* own_key =
        app.add_option("--own-key", ping_keys.own, "for --ping: file NAME.key_secret of an allowed user");
    server_key->needs(asks, own_key);
    own_key->needs(asks, server_key);
    app.set_version_flag("-v,--version", about());
    CLI::App* keygen = app.add_subcommand("keygen", "create a pair of CURVE keys (docs/security.md), and exit");
    keygen->add_option("NAME", key_name, "name of the user or daemon that owns the keys")->required();
    keygen->add_option("-f,--folder", key_folder, "folder for NAME.key and NAME.key_secret")->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked_for_help) {
        return app.exit(asked_for_help);
    } catch (const CLI::ParseError& error) {
        app.exit(error);  // prints the error; CLI11 has other statuses
        return status_unusable;
    }
    if (keygen->parsed()) return make_keys(key_folder, key_name);
    if (!ping_endpoint.empty()) return answer_ping(ping_endpoint, ping_keys);

    Config config;
    try {
        nlohmann::json overrides = nlohmann::json::object();
        if (!endpoint.empty()) overrides["endpoint"] = endpoint;
        config = config_file.empty() ? config_from_json(overrides) : config_from_file(config_file, overrides);
    } catch (const std::exception& error) {
        std::cerr << "contactd: " << error.what() << "\n";
        return status_unusable;
    }
    if (print_config) {
        std::cout << to_json(config).dump(2) << "\n";
        return 0;
    }
    if (print_costs) {
        std::cout << cost_examples(config).dump(1) << "\n";
        return 0;
    }
    if (only_check) return check_config(config, std::cout, std::cerr) == 0 ? 0 : status_unusable;
    try {
        return serve(config);
    } catch (const std::exception& error) {
        std::cerr << "contactd: " << error.what() << "\n";
        return 1;
    }
}
