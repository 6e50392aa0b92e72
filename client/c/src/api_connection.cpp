// contactd.h: connections.
#include <chrono>
#include <cmath>
#include <memory>
#include <string_view>

#include "api_boundary.hpp"

using namespace contactd::c;

namespace {

using std::chrono::milliseconds;

milliseconds duration(double seconds) {
    constexpr double longest = 1e6;
    if (!(seconds > 0 && seconds <= longest))
        throw contactd::InvalidArgument("seconds", "must be more than 0 and at most 1e6");
    return std::chrono::ceil<milliseconds>(std::chrono::duration<double>(seconds));
}

std::int32_t set_duration(contactd_connection* handle, double seconds, milliseconds Settings::* which) {
    return with(handle, [&](Connection& connection) {
        const milliseconds value = duration(seconds);
        connection.change([&](Settings& settings, Log&) { settings.*which = value; });
    });
}

}  // namespace

std::int32_t contactd_open(const char* where, contactd_connection** connection) {
    try {
        *given(connection, "connection") = nullptr;
        const std::string_view place = given(where, "where");
        std::unique_ptr<const Backend> backend =
            place == "local" ? make_local_backend() : make_remote_backend(std::string(place));
        *connection = connections().add(std::make_shared<Connection>(std::move(backend)));
        return CONTACTD_OK;
    } catch (...) {
        return failed<Connection>(nullptr, nullptr);
    }
}

std::int32_t contactd_close(contactd_connection* connection) {
    return with(connection, [&](Connection&) { connections().remove(connection); });
}

std::int32_t contactd_ping(contactd_connection* connection) {
    return with(connection, [](Connection& asked) { asked.backend->ping(asked.snapshot().first); });
}

std::int32_t contactd_set_timeout(contactd_connection* connection, double seconds) {
    return set_duration(connection, seconds, &Settings::timeout);
}

std::int32_t contactd_set_build_timeout(contactd_connection* connection, double seconds) {
    return set_duration(connection, seconds, &Settings::build_timeout);
}

std::int32_t contactd_set_connect_timeout(contactd_connection* connection, double seconds) {
    return set_duration(connection, seconds, &Settings::connect_timeout);
}

std::int32_t contactd_set_keys(contactd_connection* connection, const char* server_key, const char* own_key) {
    return with(connection, [&](Connection& changed) {
        given(server_key, "server_key");
        given(own_key, "own_key");
        changed.change([&](Settings& settings, Log&) {
            settings.server_key = server_key;
            settings.own_key = own_key;
        });
    });
}

std::int32_t contactd_set_log(contactd_connection* connection, contactd_log log, void* user) {
    return with(connection,
                [&](Connection& changed) { changed.change([&](Settings&, Log& mine) { mine = {log, user, true}; }); });
}

std::int32_t contactd_set_step_timeout(contactd_contact* contact, double seconds) {
    return with(contact, [&](Contact& changed) { changed.inputs.step_timeout = duration(seconds); });
}

std::int32_t contactd_wheel_set_timeout(contactd_wheel* wheel, double seconds) {
    return with(wheel, [&](Wheel& changed) { changed.timeout = duration(seconds); });
}
