#include "config.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <regex>

#include "config_schema.hpp"
#include "contactd/error.hpp"
#include "contactd/proto/json_reader.hpp"
#include "contactd/proto/schema.hpp"
#include "endpoint_rules.hpp"
#include "engine/environment.hpp"

namespace contactd::server {
namespace {

using nlohmann::json;

const json& config_schema() {
    static const json schema = json::parse(config_schema_text);
    return schema;
}

/// Returns `value` with the schema's defaults for missing members.
json with_defaults(const json& schema, json value) {
    const auto properties = schema.find("properties");
    if (properties == schema.end()) return value;
    for (const auto& [name, property] : properties->items())
        value[name] = with_defaults(property, value.contains(name) ? value[name] : property.at("default"));
    return value;
}

std::filesystem::path default_store_folder() {
    const std::filesystem::path folder = engine::default_store_folder();
    if (!folder.empty()) return folder;
    throw Error("store.folder is empty, and neither XDG_CACHE_HOME nor HOME is set; give a folder.");
}

/// Accepts numerical addresses only, because a name might resolve to an address that others can reach.
std::string http_problem(const json& given) {
    const json* address = &given;
    for (const char* name : {"http", "address"}) {
        if (!address->is_object() || !address->contains(name)) return {};
        address = &address->at(name);
    }
    static const std::regex numbers(R"(([0-9.]+|\[[0-9A-Fa-f:]+\]):[0-9]{1,5})");
    if (!address->is_string() || address->get_ref<const std::string&>().empty()) return {};
    const auto& text = address->get_ref<const std::string&>();
    if (text.size() < 64 && std::regex_match(text, numbers) && std::stoi(text.substr(text.rfind(':') + 1)) <= 65535)
        return {};
    return "http.address is " + json(text).dump() +
           "; it must be ADDRESS:PORT in numbers, with a port from 0 to 65535, e.g. 127.0.0.1:9465";
}

std::filesystem::path default_builder() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "contactd-ic";
}

/// Returns sentences on methods that do not exist, each after "\n  ", because a misspelt name must not leave a method
/// unrestricted.
std::string method_problems(const json& given) {
    const auto at = given.find("methods");
    if (at == given.end() || !at->is_object()) return {};
    std::string problems;
    const std::vector<std::string>& known = proto::method_names();
    const auto check = [&](const std::string& field, const std::string& name) {
        if (std::find(known.begin(), known.end(), name) != known.end()) return;
        problems += "\n  " + field + " is " + json(name).dump() +
                    ", which is not a method; see docs/protocol.md for their names, such as ic.import";
    };
    if (const auto disabled = at->find("disabled"); disabled != at->end() && disabled->is_array())
        for (std::size_t i = 0; i < disabled->size(); ++i)
            if ((*disabled)[i].is_string()) check("methods.disabled[" + std::to_string(i) + "]", (*disabled)[i]);
    if (const auto allowed = at->find("allowed_users"); allowed != at->end() && allowed->is_object())
        for (const auto& [name, users] : allowed->items())
            if (name != MethodRules::builds) check("a name in methods.allowed_users", name);
    return problems;
}

}  // namespace

Config config_from_json(const json& given) {
    if (!given.is_object()) throw Error("The configuration is not a JSON object, {...}.");
    std::string problems;
    for (const auto& [field, description] : proto::violations_against(config_schema(), given))
        problems += "\n  " + field + " " + description;
    if (const std::string problem = http_problem(given); !problem.empty()) problems += "\n  " + problem;
    problems += method_problems(given);
    if (!problems.empty()) throw Error("The configuration cannot be used:" + problems);

    const json all = with_defaults(config_schema(), given);
    Config config;
    config.endpoint = with_loopback_number(all["endpoint"]);
    const json& security = all["security"];
    config.security = {
        security["allow_unencrypted_remote"],
        {security["curve"]["secret_key_file"].get<std::string>(), security["curve"]["allowed_keys"].get<std::string>()},
        security["handshake_seconds"],
        {security["per_user"]["requests_per_second"], security["per_user"]["burst"],
         security["per_user"]["open_requests"]}};
    config.methods = {all["methods"]["disabled"], all["methods"]["allowed_users"]};
    config.workers = all["workers"];
    config.spin = std::chrono::microseconds(all["spin_microseconds"].get<int>());
    const std::string folder = all["store"]["folder"], program = all["builds"]["program"];
    config.store = {folder.empty() ? default_store_folder() : std::filesystem::path(folder),
                    all["store"]["memory_budget_bytes"], all["store"]["disk_budget_bytes"],
                    all["store"]["influence_budget_bytes"], all["store"]["share_imported_tables"]};
    const json& builds = all["builds"];
    config.builds = {builds["concurrent"],
                     builds["launcher"],
                     program.empty() ? default_builder() : std::filesystem::path(program),
                     builds["environment"],
                     builds["max_memory_bytes"],
                     builds["stall_seconds"],
                     builds["max_seconds"],
                     builds["max_failures"],
                     builds["quarantine_seconds"]};
    const json& limits = all["limits"];
    config.limits = {limits["max_frame_bytes"], limits["max_frames"], limits["max_message_bytes"],
                     limits["max_array_elements"]};
    config.max_grid_elements = limits["max_grid_elements"];
    config.max_queue = limits["max_queue"];
    config.max_inbox_bytes = limits["max_inbox_bytes"];
    config.max_outbox_bytes = limits["max_outbox_bytes"];
    config.max_queue_per_client = limits["max_queue_per_client"];
    config.max_queue_bytes = limits["max_queue_bytes"];
    config.max_work_bytes = limits["max_work_bytes"];
    config.max_work_seconds = limits["max_work_seconds"];
    const json& sessions = all["sessions"];
    config.sessions = {sessions["max_sessions"], sessions["max_bytes"], sessions["max_states"],
                       sessions["lease_seconds"], sessions["max_lease_seconds"]};
    config.recent_solves = {all["recent_solves"]["count"], all["recent_solves"]["max_bytes"]};
    config.log = {all["log"]["level"], all["log"]["format"], all["log"]["file"].get<std::string>()};
    config.http = {all["http"]["address"]};
    config.shutdown = {all["shutdown"]["drain_seconds"]};
    check_endpoint(config);
    check_log_file(config);
    return config;
}

