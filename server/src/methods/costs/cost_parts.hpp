// Extracts parts of a request from which costs are computed. The params have been checked against their schema.
#pragma once

#include <nlohmann/json.hpp>

namespace contactd::server {

constexpr double bytes_beside = 1e6;  // for any call
constexpr double seconds_of_offset = 1e-6, seconds_of_layered_offset = 4e-5, seconds_of_creep = 2e-5;

/// Counts the elements of a grid.
double elements_of(const nlohmann::json& grid);
/// Returns a member of an object, or null.
const nlohmann::json* member(const nlohmann::json& params, const char* name);
/// Counts the elastic bodies of a contact that have coefficients of this kind, given for the body or by the request's
/// `ics`.
int count_bodies(const nlohmann::json& params, const char* kind);
/// Returns whether any body of a contact, or its pair, has coefficients of this kind.
bool any_body(const nlohmann::json& params, const char* kind);
/// Returns whether any body of a contact is viscoelastic.
bool any_viscoelastic(const nlohmann::json& params);
/// Returns the length of the first axis of an array, a list or a frame.
double length_of(const nlohmann::json& array);
/// Counts all numbers of an array, a nested list or a frame.
double numbers_of(const nlohmann::json& array);

}  // namespace contactd::server
