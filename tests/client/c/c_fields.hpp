// Sets and reads the fields of a contact or a wheel in tests.
#pragma once

#include <catch2/catch_test_macros.hpp>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "contactd.h"

/// Fails the test with the message of the library unless `code` is CONTACTD_OK.
inline void require_ok(std::int32_t code, const void* handle) {
    INFO(contactd_last_error(handle));
    REQUIRE(code == CONTACTD_OK);
}

using Numbers = std::vector<double>;

inline void set(void* handle, const std::string& path, double value) {
    require_ok(contactd_set(handle, path.c_str(), value), handle);
}
inline void set(void* handle, const std::vector<std::pair<std::string, double>>& fields) {
    for (const auto& [path, value] : fields) set(handle, path, value);
}
inline void set_word(void* handle, const std::string& path, const std::string& word) {
    require_ok(contactd_set_word(handle, path.c_str(), word.c_str()), handle);
}
inline void set_array(void* handle, const std::string& path, const Numbers& values) {
    require_ok(contactd_set_array(handle, path.c_str(), values.data(), static_cast<std::int32_t>(values.size())),
               handle);
}
inline void clear(void* handle, const std::string& path) {
    require_ok(contactd_clear(handle, path.c_str()), handle);
}

inline double get(void* handle, const std::string& path) {
    double value = 0;
    require_ok(contactd_get(handle, path.c_str(), &value), handle);
    return value;
}
/// Returns whether the last solve or step has the field.
inline bool has(void* handle, const std::string& path) {
    std::int32_t count = 0;
    const std::int32_t code = contactd_length(handle, path.c_str(), &count);
    if (code != CONTACTD_NOT_FOUND) require_ok(code, handle);
    return code == CONTACTD_OK;
}
inline Numbers get_array(void* handle, const std::string& path) {
    std::int32_t count = 0;
    require_ok(contactd_length(handle, path.c_str(), &count), handle);
    Numbers values(static_cast<std::size_t>(count));
    require_ok(contactd_get_array(handle, path.c_str(), values.data(), count), handle);
    return values;
}
inline std::string get_word(void* handle, const std::string& path) {
    char text[500] = {};
    require_ok(contactd_get_word(handle, path.c_str(), text, sizeof text), handle);
    return text;
}
