// Implements FMI 2.0 for co-simulation: steps, states and derivatives.
#include <cstring>

#include "fmi2.hpp"
#include "instance/serialized.hpp"

using namespace contactd::fmu;

namespace {

fmi2Status refuse(fmi2Component c, const char* sentence) {
    return with(c, [&](Instance&) { throw Failure(Status::discard, sentence); });
}

fmi2Status no_pending(fmi2Component c) {
    return refuse(c, "Steps are never pending: they end before fmi2DoStep returns, so they have no status.");
}

}  // namespace

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real size, fmi2Boolean) {
    return with(c, [&](Instance& instance) { instance.step(time, size); });
}

fmi2Status fmi2CancelStep(fmi2Component c) {
    return with(c, [](Instance& instance) { instance.cancel(); });
}

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* state) {
    return with(c, [&](Instance& instance) { hand_over(instance.state(), state); });
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
    return with(c, [&](Instance& instance) { instance.set_state(state_of(state)); });
}

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* state) {
    return with(c, [&](Instance&) { free_state(state); });
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, std::size_t* size) {
    return with(c,
                [&](Instance& instance) { given(size, "size") = serialized(instance.kind(), state_of(state)).size(); });
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], std::size_t size) {
    return with(c, [&](Instance& instance) { put_serialized(instance.kind(), state_of(state), bytes, size); });
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], std::size_t size, fmi2FMUstate* state) {
    return with(c, [&](Instance& instance) {
        hand_over(deserialized(instance.kind(), std::as_bytes(given(bytes, size, "serializedState"))), state);
    });
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknown[], std::size_t unknowns,
                                        const fmi2ValueReference known[], std::size_t knowns, const fmi2Real by[],
                                        fmi2Real of[]) {
    return with(c, [&](Instance& instance) {
        const auto answer = instance.derivative(given(unknown, unknowns, "vUnknown_ref"),
                                                given(known, knowns, "vKnown_ref"), given(by, knowns, "dvKnown"));
        std::ranges::copy(answer, given(of, unknowns, "dvUnknown").begin());
    });
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference[], std::size_t, const fmi2Integer[],
                                       const fmi2Real[]) {
    return refuse(c, "Inputs hold over a step; they are not interpolated by their derivatives.");
}
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference[], std::size_t, const fmi2Integer[],
                                        fmi2Real[]) {
    return refuse(c, "Outputs have no derivatives by time.");
}

fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Real* value) {
    if (kind != fmi2LastSuccessfulTime) return no_pending(c);
    return with(c, [&](Instance& instance) { given(value, "value") = instance.time(); });
}
fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean* value) {
    if (kind != fmi2Terminated) return no_pending(c);
    return with(c, [&](Instance&) { given(value, "value") = fmi2False; });
}
fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind, fmi2Status*) {
    return no_pending(c);
}
fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind, fmi2Integer*) {
    return no_pending(c);
}
fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind, fmi2String*) {
    return no_pending(c);
}
