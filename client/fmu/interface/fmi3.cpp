// Implements FMI 3.0 for co-simulation: creation, phases, steps, states and derivatives of an instance.
#include "fmi3.hpp"

#include "instance/serialized.hpp"
#include "models/place.hpp"

using namespace contactd::fmu;

const char* fmi3GetVersion() {
    return "3.0";
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean,
                                         fmi3Boolean logging, fmi3Boolean event_mode, fmi3Boolean,
                                         const fmi3ValueReference[], std::size_t intermediate,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger,
                                         fmi3IntermediateUpdateCallback) {
    try {
        const Instance::Log log = [=](Status status, Category category, const std::string& sentence) {
            if (logger == nullptr) return;
            logger(environment, fmi3_statuses[static_cast<int>(status)], name_of(category).data(), sentence.c_str());
        };
        const Kind* kind = kind_with(token ? token : "");
        const char* wrong = name == nullptr || *name == 0 ? "An instance needs a name."
                            : kind == nullptr             ? "The instantiation token is that of another FMU; its "
                                                            "modelDescription.xml belongs to another shared object."
                            : event_mode                  ? "This FMU has no event mode."
                            : intermediate > 0            ? "This FMU has no intermediate updates."
                                                          : nullptr;
        if (wrong != nullptr) return log(Status::error, Category::errors, wrong), nullptr;
        auto made = std::make_unique<Instance>(*kind, path_of(resources ? resources : ""), log);
        made->set_log(logging, {});
        return Live<Instance>::all().add(std::move(made));
    } catch (...) {
        return nullptr;
    }
}

void fmi3FreeInstance(fmi3Instance instance) {
    Live<Instance>::all().take(instance);
}

fmi3Status fmi3SetDebugLogging(fmi3Instance handle, fmi3Boolean on, std::size_t count, const fmi3String categories[]) {
    return with(handle, [&](Instance& instance) { instance.set_log(on, texts_of(categories, count)); });
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance handle, fmi3Boolean, fmi3Float64, fmi3Float64 start,
                                       fmi3Boolean stops, fmi3Float64 stop) {
    return with(handle, [&](Instance& instance) {
        instance.set_start(start, stops ? std::optional(stop) : std::nullopt);
        instance.enter_initialization();
    });
}
fmi3Status fmi3ExitInitializationMode(fmi3Instance handle) {
    return with(handle, [](Instance& instance) { instance.exit_initialization(); });
}
fmi3Status fmi3Terminate(fmi3Instance handle) {
    return with(handle, [](Instance& instance) { instance.terminate(); });
}
fmi3Status fmi3Reset(fmi3Instance handle) {
    return with(handle, [](Instance& instance) { instance.reset(); });
}

fmi3Status fmi3DoStep(fmi3Instance handle, fmi3Float64 time, fmi3Float64 size, fmi3Boolean, fmi3Boolean* event,
                      fmi3Boolean* ends, fmi3Boolean* early, fmi3Float64* last_time) {
    for (fmi3Boolean* no : {event, ends, early})
        if (no != nullptr) *no = fmi3False;
    return with(handle, [&](Instance& instance) {
        if (last_time != nullptr) *last_time = instance.time();
        instance.step(time, size);
        if (last_time != nullptr) *last_time = instance.time();
    });
}

fmi3Status fmi3GetFMUState(fmi3Instance handle, fmi3FMUState* state) {
    return with(handle, [&](Instance& instance) { hand_over(instance.state(), state); });
}
fmi3Status fmi3SetFMUState(fmi3Instance handle, fmi3FMUState state) {
    return with(handle, [&](Instance& instance) { instance.set_state(state_of(state)); });
}
fmi3Status fmi3FreeFMUState(fmi3Instance handle, fmi3FMUState* state) {
    return with(handle, [&](Instance&) { free_state(state); });
}
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance handle, fmi3FMUState state, std::size_t* size) {
    return with(handle,
                [&](Instance& instance) { given(size, "size") = serialized(instance.kind(), state_of(state)).size(); });
}
fmi3Status fmi3SerializeFMUState(fmi3Instance handle, fmi3FMUState state, fmi3Byte bytes[], std::size_t size) {
    return with(handle, [&](Instance& instance) { put_serialized(instance.kind(), state_of(state), bytes, size); });
}
fmi3Status fmi3DeserializeFMUState(fmi3Instance handle, const fmi3Byte bytes[], std::size_t size, fmi3FMUState* state) {
    return with(handle, [&](Instance& instance) {
        hand_over(deserialized(instance.kind(), std::as_bytes(given(bytes, size, "serializedState"))), state);
    });
}

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance handle, const fmi3ValueReference unknown[], std::size_t unknowns,
                                        const fmi3ValueReference known[], std::size_t knowns, const fmi3Float64 seed[],
                                        std::size_t seeds, fmi3Float64 sensitivity[], std::size_t sensitivities) {
    return with(handle, [&](Instance& instance) {
        if (seeds != knowns || sensitivities != unknowns)
            throw Failure(
                "A seed belongs to each known, and a sensitivity to each unknown: all variables are scalars.");
        const auto answer = instance.derivative(given(unknown, unknowns, "unknowns"), given(known, knowns, "knowns"),
                                                given(seed, seeds, "seed"));
        std::ranges::copy(answer, given(sensitivity, sensitivities, "sensitivity").begin());
    });
}
