#include "uniform_build.hpp"

#include <sstream>
#include <utility>

#include "contactd/fem/ic_builder.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "contactd/section_warnings.hpp"
#include "geometry/section/section_geometry.hpp"
#include "mesh_build.hpp"
#include "section/section_outline.hpp"
#include "section/spectrum/spectrum_build.hpp"

namespace contactd::fem {
namespace {

std::vector<std::string> warnings_of(const IcSpec& spec, const SectionEvidence& evidence) {
    std::vector<std::string> result = section_warnings(spec.accuracy, evidence);
    if (const auto* rail = std::get_if<RailSection>(&spec.section->shape);
        rail != nullptr && rail->support == RailSupport::foot)
        result.emplace_back(
            "The rail is clamped at its foot. The table includes its bending, which displaces contacts on it.");
    return result;
}

}  // namespace

IcRecord build_uniform(MPI_Comm comm, const IcSpec& spec, Observer& observer, std::uint64_t max_memory_bytes) {
    const double start = MPI_Wtime();
    const geometry::SectionGeometry section(*spec.section, spec.ny, spec.dy, "ics.section");
    const SectionOutline outline = outline_of(section);
    SpectrumBuild build = build_spectrum(comm, outline, spec.material.nu, spec.accuracy, observer, max_memory_bytes);
    IcRecord record;
    record.spec = spec;
    IcEvidence& evidence = record.evidence;
    evidence.source = name_of(IcSource::fem);
    evidence.version = fem_version();
    evidence.elements = build.triangles;
    evidence.dofs = build.unknowns;
    MPI_Comm_size(comm, &evidence.processes);
    evidence.seconds = {build.mesh_seconds, build.setup_seconds, build.solve_seconds, 0};
    evidence.solver = name_of(Solver::direct);
    const SpectrumErrors& errors = build.errors;
    evidence.section = {build.order,        static_cast<int>(build.spectrum.nodes.size()),
                        errors.total(),     errors.mesh,
                        errors.wavenumbers, errors.end,
                        errors.reciprocity};
    evidence.warnings = warnings_of(spec, *evidence.section);
    record.tables = std::move(build.spectrum);
    finish_evidence(evidence, start, comm);
    return record;
}

std::string section_triangles(const IcSpec& spec, double unit) {
    const geometry::SectionGeometry section(*spec.section, spec.ny, spec.dy, "ics.section");
    const SectionOutline outline = outline_of(section);
    const MeshDensity density = density_for(spec.accuracy, spec.material.nu);
    const DividedOutline divided = divide(outline, density);
    const SectionMesh mesh = make_section_mesh(outline, divided, triangulate(divided, density), 1);
    *mesh.mesh->GetNodes() *= unit;
    std::ostringstream text;
    mesh.mesh->PrintVTK(text, 1);
    return text.str();
}

}  // namespace contactd::fem
