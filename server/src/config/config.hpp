// Reads the daemon's configuration: one JSON file, checked against configs/schema.json before anything runs.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/proto/message.hpp"

namespace contactd::server {

/// Holds bounds of sessions; published by server.info.
struct SessionLimits {
    std::size_t max_sessions;  ///< open at the same time
    std::size_t max_bytes;     ///< for all sessions and their states together
    std::size_t max_states;    ///< saved states of one session
    double lease_seconds;      ///< default of a request
    double max_lease_seconds;
};

/// Bounds of the data kept of the last solves.
struct RecentSolvesLimits {
    std::size_t count;      ///< solves; 0: none
    std::size_t max_bytes;  ///< limit of the pressures of all solves together; the oldest are removed first
};

/// Rules of access to methods.
struct MethodRules {
    static constexpr const char* builds = "builds";  ///< stands for builds of tables by any method
    std::vector<std::string> disabled;
    /// Maps names of methods or `builds` to users, named as by AccessControl::user_of. Methods not listed here are open
    /// to all users.
    std::map<std::string, std::vector<std::string>> allowed_users;
};

/// Holds the fields of configs/schema.json, which also contains all defaults.
struct Config {
    std::string endpoint;
    struct {
        bool allow_unencrypted_remote;
        struct {
            std::filesystem::path secret_key_file;  ///< empty: no encryption
            std::filesystem::path allowed_keys;
        } curve;
        int handshake_seconds;
        struct {
            double requests_per_second;  ///< 0: no limit
            int burst;
            std::size_t open_requests;  ///< 0: no limit
        } per_user;
    } security;
    MethodRules methods;
    int workers;
    std::chrono::microseconds spin;
    struct {
        std::filesystem::path folder;
        std::size_t memory_budget_bytes;
        std::size_t disk_budget_bytes;
        std::size_t influence_budget_bytes;
        bool share_imported_tables;
    } store;
    struct {
        int concurrent;
        std::vector<std::string> launcher;
        std::filesystem::path program;
        std::vector<std::string> environment;  ///< variables the builder gets (passed_on)
        std::size_t max_memory_bytes;
        int stall_seconds;
        int max_seconds;
        int max_failures;
        int quarantine_seconds;
    } builds;
    MessageLimits limits;
    std::size_t max_grid_elements;
    std::size_t max_queue;
    std::size_t max_inbox_bytes;
    std::size_t max_outbox_bytes;
    std::size_t max_queue_per_client;
    std::size_t max_queue_bytes;
    std::size_t max_work_bytes;
    double max_work_seconds;
    SessionLimits sessions;
    RecentSolvesLimits recent_solves;
    struct {
        std::string level;
        std::string format;
        std::filesystem::path file;
    } log;
    struct {
        std::string address;
    } http;
    struct {
        int drain_seconds;
    } shutdown;
};

/// Limits the number of values of a configuration.
inline constexpr std::size_t max_config_values = 10'000;

/// Reads a configuration. Throws contactd::Error with every problem found, including field, value and valid values.
/// `{}` results in the defaults.
Config config_from_json(const nlohmann::json& json);
/// Reads a file. `overrides` take precedence over the file, field by field (a JSON merge patch).
Config config_from_file(const std::filesystem::path& path, const nlohmann::json& overrides = nlohmann::json::object());

/// Returns the configuration with its defaults, as config_from_json reads it.
nlohmann::json to_json(const Config& config);
/// Returns the part of the configuration that users may see, without names of files, programs, variables and addresses.
nlohmann::json public_part(const Config& config);

}  // namespace contactd::server
