// Contacts of the C interface, for tests: a place to solve them, and handles that are given back.
#pragma once

#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cstdint>
#include <string>

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

/// All that contactd_want knows of contacts.
inline constexpr std::array every_array{"element_division", "pressure", "traction_x", "traction_y", "slip_x", "slip_y"};

inline constexpr int across = 12, elements = across * across;

/// Two bodies of rubber and a sphere, on 12 x 12 elements: what all cases have in common.
inline void set_sphere(contactd_contact* contact) {
    require_ok(contactd_set_grid_centred(contact, across, across, 0.2, 0.2), contact);
    require_ok(contactd_set_material(contact, CONTACTD_BOTH, 200, 0.42), contact);
    require_ok(contactd_set_paraboloid(contact, 50, 50), contact);
    require_ok(contactd_set_approach(contact, 0.02), contact);
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
