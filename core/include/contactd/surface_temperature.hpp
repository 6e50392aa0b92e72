// Temperature of the surfaces of a contact that rolls steadily along x, of given tractions and slips.
#pragma once

#include "contactd/observer.hpp"
#include "contactd/temperature.hpp"

namespace contactd {

/// Each surface point passes the heat sources of its row, one element after the other. With the effusivities b1, b2 the
/// share b_i/(b1 + b2) of the heat q = |p . s| V goes into body i, and both surfaces rise by
///   2 sqrt(dx)/((b1 + b2) sqrt(pi V)) sum_J q_J (sqrt(k + 1/2) - sqrt(k - 1/2)),
/// k the elements from one to J, ahead of it, of its own heat sqrt(1/2): exact at the centres for a heat that is
/// constant on each element. Where bulk temperatures differ both surfaces have (b1 T1 + b2 T2)/(b1 + b2) in contact,
/// and behind it T_i + (T - T_i) (2/pi) asin(sqrt(L/d)), d from the leading edge, L from there to the trailing edge of
/// the row: of a row with gaps the whole. (Ertz and Knothe 2002.)
/// Reports the stage "temperature". Throws InvalidArgument ("chi", "velocity", "pressure", "temperature.upper.density",
/// ...) and Cancelled.
SurfaceTemperatures surface_temperature(const TemperatureRequest& request, Observer& observer);

}  // namespace contactd
