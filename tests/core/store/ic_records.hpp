// Creates records for the tests of keys, files and the store.
#pragma once

#include <filesystem>
#include <string>

#include "contactd/ic_store.hpp"
#include "support/temporary_folder.hpp"

namespace contactd {

namespace fs = std::filesystem;

inline IcSpec fem_spec(int nx, int ny) {
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.8;
    spec.nx = nx;
    spec.ny = ny;
    spec.source = IcSource::fem;
    return spec;
}

inline IcRecord record_of(const IcSpec& spec) {
    IcRecord record{dimensionless(spec), IcTable(spec.nx, spec.ny), {}};
    for (std::size_t n = 0; n < record.table().values.size(); ++n) record.table().values[n] = 1.0 / (1.0 + double(n));
    record.evidence.source = "fem";
    record.evidence.version = "test";
    record.evidence.elements = 1840;
    record.evidence.load_cases = {{Axis::z, 13, 3e-9, true, 0.5, {}}, {Axis::x, 12, 2e-9, true, 0.4, 7e-10}};
    record.evidence.errors.zz = ComponentError{-1.2e-3, 1.4e-2};
    record.evidence.errors.scaled_xz = 2e-4;
    record.evidence.solver = "direct";
    record.evidence.warnings = {"f is 1.6; the paper advises 1 to 1.5 on Mesh1 (Table 3).", "", "\xc2\xb5"};
    return record;
}

inline std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace contactd
