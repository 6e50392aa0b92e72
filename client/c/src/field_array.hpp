// Many numbers of a field at once.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contactd/field_path.hpp"

namespace contactd::c {

/// Returns whether it is an array over the grid, of numbers or of the elements' words.
bool is_grid_array(const FieldType& type);

/// Returns whether it is such an array, or one number for all elements, as a coefficient of friction.
bool is_one_or_array(const FieldType& type);

/// The numbers of an object in the order of its fields, of a list entry by entry, or of an array; absent where the path
/// leads to nothing. Throws InvalidArgument with the path for its field where there are no numbers alone.
std::optional<std::vector<double>> numbers_at(const FieldPath& path, const void* root);

/// The reverse: an object gets all its fields, a list as many entries as there are, an array over the grid all values.
/// Throws InvalidArgument, before
/// anything was changed, for another number of values than that, and for values out of bounds.
void set_numbers(const FieldPath& path, void* root, std::span<const double> values);

}  // namespace contactd::c
