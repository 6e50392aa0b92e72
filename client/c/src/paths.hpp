// Finds paths of fields of a contact or a wheel.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>

#include "arguments.hpp"
#include "contactd/error.hpp"
#include "contactd/field_path.hpp"

namespace contactd::c {

/// Lists the structs whose fields may be the first part of a path.
using Roots = std::span<const FieldType* const>;

/// Holds a path below one of the roots.
struct RootedPath {
    const FieldType* root;
    FieldPath path;
};

/// Holds the name of a path in a call: its text, or its number.
using PathName = std::variant<const char*, std::int32_t>;

/// Stores the paths used with one object. Each is parsed once: a call in a loop only looks up its text or its number. A
/// text may be the path of an input, of a result, or of both.
class PathCache {
   public:
    enum Use : std::size_t { input, result };

    PathCache(Roots inputs, Roots results) : roots_{inputs, results} {}

    /// Returns the path. Throws InvalidArgument naming the text for an unknown path, or "id" for an invalid number.
    const RootedPath& find(Use use, const PathName& name) {
        if (const auto* number = std::get_if<std::int32_t>(&name)) return at(use, *number);
        const std::string_view text = given(std::get<const char*>(name), "path");
        const auto at = known_.find(text);
        std::optional<RootedPath>* found = at == known_.end() ? nullptr : &paths_[at->second].of[use];
        if (found != nullptr && *found) return **found;
        RootedPath path = read(use, std::string(text));
        constexpr std::size_t most = 1000;
        if (found == nullptr && paths_.size() >= most) return beyond_.emplace(std::move(path));
        if (found == nullptr) found = &paths_[add(text)].of[use];
        return found->emplace(std::move(path));
    }

    /// Returns the permanent number of the path `text`, for find(). Throws as find.
    std::int32_t number(const char* text) {
        const std::string path = given(text, "path");
        if (const auto at = known_.find(path); at != known_.end()) return static_cast<std::int32_t>(at->second);
        std::array<std::optional<RootedPath>, 2> found;
        std::optional<InvalidArgument> refusal;
        for (const Use use : {input, result}) {
            if (root_of(use, path) == nullptr) continue;
            try {
                found[use] = read(use, path);
            } catch (const InvalidArgument& refused) {
                if (!refusal) refusal = refused;
            }
        }
        if (!found[input] && !found[result]) {
            if (refusal) throw *refusal;
            found[result] = read(result, path);  // lists the known names
        }
        const std::size_t number = add(path);
        paths_[number].of = std::move(found);
        return static_cast<std::int32_t>(number);
    }

   private:
    struct Named {
        std::string text;
        std::array<std::optional<RootedPath>, 2> of;  // by Use
    };
    struct Hash : std::hash<std::string_view> {
        using is_transparent = void;
    };

    const RootedPath& at(Use use, std::int32_t number) {
        if (number < 0 || static_cast<std::size_t>(number) >= paths_.size())
            throw InvalidArgument("id",
                                  "is " + std::to_string(number) + "; use the result of contactd_path for this handle");
        Named& named = paths_[static_cast<std::size_t>(number)];
        if (!named.of[use] && root_of(use, named.text) == nullptr)
            throw InvalidArgument(named.text,
                                  "is an input that cannot be read as a result, or a result that cannot be set");
        if (!named.of[use]) named.of[use] = read(use, named.text);
        return *named.of[use];
    }

    std::size_t add(std::string_view text) {
        known_.emplace(text, paths_.size());
        paths_.push_back({std::string(text), {}});
        return paths_.size() - 1;
    }

    /// Finds the root that contains the first name of the path, or null.
    const FieldType* root_of(Use use, std::string_view path) const {
        const std::string_view first = path.substr(0, path.find_first_of(".["));
        for (const FieldType* root : roots_[use])
            if (std::ranges::find(root->fields, first, &Field::name) != root->fields.end()) return root;
        return nullptr;
    }

    RootedPath read(Use use, const std::string& path) const {
        if (const FieldType* root = root_of(use, path)) return {root, FieldPath(*root, path)};
        std::string known;
        for (const FieldType* root : roots_[use])
            for (const Field& field : root->fields) known += (known.empty() ? "" : ", ") + std::string(field.name);
        throw InvalidArgument(
            path, "is not a field: there is no \"" + path.substr(0, path.find_first_of(".[")) + "\", only " + known);
    }

    std::array<Roots, 2> roots_;  // by Use
    std::unordered_map<std::string, std::size_t, Hash, std::equal_to<>> known_;
    std::deque<Named> paths_;           // by their numbers
    std::optional<RootedPath> beyond_;  // path that was looked up last without being stored
};

}  // namespace contactd::c