namespace {

/// Reads regular files only, because a device may never end.
std::string read_configuration(const std::filesystem::path& path) {
    constexpr std::size_t most_bytes = 1 << 20;
    std::ifstream file(path);
    if (!file) throw Error("The configuration " + path.string() + " cannot be read: " + std::strerror(errno) + ".");
    if (std::filesystem::is_directory(path)) throw Error("The configuration " + path.string() + " is a folder.");
    std::string text(most_bytes + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.size() > most_bytes) throw Error("The configuration " + path.string() + " exceeds the limit of 1 MiB.");
    return text;
}

}  // namespace

Config config_from_file(const std::filesystem::path& path, const json& overrides) {
    const std::string text = read_configuration(path);
    try {
        json given;
        proto::read_json(text, max_config_values, given, "The configuration");
        if (given.is_object()) given.merge_patch(overrides);
        return config_from_json(given);
    } catch (const Error& error) {
        throw Error(path.string() + ": " + error.what());
    }
}

json to_json(const Config& config) {
    const auto& security = config.security;
    return {{"endpoint", config.endpoint},
            {"security",
             {{"allow_unencrypted_remote", security.allow_unencrypted_remote},
              {"curve",
               {{"secret_key_file", security.curve.secret_key_file.string()},
                {"allowed_keys", security.curve.allowed_keys.string()}}},
              {"handshake_seconds", security.handshake_seconds},
              {"per_user",
               {{"requests_per_second", security.per_user.requests_per_second},
                {"burst", security.per_user.burst},
                {"open_requests", security.per_user.open_requests}}}}},
            {"methods", {{"disabled", config.methods.disabled}, {"allowed_users", config.methods.allowed_users}}},
            {"workers", config.workers},
            {"spin_microseconds", config.spin.count()},
            {"store",
             {{"folder", config.store.folder.string()},
              {"memory_budget_bytes", config.store.memory_budget_bytes},
              {"disk_budget_bytes", config.store.disk_budget_bytes},
              {"influence_budget_bytes", config.store.influence_budget_bytes},
              {"share_imported_tables", config.store.share_imported_tables}}},
            {"builds",
             {{"concurrent", config.builds.concurrent},
              {"launcher", config.builds.launcher},
              {"program", config.builds.program.string()},
              {"environment", config.builds.environment},
              {"max_memory_bytes", config.builds.max_memory_bytes},
              {"stall_seconds", config.builds.stall_seconds},
              {"max_seconds", config.builds.max_seconds},
              {"max_failures", config.builds.max_failures},
              {"quarantine_seconds", config.builds.quarantine_seconds}}},
            {"limits",
             {{"max_frame_bytes", config.limits.max_frame_bytes},
              {"max_frames", config.limits.max_frames},
              {"max_message_bytes", config.limits.max_message_bytes},
              {"max_array_elements", config.limits.max_array_elements},
              {"max_grid_elements", config.max_grid_elements},
              {"max_queue", config.max_queue},
              {"max_inbox_bytes", config.max_inbox_bytes},
              {"max_outbox_bytes", config.max_outbox_bytes},
              {"max_queue_per_client", config.max_queue_per_client},
              {"max_queue_bytes", config.max_queue_bytes},
              {"max_work_bytes", config.max_work_bytes},
              {"max_work_seconds", config.max_work_seconds}}},
            {"sessions",
             {{"max_sessions", config.sessions.max_sessions},
              {"max_bytes", config.sessions.max_bytes},
              {"max_states", config.sessions.max_states},
              {"lease_seconds", config.sessions.lease_seconds},
              {"max_lease_seconds", config.sessions.max_lease_seconds}}},
            {"recent_solves", {{"count", config.recent_solves.count}, {"max_bytes", config.recent_solves.max_bytes}}},
            {"log", {{"level", config.log.level}, {"format", config.log.format}, {"file", config.log.file.string()}}},
            {"http", {{"address", config.http.address}}},
            {"shutdown", {{"drain_seconds", config.shutdown.drain_seconds}}}};
}

json public_part(const Config& config) {
    json all = to_json(config);
    for (const char* secret : {"/endpoint", "/security/curve", "/store/folder", "/builds/launcher", "/builds/program",
                               "/builds/environment", "/log/file", "/http"}) {
        const json::json_pointer place(secret);
        all.at(place.parent_pointer()).erase(place.back());
    }
    all["security"]["encrypted"] = !config.security.curve.secret_key_file.empty();
    return all;
}

}  // namespace contactd::server
