// Describes the two kinds of FMUs.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "models/model.hpp"

namespace contactd::fmu {

struct Kind {
    std::string_view name;  ///< "contactd_contact": of the model, and of its shared object
    std::string_view says;
    std::span<const Variable> variables;
    std::unique_ptr<Model> (*make)(Tell tell, const std::filesystem::path& resources);
};

std::span<const Kind> kinds();

/// Returns a digest of the list, which must be equal in the model description and the shared object.
std::string token_of(const Kind& kind);

/// Returns the kind with this token, or null.
const Kind* kind_with(std::string_view token);

}  // namespace contactd::fmu
