// Implements FMI 2.0: the functions of model exchange, which importers also look up.
#include "fmi2.hpp"

using namespace contactd::fmu;

namespace {

fmi2Status absent(fmi2Component c) {
    return with(c, [](Instance&) { throw Failure("This FMU is for co-simulation, not for model exchange."); });
}

}  // namespace

fmi2Status fmi2EnterEventMode(fmi2Component c) {
    return absent(c);
}
fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo*) {
    return absent(c);
}
fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) {
    return absent(c);
}
fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean, fmi2Boolean*, fmi2Boolean*) {
    return absent(c);
}
fmi2Status fmi2SetTime(fmi2Component c, fmi2Real) {
    return absent(c);
}
fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real[], std::size_t) {
    return absent(c);
}
fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real[], std::size_t) {
    return absent(c);
}
fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real[], std::size_t) {
    return absent(c);
}
fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real[], std::size_t) {
    return absent(c);
}
fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real[], std::size_t) {
    return absent(c);
}
