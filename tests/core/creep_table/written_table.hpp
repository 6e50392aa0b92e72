// Writes a file of a table of blended forces.
#pragma once

#include <filesystem>
#include <vector>

#include "creep_table/blended_forces.hpp"
#include "creep_table/file/table_file.hpp"
#include "support/temporary_folder.hpp"

namespace contactd::creep_table {

/// Holds a table for two Poisson's ratios, with a box and bounds, in which the second half of each array is twice the
/// first.
struct TwoRatios {
    std::vector<double> curves = blended_table().curves;
    std::vector<float> coefficients = blended_table().coefficients, box_coefficients, bounds{0.001f, 0.002f};
    CreepFile file{};

    TwoRatios() {
        file.grid = blended_table().grid;
        file.nu = {0.28, 0.4};
        file.curve_cells = blended_table().curve_axis.cells;
        file.box = TableAxes{{{0, 1, 4}, {1, 2, 4}, {1.2, 1.5, 4}, {0.8, 1.2, 4}}};
        file.bound_cells = {1, 1, 1, 1};
        file.description = "{\"recipe\": \"blended\"}";
        box_coefficients.assign(spline_size(*file.box), 0.01f);
        const auto second = creep_curves(file.curve_axis(), 0.4);
        curves.insert(curves.end(), second.begin(), second.end());
        for (std::vector<float>* const array : {&coefficients, &box_coefficients}) {
            const std::size_t half = array->size();
            for (std::size_t k = 0; k < half; ++k) array->push_back(2 * (*array)[k]);
        }
        file.curves = curves;
        file.coefficients = coefficients;
        file.box_coefficients = box_coefficients;
        file.bounds = bounds;
    }
};

inline const TwoRatios& two_ratios() {
    static const TwoRatios table;
    return table;
}

struct Written {
    TemporaryFolder folder;
    std::filesystem::path path = folder.path() / "table.creep";

    Written() { write_creep_file(path, two_ratios().file); }
};

}  // namespace contactd::creep_table
