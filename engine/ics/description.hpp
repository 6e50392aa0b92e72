// Describes a table for human readers.
#pragma once

#include <string>

#include "contactd/ic_spec.hpp"

namespace contactd::engine {

/// Returns a text such as "finite elements, a block of nu 0.28: 25 x 25 offsets of 0.8 x 0.8 mm, accuracy 0.001", for
/// job.list. Unlike keys, descriptions do not identify tables.
std::string description(const IcSpec& spec);

}  // namespace contactd::engine
