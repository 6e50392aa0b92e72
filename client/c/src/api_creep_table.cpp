// contactd.h: tables of creep forces.
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>

#include "api_boundary.hpp"
#include "creep_tables.hpp"

using namespace contactd::c;

namespace {

/// Calls `body`, and stores an exception as the failure of the handle.
template <class Body>
std::int32_t with_table(contactd_creep_table* handle, const Body& body) noexcept {
    try {
        body(creep_tables().find(handle));
        return CONTACTD_OK;
    } catch (...) {
        return failed<Contact>(handle, nullptr);
    }
}

/// Names the row of an invalid argument of contactd_creep_table_many.
[[noreturn]] void throw_with_row(const contactd::InvalidArgument& error, std::int32_t row) {
    const std::string at = "[" + std::to_string(row) + "]";
    const bool is_creepage = error.field() == "creepages";
    throw contactd::InvalidArgument(is_creepage ? "creepages" + at : "contacts" + at + "." + error.field(),
                                    error.problem());
}

double* row_of(double* values, std::int32_t row, std::int32_t length) {
    return values == nullptr ? nullptr : values + std::ptrdiff_t{row} * length;
}

}  // namespace

std::int32_t contactd_creep_table_open(const char* path, double nu, contactd_creep_table** table) {
    try {
        *given(table, "table") = nullptr;
        const auto* const text = reinterpret_cast<const char8_t*>(given(path, "path"));
        *table = creep_tables().add(open_creep_table(std::filesystem::path(text), finite(nu, "nu")));
        return CONTACTD_OK;
    } catch (...) {
        return failed<Contact>(nullptr, nullptr);
    }
}

std::int32_t contactd_creep_table_close(contactd_creep_table* table) {
    return with_table(table, [&](const OpenCreepTable&) { creep_tables().remove(table); });
}

std::int32_t contactd_creep_table_info(contactd_creep_table* table, double* nu, double* ratios, char* text,
                                       std::int32_t size) {
    return with_table(table, [&](const OpenCreepTable& opened) {
        *given(nu, "nu") = opened.nu();
        std::ranges::copy(opened.ratios(), given(ratios, "ratios"));
        at_least_zero(size, "size");
        if (size == 0) return;
        const std::string description = opened.description();
        const std::size_t length = std::min(description.size(), static_cast<std::size_t>(size) - 1);
        *std::copy_n(description.begin(), length, given(text, "text")) = '\0';
    });
}

std::int32_t contactd_creep_table_forces(contactd_creep_table* table, double a, double b, double G, double mu,
                                         double Fn, const double* creepages, double* forces, double* jacobian,
                                         double* bounds) {
    return with_table(table, [&](const OpenCreepTable& opened) {
        const double contact[5] = {a, b, G, mu, Fn};
        opened.forces(contact, given(creepages, "creepages"), given(forces, "forces"), jacobian, bounds);
    });
}

std::int32_t contactd_creep_table_many(contactd_creep_table* table, std::int32_t count, const double* contacts,
                                       const double* creepages, double* forces, double* jacobians, double* bounds) {
    return with_table(table, [&](const OpenCreepTable& opened) {
        at_least_zero(count, "count");
        if (count == 0) return;
        given(contacts, "contacts");
        given(creepages, "creepages");
        given(forces, "forces");
        std::int32_t row = 0;
        try {
            for (; row < count; ++row)
                opened.forces(contacts + std::ptrdiff_t{row} * 5, creepages + std::ptrdiff_t{row} * 3,
                              row_of(forces, row, 3), row_of(jacobians, row, 9), row_of(bounds, row, 2));
        } catch (const contactd::InvalidArgument& error) {
            throw_with_row(error, row);
        }
    });
}
