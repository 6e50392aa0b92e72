// contactd: serves influence coefficients and contact solves.
//
//   contactd --config configs/contactd.json
//
// Prints one JSON line with the endpoint when it listens, logs to standard error, ends in order on SIGTERM and SIGINT.
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "config.hpp"
#include "contactd/version.hpp"
#include "endpoint.hpp"
#include "service.hpp"

namespace {

using namespace contactd::server;

constexpr int status_bad_configuration = 2;

void start_log(const Config& config) {
    const auto logger = config.log.file.empty() ? spdlog::stderr_logger_mt("contactd")
                                                : spdlog::basic_logger_mt("contactd", config.log.file.string());
    logger->set_pattern("%Y-%m-%dT%H:%M:%S.%e %l %v");
    logger->set_level(spdlog::level::from_str(config.log.level));
    logger->flush_on(spdlog::level::info);
    spdlog::set_default_logger(logger);
}

/// Blocks the ending signals for this thread and those it starts, and gives the descriptor they arrive at instead.
int ending_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGINT);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::signal(SIGPIPE, SIG_IGN);  // a builder that died is noticed by the error of the write
    return ::signalfd(-1, &signals, SFD_CLOEXEC);
}

bool is_private(const std::string& endpoint) {
    return endpoint.starts_with("ipc://") || endpoint.starts_with("tcp://127.") ||
           endpoint.starts_with("tcp://[::1]") || endpoint.starts_with("tcp://localhost:");
}

int serve(const Config& config) {
    const int signals = ending_signals();
    start_log(config);
    Service service(config);
    Endpoint endpoint(config, service);
    if (!is_private(endpoint.address()))
        spdlog::warn("{} can be reached from other machines, and whoever reaches it can use it", endpoint.address());
    spdlog::info("contactd {} listens at {}, store {}", contactd::version(), endpoint.address(),
                 config.store.folder.string());
    std::cout << nlohmann::json{{"ready", true}, {"endpoint", endpoint.address()}, {"pid", ::getpid()}} << std::endl;
    endpoint.run(signals);
    spdlog::info("ended");
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("contactd: influence coefficients and elastic contact, as a service.");
    std::string config_file, endpoint;
    bool print_config = false;
    app.add_option("-c,--config", config_file, "configuration (JSON); without one the defaults hold");
    app.add_option("-e,--endpoint", endpoint, "where to listen, in place of the configuration's endpoint");
    app.add_flag("--print-config", print_config, "print the configuration with its defaults, and end");
    app.set_version_flag("-v,--version", "contactd " + contactd::version());
    CLI11_PARSE(app, argc, argv);

    Config config;
    try {
        nlohmann::json overrides = nlohmann::json::object();
        config = config_file.empty() ? config_from_json(overrides) : config_from_file(config_file);
        if (!endpoint.empty()) config.endpoint = endpoint;
    } catch (const std::exception& error) {
        std::cerr << "contactd: " << error.what() << "\n";
        return status_bad_configuration;
    }
    if (print_config) {
        std::cout << to_json(config).dump(2) << "\n";
        return 0;
    }
    try {
        return serve(config);
    } catch (const std::exception& error) {
        std::cerr << "contactd: " << error.what() << "\n";
        return 1;
    }
}
