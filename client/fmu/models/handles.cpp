#include "handles.hpp"

#include <algorithm>

#include "variables/common_variables.hpp"

namespace contactd::fmu {
namespace {

consteval std::size_t at(std::string_view name) {
    return reference_of(common_variables, name);
}

/// Reports events during a call; the caller reports its failure.
void hear(void* user, std::int32_t level, const char* text) {
    const Tell& tell = *static_cast<const Tell*>(user);
    if (level == CONTACTD_LOG_WARNING) tell(Status::warning, text);
    if (level < CONTACTD_LOG_WARNING) tell(Status::ok, text);
}

}  // namespace

void check(std::int32_t code, const void* handle) {
    if (code == CONTACTD_OK) return;
    const std::string sentence = contactd_last_error(handle);
    throw Failure(code == CONTACTD_ABORTED ? Status::discard : Status::error,
                  sentence.empty() ? contactd_code_name(code) : sentence);
}

bool found(std::int32_t code, const void* handle) {
    if (code == CONTACTD_NOT_FOUND) return false;
    check(code, handle);
    return true;
}

void set_field(void* handle, const std::string& path, double value) {
    check(contactd_set(handle, path.c_str(), value), handle);
}

void set_keyword(void* handle, const std::string& path, std::string_view keyword) {
    check(contactd_set_word(handle, path.c_str(), std::string(keyword).c_str()), handle);
}

double read_field(void* handle, const std::string& path) {
    double value = 0;
    return found(contactd_get(handle, path.c_str(), &value), handle) ? value : 0;
}

ConnectionHandle opened(const Values& values, Tell& tell) {
    const std::string& endpoint = values.text(at("endpoint"));
    contactd_connection* made = nullptr;
    check(contactd_open(endpoint.empty() ? "local" : endpoint.c_str(), &made), nullptr);
    ConnectionHandle connection(made);
    const double step = values[at("limits.step")];
    check(contactd_set_timeout(made, step), made);
    check(contactd_set_build_timeout(made, values[at("limits.start")]), made);
    check(contactd_set_connect_timeout(made, std::min(step, values[at("limits.connect")])), made);
    check(contactd_set_log(made, hear, &tell), made);
    const std::string &server_key = values.text(at("server_key")), &own_key = values.text(at("own_key"));
    if (server_key.empty() != own_key.empty())
        throw Failure(std::string(server_key.empty() ? "own_key" : "server_key") +
                      " is set alone; server_key and own_key go together.");
    if (!own_key.empty()) check(contactd_set_keys(made, server_key.c_str(), own_key.c_str()), made);
    return connection;
}

}  // namespace contactd::fmu
