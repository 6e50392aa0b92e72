// Contacts of the C interface, for tests: a place to solve them, and handles that are given back.
#pragma once

#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "contactd.h"

/// Fails the test with the sentence of the library unless `code` is CONTACTD_OK.
inline void require_ok(std::int32_t code, const void* handle) {
    INFO(contactd_last_error(handle));
    REQUIRE(code == CONTACTD_OK);
}

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
    Read all;
    require_ok(contactd_get_forces(contact, &all.Fn, &all.Fx, &all.Fy, &all.Mz), contact);
    require_ok(contactd_get_approach(contact, &all.approach), contact);
    require_ok(contactd_get_pmax(contact, &all.pmax), contact);
    return all;
}

inline Read stepped(contactd_contact* contact) {
    require_ok(contactd_step(contact), contact);
    return read(contact);
}

inline std::vector<double> array_of(contactd_contact* contact, const char* path) {
    std::vector<double> values(elements, -1);
    require_ok(contactd_get_array(contact, path, values.data(), elements), contact);
    return values;
}
