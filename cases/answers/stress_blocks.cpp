#include "stress_blocks.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "contactd/subsurface.hpp"
#include "given/not_covered.hpp"

namespace contactd::cases {
namespace {

[[noreturn]] void refuse_element(int number, int count) {
    throw NotCovered(Subject::input, "A block of subsurface points contains the element number " +
                                         std::to_string(number) + ", but numbers go from 1 to " +
                                         std::to_string(count) + " along this axis.");
}

/// Returns the coordinates along one axis. `centre(i)` is the centre of element i of `count`.
template <class Centre>
std::vector<double> coordinates(int kind, const std::vector<double>& given, int count, const Centre& centre) {
    if (kind == 9) return given;
    std::vector<int> numbers;
    if (all_centres(kind))
        for (int i = 1; i <= count; ++i) numbers.push_back(i);
    else if (range_of_elements(kind)) {
        const int first = static_cast<int>(given[0]), step = static_cast<int>(given[1]);
        const int last = static_cast<int>(given[2]);
        if (last > count) refuse_element(last, count);
        if (step < 1)
            throw NotCovered(Subject::input, "A block of subsurface points has the step " + std::to_string(step) +
                                                 " between elements. Use at least 1.");
        for (int i = first; i <= last; i += step) numbers.push_back(i);
    } else
        for (const double i : given) numbers.push_back(static_cast<int>(i));
    std::vector<double> result;
    for (const int i : numbers) {
        if (i < 1 || i > count) refuse_element(i, count);
        result.push_back(centre(i - 1));
    }
    return result;
}

constexpr std::array components{&SubsurfaceStress::xx,       &SubsurfaceStress::yy, &SubsurfaceStress::zz,
                                &SubsurfaceStress::xy,       &SubsurfaceStress::xz, &SubsurfaceStress::yz,
                                &SubsurfaceStress::von_mises};

/// Adds the layers of points in one body. The frame of the upper body is mirrored, which changes the signs of xz, yz
/// and of displacements along z.
void add_body(ContactBody body, const Solved& solved, SolvedBlock& block, Observer& observer) {
    const bool upper = body == ContactBody::upper;
    std::vector<std::size_t> layers;
    StressBlock inside{block.points.x, block.points.y, {}};
    for (std::size_t k = 0; k < block.points.z.size(); ++k) {
        const double z = block.points.z[k];
        if ((z >= 0) != upper) continue;
        layers.push_back(k);
        inside.z.push_back(upper ? 0 - z : z);
    }
    if (layers.empty()) return;
    const ContactSolution& solution = solved.solution;
    const MaterialPair bodies = solved.problem.bodies.materials();
    const Material& material = upper ? bodies.upper : bodies.lower;
    const SurfaceTractions tractions = tractions_on(body, solution.pressure, solution.traction_x, solution.traction_y);
    const SubsurfaceStress stress = subsurface_stress(solved.problem.grid, tractions, material.nu, inside, observer);
    const SubsurfaceDisplacement moved =
        subsurface_displacement(solved.problem.grid, tractions, material, inside, observer);
    const std::size_t layer = inside.x.size() * inside.y.size();
    const auto place = [&](const std::vector<double>& found, bool changes_sign, std::vector<double>& all) {
        for (std::size_t k = 0; k < layers.size(); ++k)
            for (std::size_t i = 0; i < layer; ++i) {
                const double value = found[k * layer + i];
                all[layers[k] * layer + i] = changes_sign ? 0 - value : value;
            }
    };
    for (const auto component : components) {
        const bool changes_sign = upper && (component == &SubsurfaceStress::xz || component == &SubsurfaceStress::yz);
        place(stress.*component, changes_sign, block.stress.*component);
    }
    place(moved.x, false, block.displacement.x);
    place(moved.y, false, block.displacement.y);
    place(moved.z, upper, block.displacement.z);
}

double coordinate(const StressBlock& points, int axis, std::size_t i) {
    const std::size_t nx = points.x.size(), ny = points.y.size();
    if (axis == 0) return points.x[i % nx];
    return axis == 1 ? points.y[i / nx % ny] : points.z[i / (nx * ny)];
}

double stress_of(const SubsurfaceStress& s, int column, std::size_t i) {
    switch (column) {
        case 7:
            return s.hydrostatic[i];
        case 8:
            return s.von_mises[i];
        case 9:
            return s.tresca[i];
        case 10:
            return s.principal_1[i];
        case 11:
            return s.principal_2[i];
        case 12:
            return s.principal_3[i];
        case 13:
            return s.xx[i];
        case 14:
        case 16:
            return s.xy[i];
        case 15:
        case 19:
            return s.xz[i];
        case 17:
            return s.yy[i];
        case 18:
        case 20:
            return s.yz[i];
        default:
            return s.zz[i];
    }
}

}  // namespace

std::vector<GivenBlock> blocks_of(const ContactCase& read) {
    std::vector<GivenBlock> blocks;
    if (!read.subsurface) return blocks;
    for (const auto& block : *read.subsurface) {
        const auto axis = [&](const char* name) {
            const auto found = block.find(name);
            return found == block.end() ? std::vector<double>() : *std::get<ContactNumbers>(found->second);
        };
        if (block.contains("X"))
            blocks.push_back({9, axis("X"), axis("Y"), axis("Z")});
        else
            blocks.push_back({block.contains("IX") ? 7 : 5, axis("IX"), axis("IY"), axis("Z")});
    }
    return blocks;
}

StressBlock block_points(const GivenBlock& block, const Grid& grid) {
    return {coordinates(block.kind, block.x, grid.nx, [&](int i) { return grid.x(i); }),
            coordinates(block.kind, block.y, grid.ny, [&](int i) { return grid.y(i); }), block.z};
}

SolvedBlock solve_block(const GivenBlock& block, const Solved& solved, Observer& observer) {
    SolvedBlock result{block, block_points(block, solved.problem.grid), {}, {}};
    constexpr std::size_t most = 10'000'000;
    if (result.points.size() > most)
        throw NotCovered(Subject::input, "A block of subsurface points has " + std::to_string(result.points.size()) +
                                             " points; at most " + std::to_string(most) + " are supported.");
    for (const auto component : components) (result.stress.*component).resize(result.points.size());
    for (auto* values : {&result.displacement.x, &result.displacement.y, &result.displacement.z})
        values->resize(result.points.size());
    for (const ContactBody body : {ContactBody::upper, ContactBody::lower}) add_body(body, solved, result, observer);
    find_invariants(result.stress);
    return result;
}

std::vector<double> block_column(const SolvedBlock& block, int column, const Units& units) {
    if (column < 1 || column > 21)
        throw NotCovered(Subject::input, "Column " + std::to_string(column) + " does not exist; columns are 1 to 21.");
    const auto value = [&](std::size_t i) {
        switch (column) {
            case 1:
            case 2:
            case 3:
                return coordinate(block.points, column - 1, i) / units.length;
            case 4:
                return block.displacement.x[i] / units.length;
            case 5:
                return block.displacement.y[i] / units.length;
            case 6:
                return block.displacement.z[i] / units.length;
            default:
                return stress_of(block.stress, column, i) / units.stress();
        }
    };
    std::vector<double> result(block.points.size());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = value(i);
    return result;
}

}  // namespace contactd::cases
