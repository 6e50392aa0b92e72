// Provides a real daemon for one test, in a temporary folder.
#pragma once

#include <catch2/catch_test_macros.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <reproc++/reproc.hpp>

#include "support/temporary_folder.hpp"

/// Ends its daemon with the test.
class Daemon {
   public:
    Daemon() : endpoint_("ipc://" + (folder_.path() / "socket").string()) {
        const std::filesystem::path config = folder_.path() / "contactd.json";
        const nlohmann::json values{{"endpoint", endpoint_},
                                    {"store", {{"folder", (folder_.path() / "store").string()}}}};
        std::ofstream(config) << values;
        start();
    }
    const std::string& endpoint() const { return endpoint_; }
    /// Ends it, and starts another one at the same endpoint, which has no sessions.
    void restart() {
        process_.stop(ending());
        process_ = reproc::process();
        start();
    }

   private:
    static reproc::stop_actions ending() {
        return {{reproc::stop::terminate, std::chrono::seconds(10)}, {reproc::stop::kill, std::chrono::seconds(5)}, {}};
    }
    void start() {
        reproc::options options;
        options.redirect.discard = true;
        options.stop = ending();
        const std::vector<std::string> command{DAEMON, "--config", (folder_.path() / "contactd.json").string()};
        REQUIRE_FALSE(process_.start(command, options));
    }

    contactd::TemporaryFolder folder_;
    std::string endpoint_;
    reproc::process process_;  // ended before the folder is removed
};
