#include "contactd/ic_record.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "contactd/finite.hpp"
#include "contactd/grid.hpp"
#include "contactd/ic_family.hpp"

namespace contactd {
namespace {

IcExtent extent(const IcTable& table) {
    return {table.nx, table.ny};
}

IcExtent extent(const IcFamily& family) {
    return extent(family.tables.front());
}

IcExtent extent(const StripTable& table) {
    return {table.nx, table.strips};
}

/// A spectrum serves as many offsets as any grid has.
IcExtent extent(const StripSpectrum& spectrum) {
    return {static_cast<int>(max_grid_elements) / spectrum.strips, spectrum.strips};
}

std::size_t values_of(const IcTable& table) {
    return table.values.size();
}

std::size_t values_of(const IcFamily& family) {
    std::size_t values = 0;
    for (const IcTable& table : family.tables) values += table.values.size();
    return values;
}

std::size_t values_of(const StripTable& table) {
    return table.values.size();
}

std::size_t values_of(const StripSpectrum& spectrum) {
    return spectrum.values.size();
}

IcTable part_of(const IcTable& table, const IcRecord&, const IcSpec& request, double factor, int, const Observer&) {
    return cropped(table, request.nx, request.ny, factor);
}

IcTable part_of(const IcFamily& family, const IcRecord& record, const IcSpec& request, double factor, int,
                const Observer&) {
    const std::vector<double>& stored = record.evidence.family_nu;
    bool known = stored.size() >= 4 && stored.size() % 2 == 0 && stored.size() == family.tables.size();
    if (known) {
        const std::vector<double> points = family_points(static_cast<int>(stored.size() / 2));
        for (std::size_t j = 0; j < points.size(); ++j) known = known && std::abs(stored[j] - points[j]) < 1e-9;
    }
    if (!known)
        throw StoreError(
            "The stored family contains tables at other Poisson's ratios than this version uses. Remove it from the "
            "store and build it again.");
    return cropped(interpolated(family.tables, request.material.nu), request.nx, request.ny, factor);
}

void require_strips(int strips, const IcSpec& request) {
    if (strips != request.ny)
        throw InvalidArgument("grid.ny", "is " + std::to_string(request.ny) +
                                             "; the table of the longitudinally uniform body has " +
                                             std::to_string(strips) + " strips");
}

StripTable part_of(const StripTable& table, const IcRecord&, const IcSpec& request, double factor, int,
                   const Observer& observer) {
    require_strips(table.strips, request);
    return cropped(table, 0, request.ny, request.nx, factor, observer);
}

StripTable part_of(const StripSpectrum& spectrum, const IcRecord&, const IcSpec& request, double, int threads,
                   const Observer& observer) {
    require_strips(spectrum.strips, request);
    constexpr std::size_t most_values = 50'000'000;  // limit of each of nine components: 3.6 GB in total
    if (static_cast<std::size_t>(request.nx) * static_cast<std::size_t>(request.ny) >
        most_values / static_cast<std::size_t>(request.ny))
        throw InvalidArgument(
            "grid.nx", "is " + std::to_string(request.nx) + ", with ny " + std::to_string(request.ny) +
                           "; nx ny^2 of a longitudinally uniform body must not exceed " + std::to_string(most_values));
    constexpr std::size_t worth_a_thread = 1'000'000;  // coefficients, which take about ten milliseconds
    const std::size_t values = 9 * static_cast<std::size_t>(request.nx) * static_cast<std::size_t>(request.ny) *
                               static_cast<std::size_t>(request.ny);
    threads = static_cast<int>(std::clamp<std::size_t>(values / worth_a_thread, 1, std::max(threads, 1)));
    return strip_table(spectrum, request.dx / request.dy, request.nx, 0, request.dy / request.material.G, threads,
                       observer);
}

}  // namespace

const IcTable& IcRecord::table() const {
    if (const auto* family = std::get_if<IcFamily>(&tables)) return family->tables.front();
    return std::get<IcTable>(tables);
}

IcTable& IcRecord::table() {
    return const_cast<IcTable&>(std::as_const(*this).table());
}

IcExtent extent_of(const IcTables& tables) {
    return std::visit([](const auto& kind) { return extent(kind); }, tables);
}

std::size_t bytes_of(const IcTables& tables) {
    return sizeof(double) * std::visit([](const auto& kind) { return values_of(kind); }, tables);
}

BodyTable body_table(const IcRecord& record, const IcSpec& request, int threads, const Observer& observer) {
    const double factor = request.dx / request.material.G;
    return std::visit(
        [&](const auto& kind) -> BodyTable { return part_of(kind, record, request, factor, threads, observer); },
        record.tables);
}

IcTable table_for(const IcRecord& record, const IcSpec& request, int threads, const Observer& observer) {
    BodyTable found = body_table(record, request, threads, observer);
    // strip_table has checked that they are finite.
    const bool is_known = std::holds_alternative<StripSpectrum>(record.tables);
    if (!is_known && !std::visit([](const auto& table) { return all_finite(table.values); }, found))
        throw NotFinite("Coefficients of the table exceed the range of a double.");
    if (auto* strips = std::get_if<StripTable>(&found)) {
        IcTable table;  // It has the same numbers in the same order; a pair of strips is a row.
        table.nx = strips->nx;
        table.ny = strips->strips * strips->strips;
        table.values = std::move(strips->values);
        return table;
    }
    return std::get<IcTable>(std::move(found));
}

}  // namespace contactd
