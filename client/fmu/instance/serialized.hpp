// Writes states as bytes, from which another instance of the same kind can continue, also in another process.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "instance.hpp"

namespace contactd::fmu {

std::vector<std::byte> serialized(const Kind& kind, const State& state);
/// Writes these bytes into the caller's memory. Throws Failure if it is too small.
void put_serialized(const Kind& kind, const State& state, void* bytes, std::size_t size);

/// Throws Failure for bytes that are not a state of this kind, or are damaged.
std::unique_ptr<State> deserialized(const Kind& kind, std::span<const std::byte> bytes);

}  // namespace contactd::fmu
