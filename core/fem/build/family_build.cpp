#include "family_build.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "contactd/error.hpp"
#include "contactd/ic_family.hpp"
#include "modelling_error.hpp"

namespace contactd::fem {
namespace {

/// Lists the points of each half; each set contains the points of the previous one.
constexpr std::array<int, 3> sizes{5, 9, 17};

using Halves = std::array<double, 2>;

/// Returns the error on the given mesh in each half: the largest one under the load or, for a block, whose error is
/// unknown, the usual one of quadratic meshes.
Halves mesh_errors(const std::vector<const IcRecord*>& records) {
    constexpr Halves usual{2e-3, 6e-3};
    Halves largest{};
    for (std::size_t j = 0; j < records.size(); ++j) {
        const IcEvidence& evidence = records[j]->evidence;
        if (!evidence.errors.xx) return usual;
        double& error = largest[j < records.size() / 2 ? 0 : 1];
        for (const auto& one : {evidence.errors.xx, evidence.errors.yy, evidence.errors.zz})
            error = std::max(error, std::abs(one->origin));
    }
    return largest;
}

/// Returns the allowed errors of interpolation in each half.
Halves allowed_errors(const IcSpec& spec, const std::vector<const IcRecord*>& records) {
    constexpr double of_accuracy = 1.0 / 20, of_mesh = 1.0 / 10, least = 1e-5;
    if (spec.accuracy > 0) return {of_accuracy * spec.accuracy, of_accuracy * spec.accuracy};
    Halves result = mesh_errors(records);
    for (double& error : result) error = std::max(of_mesh * error, least);
    return result;
}

void take_larger(std::optional<ComponentError>& error, const std::optional<ComponentError>& other) {
    if (!other) return;
    if (!error) error = other;
    if (std::abs(other->origin) > std::abs(error->origin)) error->origin = other->origin;
    error->largest = std::max(error->largest, other->largest);
}

void take_larger(std::optional<double>& error, const std::optional<double>& other) {
    if (other) error = std::max(error.value_or(0), *other);
}

/// Returns the evidence of the whole family: that of its largest table, with all times added and the largest errors.
IcEvidence combined(const std::vector<const IcRecord*>& records) {
    const auto fewer_dofs = [](const IcRecord* a, const IcRecord* b) { return a->evidence.dofs < b->evidence.dofs; };
    IcEvidence result = (*std::max_element(records.begin(), records.end(), fewer_dofs))->evidence;
    result.seconds = {};
    for (const IcRecord* record : records) {
        const IcEvidence& evidence = record->evidence;
        result.seconds.assembly += evidence.seconds.assembly;
        result.seconds.setup += evidence.seconds.setup;
        result.seconds.solve += evidence.seconds.solve;
        take_larger(result.errors.xx, evidence.errors.xx);
        take_larger(result.errors.yy, evidence.errors.yy);
        take_larger(result.errors.zz, evidence.errors.zz);
        take_larger(result.errors.scaled_xy, evidence.errors.scaled_xy);
        take_larger(result.errors.scaled_xz, evidence.errors.scaled_xz);
        take_larger(result.modelling_error, evidence.modelling_error);
    }
    return result;
}

IcRecord family_of(const IcSpec& spec, const std::vector<const IcRecord*>& records) {
    IcFamily family;
    IcRecord result{spec, {}, combined(records)};
    result.spec.fem = records.back()->spec.fem;
    for (const IcRecord* record : records) {
        family.tables.push_back(record->table());
        result.evidence.family_nu.push_back(record->spec.material.nu);
    }
    if (spec.accuracy == 0)
        result.evidence.warnings = table_warnings(spec, result.evidence);
    else if (result.evidence.modelling_error)
        result.evidence.warnings = modelling_warnings(spec, *result.evidence.modelling_error);
    result.evidence.interpolation_error = interpolation_error(spec, family.tables);
    result.tables = std::move(family);
    return result;
}

}  // namespace

IcRecord build_family(MPI_Comm comm, const IcSpec& spec, const BuildOne& build_one, const ProgressPart& progress) {
    const double start = MPI_Wtime();
    // Both halves end at the break, so that each can have its own mesh for an accuracy.
    std::map<std::pair<double, double>, IcRecord> built;
    double done = 0;
    Halves errors{}, allowed{};
    for (const int size : sizes) {
        const std::vector<double> points = family_points(size);
        // The first size is nearly always sufficient; a later one uses part of the remaining progress.
        const double share = (size == sizes.front() ? 0.9 : (1 - done) / 2) / static_cast<double>(points.size());
        std::vector<const IcRecord*> records;
        for (std::size_t j = 0; j < points.size(); ++j) {
            const double nu = points[j];
            const double hardest_nu = spec.accuracy > 0 && j < points.size() / 2 ? family_break : largest_family_nu;
            const std::pair place{nu, hardest_nu};
            if (!built.contains(place)) {
                IcSpec one = spec;
                one.any_nu = false;
                one.material.nu = nu;
                built.emplace(place, build_one(one, hardest_nu, progress.part(done, share)));
                done += share;
            }
            records.push_back(&built.at(place));
        }
        IcRecord result = family_of(spec, records);
        errors = interpolation_errors(spec, std::get<IcFamily>(result.tables).tables);
        allowed = allowed_errors(spec, records);
        if (errors[0] > allowed[0] || errors[1] > allowed[1]) continue;
        finish_evidence(result.evidence, start, comm);
        progress.report("sampling", 1);
        return result;
    }
    char text[300];
    std::snprintf(text, sizeof text,
                  "The family over nu did not converge: with %d tables, interpolation adds an error of %.3g, but %.3g "
                  "is allowed. Request a coarser accuracy, or a single nu.",
                  2 * sizes.back(), std::ranges::max(errors), std::ranges::max(allowed));
    throw NotConverged(text);
}

}  // namespace contactd::fem
