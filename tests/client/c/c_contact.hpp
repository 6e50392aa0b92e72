// Provides contacts of the C interface for tests: a place to solve them, and handles that free themselves.
#pragma once

#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "c_fields.hpp"

class Place {
   public:
    explicit Place(const std::string& where, double connect_timeout = 20) {
        require_ok(contactd_open(where.c_str(), &handle_), nullptr);
        require_ok(contactd_set_connect_timeout(handle_, connect_timeout), handle_);
    }
    ~Place() { contactd_close(handle_); }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
    operator contactd_connection*() const { return handle_; }

   private:
    contactd_connection* handle_ = nullptr;
};

class Handle {
   public:
    explicit Handle(contactd_connection* place) { require_ok(contactd_new(place, &handle_), place); }
    ~Handle() { contactd_free(handle_); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    operator contactd_contact*() const { return handle_; }

   private:
    contactd_contact* handle_ = nullptr;
};

/// Lists all arrays of contacts that contactd_want accepts.
inline constexpr std::array every_array{"element_division", "pressure", "traction_x", "traction_y", "slip_x", "slip_y"};

inline constexpr int across = 12, elements = across * across;

/// Describes two bodies of rubber and a sphere, on 12 x 12 elements, the common part of all cases.
inline constexpr std::pair<const char*, double> sphere_fields[] = {
    {"grid.nx", across},       {"grid.ny", across},       {"grid.dx", 0.2},
    {"grid.dy", 0.2},          {"bodies.upper.G", 200},   {"bodies.upper.nu", 0.42},
    {"gap.paraboloid.Rx", 50}, {"gap.paraboloid.Ry", 50}, {"approach", 0.02},
};
inline void set_sphere(contactd_contact* contact) {
    for (const auto& [path, value] : sphere_fields) set(contact, path, value);
}

/// Creates a contact whose steps take some seconds: many transient steps on many elements.
inline void set_long(contactd_contact* contact) {
    set_sphere(contact);
    set(contact, {{"grid.nx", 60}, {"grid.ny", 60}, {"grid.dx", 0.04}, {"grid.dy", 0.04}, {"friction.mu", 0.3}});
    set_word(contact, "friction.rolling.kind", "transient");
    set(contact, {{"friction.rolling.xi", 2e-3}, {"friction.rolling.phi", 1e-3}, {"friction.rolling.steps", 1e5}});
}

struct Read {
    double Fn = 0, Fx = 0, Fy = 0, Mz = 0, approach = 0, pmax = 0;
    bool operator==(const Read&) const = default;
};

inline Read read(contactd_contact* contact) {
    const Numbers forces = get_array(contact, "forces");
    return {forces[0], forces[1], forces[2], forces[3], get(contact, "approach"), get(contact, "pmax")};
}

inline Read stepped(contactd_contact* contact) {
    require_ok(contactd_step(contact), contact);
    return read(contact);
}
