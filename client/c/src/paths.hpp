// The paths by which fields of a contact or a wheel are named.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>

#include "contactd/error.hpp"
#include "contactd/field_path.hpp"

namespace contactd::c {

/// Where a path may begin: the structs whose fields are named at first.
using Roots = std::span<const FieldType* const>;

/// A path below one of the roots.
struct RootedPath {
    const FieldType* root;
    FieldPath path;
};

/// How a call names a path: by its text, or by its number.
using PathName = std::variant<const char*, std::int32_t>;

/// The paths that were used with one object, each of which is read once: a call in a loop looks its text up, or only
/// its number.
class PathCache {
   public:
    /// Throws InvalidArgument naming `text` where no field has that path.
    const RootedPath& find(Roots roots, const std::string& text) {
        constexpr std::size_t most = 1000;
        if (const auto at = known_[roots.front()].find(text); at != known_[roots.front()].end())
            return paths_[at->second];
        if (paths_.size() < most) return paths_[number(roots, text)];
        return beyond_.emplace(RootedPath{&root_of(roots, text), FieldPath(root_of(roots, text), text)});
    }

    /// The number of the path `text`, for at(); it stays. Throws as find.
    std::int32_t number(Roots roots, const std::string& text) {
        auto& known = known_[roots.front()];
        if (const auto at = known.find(text); at != known.end()) return at->second;
        const FieldType& root = root_of(roots, text);
        paths_.push_back({&root, FieldPath(root, text)});
        return known.emplace(text, static_cast<std::int32_t>(paths_.size() - 1)).first->second;
    }

    /// Throws InvalidArgument for a number that is none, or that of a path which begins elsewhere.
    const RootedPath& at(Roots roots, std::int32_t number) const {
        if (number < 0 || static_cast<std::size_t>(number) >= paths_.size())
            throw InvalidArgument("id", "is " + std::to_string(number) + "; contactd_path of this handle tells one");
        const RootedPath& found = paths_[static_cast<std::size_t>(number)];
        if (std::ranges::find(roots, found.root) == roots.end())
            throw InvalidArgument(found.path.text(), "is an input where a result is read, or a result that is set");
        return found;
    }

    /// Returns whether a field of the root has the first name of the path.
    static bool begins_below(const FieldType& root, std::string_view path) {
        const std::string_view first = path.substr(0, path.find_first_of(".["));
        return std::ranges::find(root.fields, first, &Field::name) != root.fields.end();
    }

   private:
    /// The last one where the path begins at none: it then says what it has.
    static const FieldType& root_of(Roots roots, std::string_view path) {
        const auto at = std::ranges::find_if(roots, [&](const FieldType* root) { return begins_below(*root, path); });
        return at == roots.end() ? *roots.back() : **at;
    }

    std::unordered_map<const FieldType*, std::unordered_map<std::string, std::int32_t>> known_;  // by the first root
    std::deque<RootedPath> paths_;                                                               // by their numbers
    std::optional<RootedPath> beyond_;  // the last one that was not kept
};

}  // namespace contactd::c
