// Holds pressures computed by a model of virtual penetration.
#pragma once

#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

struct PenetrationContact {
    std::vector<double> pressure;  ///< shape [ny, nx] (N/mm^2)
    double approach = 0;           ///< (mm)
    double Fn = 0, pmax = 0;       ///< sum and largest value of the pressures
    SolverEvidence evidence;       ///< evidence of the search for an approach: |Fn - prescribed|/prescribed
    std::vector<std::string> warnings;
};

}  // namespace contactd
