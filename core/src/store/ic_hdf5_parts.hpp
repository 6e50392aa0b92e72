// The groups of an IC file.
#pragma once

#include <H5Cpp.h>

#include "contactd/column_spectrum.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"

namespace contactd {

/// A table of the store: for G = 1 and dx = 1, of a prism also dy = 1. Those that leave contactd may have dimensions
/// (mm^3/N).
inline bool is_dimensionless(const IcSpec& spec) {
    return spec.dx == 1 && spec.material.G == 1 && (!spec.section || spec.dy == 1);
}

void write_spec(H5::Group group, const IcSpec& spec);
IcSpec read_spec(const H5::Group& group);

/// The attributes of a mesh and its solver.
void write_fem(H5::Group& group, const FemSpec& fem);
FemSpec read_fem(const H5::Group& group);

/// The transform of a prism's coefficients. Reading throws DamagedTable when the parts do not fit each other.
void write_spectrum(H5::H5File& file, const ColumnSpectrum& spectrum);
ColumnSpectrum read_spectrum(const H5::H5File& file, double nu);

void write_evidence(H5::Group group, const IcEvidence& evidence);
IcEvidence read_evidence(const H5::Group& group);

}  // namespace contactd
