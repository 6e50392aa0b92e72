// contactd.h: fields of contacts and wheels by their paths.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "contactd/fields/contact.hpp"
#include "contactd/fields/wheel_rail_setup.hpp"
#include "contactd/fields/wheel_rail_solution.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "edge.hpp"

using namespace contactd::c;
using contactd::FieldPath;
using contactd::FieldType;

namespace {

/// These follow from a solution, or from the search for the roll; a result has them beside the solution's fields.
struct WheelTotals {
    bool converged = false;
    std::optional<double> frictional_power{};
    double roll = 0;
    std::optional<contactd::SolverEvidence> roll_search{};
};
struct ContactTotals {
    bool converged = false;
};

const FieldType& type_of_input() {
    static const std::array list{contactd::fields::field<&WheelInput::setup>("setup"),
                                 contactd::fields::field<&WheelInput::state>("state"),
                                 contactd::fields::field<&WheelInput::gap>("gap")};
    static const FieldType type = contactd::fields::object_type(list);
    return type;
}

const FieldType& type_of_wheel_totals() {
    static const std::array list{contactd::fields::field<&WheelTotals::converged>("converged"),
                                 contactd::fields::field<&WheelTotals::frictional_power>("frictional_power"),
                                 contactd::fields::field<&WheelTotals::roll>("roll"),
                                 contactd::fields::field<&WheelTotals::roll_search>("roll_search")};
    static const FieldType type = contactd::fields::object_type(list);
    return type;
}

const FieldType& type_of_contact_totals() {
    static const std::array list{contactd::fields::field<&ContactTotals::converged>("converged")};
    static const FieldType type = contactd::fields::object_type(list);
    return type;
}

bool begins_below(const FieldType& type, std::string_view path) {
    const std::string_view first = path.substr(0, path.find_first_of(".["));
    return std::ranges::find(type.fields, first, &contactd::Field::name) != type.fields.end();
}

/// Calls `read` with the path and the struct of the results that it begins in.
template <class Totals, class Solution, class Read>
void read_result(Called& object, const Solution& solution, const FieldType& type_of_totals, const Totals& totals,
                 const std::string& path, const Read& read) {
    if (begins_below(type_of_totals, path))
        read(object.paths.find(type_of_totals, path), &totals);
    else
        read(object.paths.find(contactd::type_of<Solution>(), path), &solution);
}

void* as_contact(void* handle) {
    return contacts().find_any(handle) ? handle : nullptr;
}

/// Calls `read` with the path and what holds the results of a contact or a wheel.
template <class Read>
std::int32_t read(void* handle, const char* text, const Read& read) {
    const auto path = [&] { return std::string(given(text, "path")); };
    if (as_contact(handle) != nullptr)
        return with(static_cast<contactd_contact*>(handle), [&](Contact& contact) {
            const contactd::ContactSolution& solution = contact.result().reply.solution;
            read_result(contact, solution, type_of_contact_totals(), ContactTotals{solution.converged()}, path(), read);
        });
    return with(static_cast<contactd_wheel*>(handle), [&](Wheel& wheel) {
        const contactd::WheelRailSolution& solution = wheel.solution();
        const WheelTotals totals{wheel.converged(), solution.frictional_power(), wheel.roll(), wheel.roll_search()};
        read_result(wheel, solution, type_of_wheel_totals(), totals, path(), read);
    });
}

/// Calls `change` with the path and the inputs of a wheel. Whatever it refuses leaves them as they were.
template <class Change>
std::int32_t change(void* handle, const char* text, const Change& change) {
    if (as_contact(handle) != nullptr)
        return with(static_cast<contactd_contact*>(handle), [](Contact&) {
            throw contactd::StatusError(contactd::StatusCode::unimplemented, "NO_PATHS",
                                        "Inputs of a contact are set by functions of their own, as "
                                        "contactd_set_material; paths are for its results.");
        });
    return with(static_cast<contactd_wheel*>(handle),
                [&](Wheel& wheel) { change(wheel.paths.find(type_of_input(), given(text, "path")), &wheel.said); });
}

}  // namespace

std::int32_t contactd_set(void* handle, const char* path, double value) {
    return change(handle, path, [&](const FieldPath& field, void* root) { contactd::set_number(field, root, value); });
}

std::int32_t contactd_set_word(void* handle, const char* path, const char* word) {
    return change(handle, path,
                  [&](const FieldPath& field, void* root) { contactd::set_text(field, root, given(word, "word")); });
}

std::int32_t contactd_clear(void* handle, const char* path) {
    return change(handle, path, [&](const FieldPath& field, void* root) { field.clear(root); });
}

std::int32_t contactd_get(void* handle, const char* path, double* value) {
    return read(handle, path, [&](const FieldPath& field, const void* root) {
        given(value, "value");
        const std::optional<double> found = contactd::number_at(field, root);
        if (!found) throw nothing_of(field.text().c_str());
        *value = *found;
    });
}

std::int32_t contactd_get_word(void* handle, const char* path, char* text, std::int32_t length) {
    return read(handle, path, [&](const FieldPath& field, const void* root) {
        const std::optional<std::string> found = contactd::text_at(field, root);
        if (!found) throw nothing_of(field.text().c_str());
        put_text(*found, text, length);
    });
}
