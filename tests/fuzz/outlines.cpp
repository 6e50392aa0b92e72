// Fuzzes sections of ic.get, up to the mesh that gmsh fills their outline with: a section is refused with a message, or
// meshed completely. Sections are small, so that an input takes milliseconds; meshes are as fine as those of builders.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <variant>

#include <nlohmann/json.hpp>

#include "contactd/error.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/proto/import_codec.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/proto/status.hpp"
#include "geometry/section/section_geometry.hpp"
#include "input.hpp"
#include "section/section_mesh.hpp"
#include "section/section_outline.hpp"
#include "section/spectrum/spectrum_level.hpp"

using namespace contactd;
using namespace contactd::fem;

namespace {

constexpr int most_strips = 12;
constexpr std::size_t most_pieces = 16, most_points = 100, most_edges = 400;

std::size_t points_of(const Outline& outline) {
    std::size_t points = 0;
    for (const OutlinePart& part : outline.parts) {
        const auto* spline = std::get_if<SplineTo>(&part.curve);
        points += spline != nullptr ? spline->through.size() : 1;
    }
    return points;
}

bool is_large(const IcSpec& spec) {
    if (spec.ny > most_strips) return true;
    if (const auto* profile = std::get_if<ProfileSection>(&spec.section->shape)) {
        const auto* points = std::get_if<ProfilePoints>(&profile->profile.shape);
        return points != nullptr && points->points.size() > most_points;
    }
    const auto* section = std::get_if<OutlineSection>(&spec.section->shape);
    if (section == nullptr) return false;
    std::size_t points = points_of(section->outside);
    for (const Outline& hole : section->holes) points += points_of(hole);
    return points > most_points;
}

bool is_on_wire(std::string_view field) {
    return field.starts_with("ics") || field.starts_with("grid") || field.starts_with("material");
}

double signed_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    return ((b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y)) / 2;
}

/// The triangles are as large as what the outline encloses, none of them inverted: they cover it once.
void check_cover(const DividedOutline& outline, const Triangulation& filled) {
    const PlanePoint origin = outline.vertices.front();
    double enclosed = 0, covered = 0;
    for (const BoundaryEdge& edge : outline.edges)
        enclosed -= signed_area(origin, outline.vertices[edge.first], outline.vertices[edge.second]);
    for (const auto& [a, b, c] : filled.triangles) {
        const double area = signed_area(filled.vertices[a], filled.vertices[b], filled.vertices[c]);
        fuzz::require(area > 0, "triangles are not inverted");
        covered += area;
    }
    const double rounding = 1e-9 * outline.extent * outline.extent;
    fuzz::require(std::abs(covered - enclosed) <= rounding, "triangles cover the section");
}

void mesh(const IcSpec& spec) {
    const geometry::SectionGeometry section(*spec.section, spec.ny, spec.dy, "ics.section");
    const SectionOutline outline = outline_of(section);
    std::size_t pieces = 0;
    for (const OutlineLoop& loop : outline.loops) pieces += loop.size();
    if (pieces > most_pieces) return;
    const double accuracy = spec.accuracy > 0 ? spec.accuracy : coarsest_accuracy;
    const MeshDensity density = density_for(accuracy, spec.material.nu);
    const DividedOutline divided = divide(outline, density);
    if (divided.edges.size() > most_edges) return;
    const Triangulation filled = triangulate(divided, density);
    const SectionMesh made = make_section_mesh(outline, divided, filled, first_level(accuracy, spec.material.nu).order);
    fuzz::require(static_cast<std::size_t>(made.mesh->GetNE()) == filled.triangles.size(), "triangles are elements");
    check_cover(divided, filled);
}

}  // namespace

/// gmsh throws if it abandons a mesh, and does not free its memory; a builder ends then.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libgmsh.so\n";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::Input input = fuzz::split(fuzz::bytes_of(data, size));
    const auto params = nlohmann::json::parse(input.text, nullptr, false);
    if (params.is_discarded() || !proto::violations_of("ic.get.params", params).empty()) return 0;
    try {
        const IcSpec spec = proto::decode_ic_spec(params, proto::Frames(input.frames.begin(), input.frames.end()));
        validate(spec);
        if (spec.section && !is_large(spec)) mesh(dimensionless(spec));
    } catch (const proto::StatusError& error) {
        fuzz::require(error.status().message.size() < 2000, "a refusal is no longer than it must be");
    } catch (const InvalidArgument& error) {
        fuzz::require(is_on_wire(error.field()), "a refusal names a field of the request");
        fuzz::require(std::string_view(error.what()).size() < 2000, "a refusal is no longer than it must be");
        for (const char c : std::string_view(error.what()))
            fuzz::require(c >= ' ' && c <= '~', "refusals can be printed");
    }
    return 0;
}
