#include "contactd/stored_record.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "contactd/column_frames.hpp"
#include "contactd/error.hpp"
#include "contactd/given_ics.hpp"

namespace contactd {
namespace {

[[noreturn]] void refuse(const std::string& why) {
    throw InvalidArgument("file", why);
}

/// What of the file contactd::validate refuses is wrong with the file.
template <class Check>
void check_as_file(const Check& check) {
    try {
        check();
    } catch (const InvalidArgument& error) {
        refuse(std::string("holds what no builder makes: ") + error.what());
    }
}

void require_sound(IcTable& table, const IcSpec& spec) {
    const GivenIcs given{std::move(table), spec.dx, spec.dy};
    check_as_file([&] { validate(given, Grid{spec.nx, spec.ny, spec.dx, spec.dy}, "file"); });
    table = given.table;
}

void require_sound(const ColumnSpectrum& spectrum, const IcSpec& spec) {
    for (int a = 0; a < 3 * spectrum.columns; ++a)
        for (std::size_t node = 0; node < spectrum.nodes.size(); ++node)
            if (!(spectrum.values[spectrum.index(node, a, a)] > 0))
                refuse("holds a transform under which a column yields against its load, at the wavenumber " +
                       std::to_string(node) + " and the column " + std::to_string(a / 3));
    std::vector<ColumnFrame> frames;
    check_as_file([&] { frames = column_frames(*spec.section, spectrum.columns, spec.dy); });
    constexpr double rounding = 1e-6;  // over the width of a column, and in rad
    const auto equal = [&](const ColumnFrame& one, const ColumnFrame& other) {
        return std::abs(one.y - other.y / spec.dy) < rounding * (1 + std::abs(one.y)) &&
               std::abs(one.z - other.z / spec.dy) < rounding * (1 + std::abs(one.z)) &&
               std::abs(one.angle - other.angle) < rounding;
    };
    if (!std::ranges::equal(spectrum.frames, frames, equal))
        refuse("holds frames of columns that are not those of its section");
}

}  // namespace

IcRecord stored_record(IcRecord record) {
    IcSpec& spec = record.spec;
    if (spec.source != IcSource::fem)
        refuse("holds a table of source analytic; stores keep those of finite elements, the others are made anew");
    check_as_file([&] { validate(spec); });
    const double factor = spec.material.G / spec.dx;
    if (auto* spectrum = std::get_if<ColumnSpectrum>(&record.tables)) {
        require_sound(*spectrum, spec);
    } else {
        auto* family = std::get_if<IcFamily>(&record.tables);
        std::vector<IcTable> one;
        if (family == nullptr) one.push_back(std::move(record.table()));
        for (IcTable& table : family != nullptr ? family->tables : one) {
            require_sound(table, spec);
            if (factor != 1) table = scaled(table, factor);
        }
        if (family == nullptr) record.tables = std::move(one.front());
    }
    spec = dimensionless(spec);
    return record;
}

}  // namespace contactd
