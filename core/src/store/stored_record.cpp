#include "contactd/stored_record.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/given_ics.hpp"
#include "contactd/ic_family.hpp"
#include "contactd/strip_frames.hpp"
#include "soundness.hpp"

namespace contactd {
namespace {

[[noreturn]] void refuse(const std::string& why) {
    throw InvalidArgument("datasets", why);
}

/// Converts refusals by contactd::validate to errors of the file.
template <class Check>
void check_as_file(const Check& check) {
    try {
        check();
    } catch (const InvalidArgument& error) {
        refuse(std::string("are not the result of a build: ") + error.what());
    }
}

void require_solvable(IcTable& table, const IcSpec& spec) {
    GivenIcs given{std::move(table), spec.dx, spec.dy};
    check_as_file([&] { validate(given, Grid{spec.nx, spec.ny, spec.dx, spec.dy}, "datasets"); });
    table = std::move(given.table);
}

void require_frames(const StripSpectrum& spectrum, const IcSpec& spec) {
    for (int a = 0; a < 3 * spectrum.strips; ++a)
        for (std::size_t node = 0; node < spectrum.nodes.size(); ++node)
            if (!(spectrum.values[spectrum.index(node, a, a)] > 0))
                refuse("contain a transform that moves a strip against its load, at the wavenumber " +
                       std::to_string(node) + " and the strip " + std::to_string(a / 3));
    std::vector<StripFrame> frames;
    check_as_file([&] { frames = strip_frames(*spec.section, spectrum.strips, spec.dy); });
    constexpr double rounding = 1e-6;  // over the width of a strip, and in rad
    const auto equal = [&](const StripFrame& one, const StripFrame& other) {
        return std::abs(one.y - other.y / spec.dy) < rounding * (1 + std::abs(one.y)) &&
               std::abs(one.z - other.z / spec.dy) < rounding * (1 + std::abs(one.z)) &&
               std::abs(one.angle - other.angle) < rounding;
    };
    if (!std::ranges::equal(spectrum.frames, frames, equal))
        refuse("contain frames of strips that do not match the section");
}

/// Tables must lie at exactly these Poisson's ratios, because interpolation between others is impossible.
void require_points(const std::vector<double>& family_nu) {
    if (family_nu.size() >= 4 && family_nu.size() % 2 == 0) {
        const std::vector<double> points = family_points(static_cast<int>(family_nu.size() / 2));
        const auto near = [](double one, double other) { return std::abs(one - other) < 1e-9; };
        if (std::ranges::equal(family_nu, points, near)) return;
    }
    refuse("contain a family of tables at other Poisson's ratios than this version uses");
}

}  // namespace

IcRecord stored_record(IcRecord record, const Observer& observer) {
    IcSpec& spec = record.spec;
    if (spec.source != IcSource::fem)
        refuse(
            "contain a table of source analytic; stores contain tables by finite elements only, and others are "
            "recomputed");
    check_as_file([&] { validate(spec); });
    if (spec.any_nu && (spec.material.G != 1 || spec.dx != 1))
        refuse("contain a family of tables with dimensions; families are stored for G = 1 and dx = 1 only");
    const double factor = spec.material.G / spec.dx;
    if (auto* spectrum = std::get_if<StripSpectrum>(&record.tables)) {
        require_frames(*spectrum, spec);
        require_sound(*spectrum, record.evidence, spec.section->free, observer);
    } else if (auto* family = std::get_if<IcFamily>(&record.tables)) {
        require_points(record.evidence.family_nu);
        for (std::size_t n = 0; n < family->tables.size(); ++n) {
            IcSpec of_table = spec;
            of_table.any_nu = false;
            of_table.material.nu = record.evidence.family_nu[n];
            require_solvable(family->tables[n], of_table);
            require_sound(family->tables[n], of_table, record.evidence, observer);
        }
    } else {
        require_solvable(record.table(), spec);
        require_sound(record.table(), spec, record.evidence, observer);
        if (factor != 1) record.tables = scaled(record.table(), factor);
    }
    spec = dimensionless(spec);
    return record;
}

}  // namespace contactd
