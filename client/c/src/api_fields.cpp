// Implements contactd.h: fields of contacts and wheels by their paths.
#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "api_boundary.hpp"
#include "contactd/fields/contact.hpp"
#include "contactd/fields/wheel_rail_setup.hpp"
#include "contactd/read_profile.hpp"
#include "field_array.hpp"
#include "results.hpp"

using namespace contactd::c;
using contactd::FieldPath;
using contactd::FieldType;
using contactd::InvalidArgument;
using contactd::ProfileFile;
using contactd::ProfileKind;
using contactd::ProfileSpec;
using contactd::SolutionField;

namespace {

// --- arrays over the grid --------------------------------------------------------------------------------------------

/// In the order of SolutionField, followed by the array of wheels only.
constexpr auto arrays = [] {
    std::array<std::string_view, contactd::enum_words<SolutionField>.size() + 1> all{};
    std::ranges::copy(contactd::enum_words<SolutionField>, all.begin());
    all.back() = "gap";
    return all;
}();
constexpr std::size_t gap = arrays.size() - 1;

std::size_t array_named(std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(arrays, name) - arrays.begin());
}

/// Returns the number of values in the array at the path. Without friction, slip is empty and represents zeros.
std::size_t elements_of(Contact& contact, const FieldPath&, const void*) {
    return contact.inputs.problem.grid.size();
}
std::size_t elements_of(Wheel& wheel, const FieldPath& path, const void* root) {
    const std::string grid = path.text().substr(0, path.text().find('.')) + ".place.grid.n";
    const auto along = [&](const char* axis) {
        return number_at(wheel.paths.find(PathCache::result, (grid + axis).c_str()).path, root).value_or(0);
    };
    return static_cast<std::size_t>(along("x") * along("y"));
}

void require_gap(const Contact&) {}
void require_gap(const Wheel& wheel) {
    wheel.require_gap();
}

/// Returns the numbers at the path. Throws StatusError (NO_RESULT) if there are none, or the array was not
/// requested.
template <class Object>
std::vector<double> read_numbers(Object& object, const FieldPath& path, const void* root) {
    std::optional<std::vector<double>> numbers = numbers_at(path, root);
    if (!numbers) throw nothing_of(path.text().c_str());
    if (!is_grid_array(path.type())) return *numbers;
    const std::size_t array = array_named(path.field().name);
    if (array == gap)
        require_gap(object);
    else
        object.require(static_cast<SolutionField>(array));
    if (!numbers->empty()) return *numbers;
    if (array == gap) throw nothing_of("undeformed distances: a simplified model solved it");
    if (static_cast<SolutionField>(array) == SolutionField::pressure_by_approach)
        throw nothing_of("derivative of its pressures");
    return std::vector<double>(elements_of(object, path, root));
}

// --- reading and changing --------------------------------------------------------------------------------------------

/// Calls `read` with the object, the path, and the struct with its result.
template <class Read>
std::int32_t read(void* handle, const PathName& name, const Read& read) {
    return with_any(handle, [&](auto& object) {
        const RootedPath& found = object.paths.find(PathCache::result, name);
        read_result(object, found, [&](const FieldPath& path, const void* root) { read(object, path, root); });
    });
}

enum class Change { set, clear };

template <class Apply>
void change_input(Wheel& wheel, const PathName& name, Change, const Apply& apply) {
    apply(wheel.paths.find(PathCache::input, name).path, &wheel.inputs);
}
template <class Apply>
void change_input(Contact& contact, const PathName& name, Change change, const Apply& apply) {
    const RootedPath& found = contact.paths.find(PathCache::input, name);
    const FieldPath& path = found.path;
    if (!is_load(path)) contact.require_set_up(path.text().c_str());
    if (change == Change::set) contact.inputs.require_motion_of(path);
    if (change == Change::clear && contact.started()) ContactInputs::require_clearable_between_steps(path);
    apply(path, contact.inputs.at(found));
    change == Change::set ? contact.inputs.was_set(path) : contact.inputs.was_cleared(path);
}

/// Calls `apply` with the path and the struct with its input. A refusal leaves the inputs unchanged.
template <class Apply>
std::int32_t change(void* handle, const PathName& name, Change change, const Apply& apply) {
    return with_any(handle, [&](auto& object) { change_input(object, name, change, apply); });
}

std::int32_t set(void* handle, const PathName& name, double value) {
    return change(handle, name, Change::set, [&](const FieldPath& field, void* root) {
        if (is_one_or_array(field.type())) return set_numbers(field, root, std::array{value});
        if (&field.type() != &contactd::type_of<std::vector<contactd::FrictionAtAngle>>())
            return contactd::set_number(field, root, value);
        // One coefficient applies to every angle; errors name the whole field, as on the wire.
        const contactd::Field& mu = contactd::type_of<contactd::FrictionAtAngle>().fields.back();
        check_number(mu, value, field.text());
        set_numbers(field, root, std::array{0.0, value});
    });
}

std::int32_t get(void* handle, const PathName& name, double* value) {
    return read(handle, name, [&](auto&, const FieldPath& field, const void* root) {
        given(value, "value");
        const std::optional<double> found = contactd::number_at(field, root);
        if (!found) throw nothing_of(field.text().c_str());
        *value = *found;
    });
}

