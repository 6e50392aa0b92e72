// Computes surface temperatures in steady rolling along x, for given tractions and slips.
#pragma once

#include "contactd/observer.hpp"
#include "contactd/temperature.hpp"

namespace contactd {

/// Computes the temperatures of both surfaces (Blok 1937; Ertz and Knothe 2002).
///
/// Each surface point passes the heat sources of its row, one element after the other. The surfaces pass at U1, U2 = V
/// (1 -+ w/2), with w the mean of the relative slip of the upper one in the row, along the rolling direction; or at U1
/// = upper_speed and U2 = U1 + V w. The heat is q = |p . s| V plus the plastic share of p . flow V. With c_i = b_i
/// sqrt(U_i), b_i the effusivities, the share c_i/(c1 + c2) of the heat flows into body i. Both surfaces rise by 2
/// sqrt(dx)/((c1 + c2) sqrt(pi)) sum_J q_J (sqrt(k + 1/2) - sqrt(k - 1/2)), with k the number of elements from one to J
/// ahead of it, and sqrt(1/2) for its own heat. This is exact at the centres for heat that is constant on each element.
///
/// With different bulk temperatures, both surfaces have (c1 T1 + c2 T2)/(c1 + c2) in contact. Behind it they have T_i +
/// (T - T_i) (2/pi) asin(sqrt(L/d)), with d the distance from the leading edge, and L that from the leading to the
/// trailing edge of the row, including gaps.
///
/// Reports the stage "temperature". Throws InvalidArgument ("chi", "velocity", "upper_speed", "pressure",
/// "temperature.upper.density", ...) and Cancelled.
SurfaceTemperatures surface_temperature(const TemperatureRequest& request, Observer& observer);

}  // namespace contactd
