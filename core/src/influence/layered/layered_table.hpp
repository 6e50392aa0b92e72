// Computes influence coefficients of layered bodies: exact in the wavenumber domain, integrated over the load by its
// edges.
#pragma once

#include "contactd/ic_table.hpp"
#include "contactd/layers.hpp"
#include "contactd/observer.hpp"
#include "influence/layered/offset_lattice.hpp"

namespace contactd {

/// Returns displacements at all offsets [l][k] from a load of either shape, in mm^3/N. Absolute errors are below 1e-10
/// of the larger of A_zz(0,0) and 1e-3 h/G of the topmost layer. On a rigid base coefficients decay exponentially; far
/// away they are rounding errors.
std::vector<SurfaceCoefficients> layered_coefficients(const Layers& body, LoadShape load_shape,
                                                      const OffsetLattice& offsets, const Observer& observer = {});

/// Returns all nine components at offsets 0..nx-1 x 0..ny-1 of elements dx x dy. Throws Cancelled if the observer,
/// which is called for each row, cancels: a million offsets take some seconds.
IcTable layered_table(const Layers& body, LoadShape load_shape, int nx, int ny, double dx, double dy,
                      const Observer& observer = {});

/// Returns estimated errors of such a table: three times the differences to a second computation, on other wavenumbers
/// and distances, at offsets near the load, halfway and at the table's ends, and at least rounding errors. Those of xx,
/// yy and zz are relative to the larger of zz(0,0) and 1e-3 h/G of the topmost layer.
IcErrors layered_errors(const Layers& body, LoadShape load_shape, const IcTable& table, double dx, double dy);

}  // namespace contactd
