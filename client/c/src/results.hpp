// Finds results of contacts and wheels by their paths.
#pragma once

#include "contact.hpp"
#include "wheel.hpp"

namespace contactd::c {

/// A contact has the fields of its solution and "converged" and, from its start, "step" and "ics".
Roots results_of_contacts();
/// A wheel has the fields of its solution, "converged", "frictional_power", and in a wheelset "roll" and "roll_search".
Roots results_of_wheels();

/// Calls `read` with the path and the struct that contains its field. Throws StatusError (NO_RESULT, WRONG_ORDER) if
/// there is none yet.
using ReadResult = std::function<void(const FieldPath& path, const void* root)>;
void read_result(const Contact& contact, const RootedPath& path, const ReadResult& read);
void read_result(const Wheel& wheel, const RootedPath& path, const ReadResult& read);

}  // namespace contactd::c
