// Implements FMI 3.0: functions that importers look up, but this FMU does not support, according to its model
// description.
#include "fmi3.hpp"

using namespace contactd::fmu;

namespace {

using References = const fmi3ValueReference*;

fmi3Status absent(fmi3Instance handle, const char* what) {
    return with(handle, [&](Instance&) { throw Failure(std::string("This FMU has no ") + what + "."); });
}

}  // namespace

fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                          fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger) {
    if (logger != nullptr)
        logger(environment, fmi3Error, "errors", "This FMU is for co-simulation, not for model exchange.");
    return nullptr;
}
fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean,
                                               fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger,
                                               fmi3ClockUpdateCallback, fmi3LockPreemptionCallback,
                                               fmi3UnlockPreemptionCallback) {
    if (logger != nullptr)
        logger(environment, fmi3Error, "errors", "This FMU is for co-simulation, not for scheduled execution.");
    return nullptr;
}

fmi3Status fmi3EnterEventMode(fmi3Instance handle) {
    return absent(handle, "event mode");
}
fmi3Status fmi3EnterStepMode(fmi3Instance handle) {
    return absent(handle, "event mode to come back from");
}
fmi3Status fmi3EnterConfigurationMode(fmi3Instance handle) {
    return absent(handle, "structural parameters");
}
fmi3Status fmi3ExitConfigurationMode(fmi3Instance handle) {
    return absent(handle, "structural parameters");
}
fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance handle) {
    return absent(handle, "discrete states");
}
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance handle, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*,
                                    fmi3Boolean*, fmi3Float64*) {
    return absent(handle, "discrete states");
}
fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance handle, fmi3ValueReference, std::size_t*) {
    return absent(handle, "dependencies of single elements: all outputs follow all inputs");
}
fmi3Status fmi3GetVariableDependencies(fmi3Instance handle, fmi3ValueReference, std::size_t[], fmi3ValueReference[],
                                       std::size_t[], fmi3DependencyKind[], std::size_t) {
    return absent(handle, "dependencies of single elements: all outputs follow all inputs");
}
fmi3Status fmi3GetAdjointDerivative(fmi3Instance handle, References, std::size_t, References, std::size_t,
                                    const fmi3Float64[], std::size_t, fmi3Float64[], std::size_t) {
    return absent(handle, "adjoint derivatives; the directional ones are few");
}
fmi3Status fmi3GetOutputDerivatives(fmi3Instance handle, References, std::size_t, const fmi3Int32[], fmi3Float64[],
                                    std::size_t) {
    return absent(handle, "derivatives of outputs by time");
}
fmi3Status fmi3GetIntervalDecimal(fmi3Instance handle, References, std::size_t, fmi3Float64[],
                                  fmi3IntervalQualifier[]) {
    return absent(handle, "clocks");
}
fmi3Status fmi3GetIntervalFraction(fmi3Instance handle, References, std::size_t, fmi3UInt64[], fmi3UInt64[],
                                   fmi3IntervalQualifier[]) {
    return absent(handle, "clocks");
}
fmi3Status fmi3GetShiftDecimal(fmi3Instance handle, References, std::size_t, fmi3Float64[]) {
    return absent(handle, "clocks");
}
fmi3Status fmi3GetShiftFraction(fmi3Instance handle, References, std::size_t, fmi3UInt64[], fmi3UInt64[]) {
    return absent(handle, "clocks");
}
fmi3Status fmi3SetIntervalDecimal(fmi3Instance handle, References, std::size_t, const fmi3Float64[]) {
    return absent(handle, "clocks");
}
fmi3Status fmi3SetIntervalFraction(fmi3Instance handle, References, std::size_t, const fmi3UInt64[],
                                   const fmi3UInt64[]) {
    return absent(handle, "clocks");
}
fmi3Status fmi3SetShiftDecimal(fmi3Instance handle, References, std::size_t, const fmi3Float64[]) {
    return absent(handle, "clocks");
}
fmi3Status fmi3SetShiftFraction(fmi3Instance handle, References, std::size_t, const fmi3UInt64[], const fmi3UInt64[]) {
    return absent(handle, "clocks");
}

// Importers also look up functions of model exchange and scheduled execution.
fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance handle) {
    return absent(handle, "continuous time");
}
fmi3Status fmi3CompletedIntegratorStep(fmi3Instance handle, fmi3Boolean, fmi3Boolean*, fmi3Boolean*) {
    return absent(handle, "integrator steps");
}
fmi3Status fmi3SetTime(fmi3Instance handle, fmi3Float64) {
    return absent(handle, "settable time; steps define it");
}
fmi3Status fmi3SetContinuousStates(fmi3Instance handle, const fmi3Float64[], std::size_t) {
    return absent(handle, "continuous states");
}
fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance handle, fmi3Float64[], std::size_t) {
    return absent(handle, "continuous states");
}
fmi3Status fmi3GetEventIndicators(fmi3Instance handle, fmi3Float64[], std::size_t) {
    return absent(handle, "event indicators");
}
fmi3Status fmi3GetContinuousStates(fmi3Instance handle, fmi3Float64[], std::size_t) {
    return absent(handle, "continuous states");
}
fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance handle, fmi3Float64[], std::size_t) {
    return absent(handle, "continuous states");
}
fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance handle, std::size_t*) {
    return absent(handle, "event indicators");
}
fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance handle, std::size_t*) {
    return absent(handle, "continuous states");
}
fmi3Status fmi3ActivateModelPartition(fmi3Instance handle, fmi3ValueReference, fmi3Float64) {
    return absent(handle, "model partitions");
}
