#include "contactd/fem/ic_builder.hpp"

#include "build/accurate_build.hpp"
#include "build/adaptive_build.hpp"
#include "build/family_build.hpp"
#include "build/first_process.hpp"
#include "build/mesh_build.hpp"
#include "build/uniform_build.hpp"
#include "contactd/error.hpp"
#include "system/build_size.hpp"

namespace contactd::fem {
namespace {

bool is_corrected_block(const IcSpec& spec) {
    return spec.accuracy > 0 && spec.body == BodyShape::block;
}

bool is_adaptive(const IcSpec& spec) {
    return spec.accuracy == 0 && spec.fem.mesh == MeshKind::adaptive;
}

int process_count() {
    int processes = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &processes);
    return processes;
}

/// One process factorises, refines and solves products along axes as quickly as several.
bool is_built_alone(const IcSpec& spec) {
    return process_count() > 1 && !spec.section &&
           (predicted_size(spec, 1).solver == Solver::direct || is_adaptive(spec) || is_corrected_block(spec));
}

/// Takes a dimensionless spec.
BuildSize size_of(const IcSpec& spec) {
    return predicted_size(spec, is_built_alone(spec) ? 1 : process_count());
}

IcRecord build(MPI_Comm comm, const IcSpec& spec, Observer& first_observer) {
    CollectiveObserver observer(comm, first_observer);
    const ProgressPart progress{&observer};
    const auto build_one = [&](const IcSpec& one, double hardest_nu, const ProgressPart& part) {
        if (one.accuracy > 0) return build_accurate(comm, one, hardest_nu, part);
        return is_adaptive(one) ? build_adaptive(comm, one, part) : build_on_mesh(comm, one, part);
    };
    return spec.any_nu ? build_family(comm, spec, build_one, progress) : build_one(spec, spec.material.nu, progress);
}

}  // namespace

double predicted_memory(const IcSpec& spec) {
    validate(spec);
    return size_of(dimensionless(spec)).bytes;
}

std::string section_mesh(const IcSpec& spec) {
    validate(spec);
    if (!spec.section || spec.source != IcSource::fem)
        throw InvalidArgument(
            "ics.body", "must be longitudinally_uniform, and the source fem: other tables have no mesh of a section");
    return section_triangles(dimensionless(spec), spec.dy);
}

IcRecord build_ic_table(const IcSpec& requested, Observer& observer, std::uint64_t max_memory_bytes) {
    if (requested.source != IcSource::fem)
        throw InvalidArgument("ics.source", "is analytic; builds by finite elements require fem");
    validate(requested);
    const IcSpec spec = dimensionless(requested);
    require_room(spec, size_of(spec), max_memory_bytes);
    if (spec.section) return build_uniform(MPI_COMM_WORLD, spec, observer, max_memory_bytes);
    if (!is_built_alone(spec)) return build(MPI_COMM_WORLD, spec, observer);
    return on_first_process(MPI_COMM_WORLD, [&] { return build(MPI_COMM_SELF, spec, observer); });
}

}  // namespace contactd::fem
