#include "contactd/fem/ic_builder.hpp"

#include "accurate_build.hpp"
#include "adaptive_build.hpp"
#include "contactd/error.hpp"
#include "family_build.hpp"
#include "mesh_build.hpp"

namespace contactd::fem {

IcRecord build_ic_table(const IcSpec& requested, Observer& first_observer) {
    if (requested.source != IcSource::fem)
        throw InvalidArgument("ics.source", "is analytic; only a spec of source fem is built by finite elements");
    validate(requested);
    const IcSpec spec = dimensionless(requested);
    CollectiveObserver observer(MPI_COMM_WORLD, first_observer);
    const ProgressPart progress{&observer};
    const auto build_one = [](const IcSpec& one, const ProgressPart& part) {
        if (one.accuracy > 0) return build_accurate(MPI_COMM_WORLD, one, part);
        return one.fem.mesh == MeshKind::adaptive ? build_adaptive(MPI_COMM_WORLD, one, part)
                                                  : build_on_mesh(MPI_COMM_WORLD, one, part);
    };
    return spec.any_nu ? build_family(MPI_COMM_WORLD, spec, build_one, progress) : build_one(spec, progress);
}

}  // namespace contactd::fem