void set_profile(const FieldPath& path, void* root, const char* file) {
    const std::filesystem::path place(given(file, "file"));
    if (&path.type() == &contactd::type_of<ProfileFile>()) {
        std::string text = contactd::text_of_profile(place);
        auto& content = *static_cast<ProfileFile*>(path.make(root));
        content.name = place.filename().string();
        content.text = std::move(text);
        return;
    }
    if (&path.type() != &contactd::type_of<ProfileSpec>())
        throw InvalidArgument(path.text(),
                              "is not a profile; use setup.wheel, setup.rail, profile of a slice, or file below one of "
                              "them, and for a contact profile of a profile_section");
    const auto* before = static_cast<const ProfileSpec*>(path.find(root));
    const ProfileKind of_path = path.text().starts_with("setup.rail") ? ProfileKind::rail : ProfileKind::wheel;
    const ProfileKind kind = before != nullptr ? before->kind : of_path;
    ProfileSpec read = contactd::read_profile(place, kind);
    *static_cast<ProfileSpec*>(path.make(root)) = std::move(read);
}

void put_text(const std::string& source, char* text, std::int32_t length) {
    given(text, "text");
    if (length < 1) throw InvalidArgument("length", "is " + std::to_string(length) + "; it must be at least 1");
    const std::size_t kept = std::min(source.size(), static_cast<std::size_t>(length) - 1);
    std::memcpy(text, source.data(), kept);
    text[kept] = '\0';
}

void request_array(contactd::SolutionFields& fields, std::size_t array, bool requested) {
    const auto field = static_cast<SolutionField>(array);
    std::erase(fields, field);
    if (requested) fields.push_back(field);
}
void request_array(Contact& contact, std::size_t array, bool requested) {
    request_array(contact.inputs.fields, array, requested);
}
void request_array(Wheel& wheel, std::size_t array, bool requested) {
    if (array == gap)
        wheel.inputs.gap = requested;
    else
        request_array(wheel.inputs.fields, array, requested);
}

constexpr std::size_t arrays_of(const Contact&) {
    return gap;
}
constexpr std::size_t arrays_of(const Wheel&) {
    return arrays.size();
}

/// Returns one of the first `count` arrays.
std::size_t requested_array(const char* name, std::size_t count) {
    const std::size_t array = array_named(given(name, "array"));
    if (array < count) return array;
    std::string known;
    for (std::size_t k = 0; k < count; ++k) known += (k == 0 ? "" : ", ") + std::string(arrays[k]);
    throw InvalidArgument("array", "is \"" + std::string(name) + "\"; it must be one of " + known);
}

}  // namespace

std::int32_t contactd_set(void* handle, const char* path, double value) {
    return set(handle, path, value);
}

std::int32_t contactd_set_word(void* handle, const char* path, const char* keyword) {
    return change(handle, path, Change::set, [&](const FieldPath& field, void* root) {
        contactd::set_text(field, root, given(keyword, "keyword"));
    });
}

std::int32_t contactd_set_array(void* handle, const char* path, const double* values, std::int32_t count) {
    return change(handle, path, Change::set, [&](const FieldPath& field, void* root) {
        set_numbers(field, root, array(values, count, "values"));
    });
}

std::int32_t contactd_clear(void* handle, const char* path) {
    return change(handle, path, Change::clear, [&](const FieldPath& field, void* root) { field.clear(root); });
}

std::int32_t contactd_get(void* handle, const char* path, double* value) {
    return get(handle, path, value);
}

std::int32_t contactd_get_word(void* handle, const char* path, char* text, std::int32_t length) {
    return read(handle, path, [&](auto&, const FieldPath& field, const void* root) {
        const std::optional<std::string> found = contactd::text_at(field, root);
        if (!found) throw nothing_of(field.text().c_str());
        put_text(*found, text, length);
    });
}

std::int32_t contactd_get_array(void* handle, const char* path, double* values, std::int32_t count) {
    return read(handle, path, [&](auto& object, const FieldPath& field, const void* root) {
        const std::vector<double> found = read_numbers(object, field, root);
        if (count < 0 || static_cast<std::size_t>(count) != found.size())
            throw InvalidArgument("count", "is " + std::to_string(count) + "; " + field.text() + " has " +
                                               std::to_string(found.size()) + " numbers");
        if (!found.empty()) std::ranges::copy(found, given(values, "values"));
    });
}

std::int32_t contactd_length(void* handle, const char* path, std::int32_t* count) {
    return read(handle, path, [&](auto& object, const FieldPath& field, const void* root) {
        *given(count, "count") = static_cast<std::int32_t>(read_numbers(object, field, root).size());
    });
}

std::int32_t contactd_path(void* handle, const char* path, std::int32_t* id) {
    return with_any(handle, [&](auto& object) { *given(id, "id") = object.paths.number(path); });
}

std::int32_t contactd_set_at(void* handle, std::int32_t id, double value) {
    return set(handle, id, value);
}

std::int32_t contactd_get_at(void* handle, std::int32_t id, double* value) {
    return get(handle, id, value);
}

std::int32_t contactd_want(void* handle, const char* array, std::int32_t requested) {
    return with_any(handle, [&](auto& object) {
        const std::size_t named = requested_array(array, arrays_of(object));
        request_array(object, named, flag(requested, "requested"));
    });
}

std::int32_t contactd_read_profile(void* handle, const char* path, const char* file) {
    return change(handle, path, Change::set,
                  [&](const FieldPath& field, void* root) { set_profile(field, root, file); });
}
