// Reads and writes the groups of an IC file.
#pragma once

#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/strip_spectrum.hpp"
#include "file_values.hpp"

namespace contactd {

/// Returns whether a table is dimensionless. Tables of the store are for G = 1 and dx = 1, and of a longitudinally
/// uniform body also for dy = 1. Exported tables may have dimensions (mm^3/N).
inline bool is_dimensionless(const IcSpec& spec) {
    return spec.dx == 1 && spec.material.G == 1 && (!spec.section || spec.dy == 1);
}

void write_spec(const WritableGroup& at, const IcSpec& spec);
IcSpec read_spec(const Group& at);

/// Write and read the attributes of a mesh and its solver.
void write_fem(const WritableGroup& at, const FemSpec& fem);
FemSpec read_fem(const Group& at);

/// Write and read the transform of a longitudinally uniform body's coefficients. Reading throws DamagedTable if the
/// parts are inconsistent.
void write_spectrum(const WritableGroup& at, const StripSpectrum& spectrum);
StripSpectrum read_spectrum(const Group& at, double nu);

void write_evidence(const WritableGroup& at, const IcEvidence& evidence);
IcEvidence read_evidence(const Group& at);

}  // namespace contactd
