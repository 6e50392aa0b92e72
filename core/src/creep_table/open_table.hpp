// Opens a creep-force table at one Poisson's ratio.
#pragma once

#include <optional>
#include <vector>

#include "contactd/creep_table.hpp"
#include "contactd/platform.hpp"
#include "creep_table/evaluate.hpp"
#include "creep_table/file/table_file.hpp"

namespace contactd {

/// Owns what a table reads: the mapped file and, between the Poisson's ratios of the file, the interpolated arrays.
struct CreepTable::Contents {
    Contents(const std::filesystem::path& path, std::optional<double> nu_);
    Contents(const Contents&) = delete;
    Contents& operator=(const Contents&) = delete;

    platform::MappedFile mapped;
    creep_table::CreepFile file;
    double nu;
    std::vector<double> own_curves{};
    std::vector<float> own_coefficients{}, own_box_coefficients{};
    creep_table::CreepSpline spline{};
};

}  // namespace contactd
