// The paths by which fields of a contact or a wheel were named.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>

#include "contactd/field_path.hpp"

namespace contactd::c {

/// The paths that were used with one object, each of which is read once: a call in a loop looks its text up.
class PathCache {
   public:
    /// Throws InvalidArgument naming `text` where no field has that path.
    const FieldPath& find(const FieldType& root, const std::string& text) {
        constexpr std::size_t most = 1000;
        auto& known = known_[&root];
        if (const auto at = known.find(text); at != known.end()) return at->second;
        if (known.size() >= most) known.clear();
        return known.try_emplace(text, root, text).first->second;
    }

   private:
    std::unordered_map<const FieldType*, std::unordered_map<std::string, FieldPath>> known_;
};

}  // namespace contactd::c
