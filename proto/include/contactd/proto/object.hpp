// Creates JSON objects, member by member.
#pragma once

#include <initializer_list>
#include <utility>

#include <nlohmann/json.hpp>

namespace contactd::proto {

struct Member {
    const char* name;
    mutable nlohmann::json value;  ///< moved into the object
};

/// object({{"Fn", 1.5}, {"Fx", 0.0}}) is {"Fn": 1.5, "Fx": 0.0}. nlohmann-json's own initialiser list, which makes a
/// list of every member first, takes several times as long.
inline nlohmann::json object(std::initializer_list<Member> members) {
    nlohmann::json::object_t object;
    for (const Member& member : members) object.emplace(member.name, std::move(member.value));
    return object;
}

}  // namespace contactd::proto
