// Gives access to all numbers of a field at once.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contactd/field_path.hpp"

namespace contactd::c {

/// Returns whether it is an array over the grid, of numbers or of element states.
bool is_grid_array(const FieldType& type);

/// Returns whether it is such an array, or one number for all elements, like a coefficient of friction.
bool is_one_or_array(const FieldType& type);

/// Returns the numbers of an object in the order of its fields, of a list entry by entry, or of an array; absent if the
/// path has no value. Throws InvalidArgument naming the path if it has other values than numbers.
std::optional<std::vector<double>> numbers_at(const FieldPath& path, const void* root);

/// Does the inverse: sets all fields of an object, all entries of a list, or all values of an array over the grid.
/// Throws InvalidArgument, before any change, for a wrong number of values, and for values out of bounds.
void set_numbers(const FieldPath& path, void* root, std::span<const double> values);

}  // namespace contactd::c
