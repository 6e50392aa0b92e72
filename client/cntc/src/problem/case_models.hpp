// The models that the flags B and M ask for.
#pragma once

#include "contactd/contact_setup.hpp"
#include "problem/settings.hpp"

namespace contactd::cntc {

struct CaseModels {
    Model model = Model::full;
    NormalModel normal_model = NormalModel::of_model;
    SimplifiedSettings simplified{};
};

/// FASTSIM goes in whole elements, with blended flexibilities and the printed coefficients, as the other program has
/// it. Throws Refused for a bound of 2 or 3 without a simplified theory, and for a simplified theory that has no such
/// bound.
CaseModels models_of(const Settings& settings);

}  // namespace contactd::cntc
