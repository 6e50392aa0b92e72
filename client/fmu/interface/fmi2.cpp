// Implements FMI 2.0 for co-simulation: creation, phases and values of an instance.
#include "fmi2.hpp"

#include "models/place.hpp"

using namespace contactd::fmu;

namespace {

/// FMI 2 treats messages as printf formats.
std::string escaped(const std::string& sentence) {
    std::string text;
    for (const char letter : sentence) text.append(letter == '%' ? 2 : 1, letter);
    return text;
}

Instance::Log log_of(const fmi2CallbackFunctions* functions, std::string name) {
    if (functions == nullptr || functions->logger == nullptr) return [](auto&&...) {};
    return [logger = functions->logger, environment = functions->componentEnvironment, name = std::move(name)](
               Status status, Category category, const std::string& sentence) {
        logger(environment, name.c_str(), fmi2_statuses[static_cast<int>(status)], name_of(category).data(),
               escaped(sentence).c_str());
    };
}

template <class Value>
fmi2Status get(fmi2Component c, const fmi2ValueReference* references, std::size_t count, Value* values,
               std::initializer_list<Type> types) {
    return with(c, [&](Instance& instance) {
        given(references, count, "vr"), given(values, count, "value");
        for (std::size_t k = 0; k < count; ++k) values[k] = static_cast<Value>(instance.number(references[k], types));
    });
}

template <class Value>
fmi2Status set(fmi2Component c, const fmi2ValueReference* references, std::size_t count, const Value* values,
               std::initializer_list<Type> types) {
    return with(c, [&](Instance& instance) {
        given(references, count, "vr"), given(values, count, "value");
        for (std::size_t k = 0; k < count; ++k) instance.set_number(references[k], types, values[k]);
    });
}

}  // namespace

const char* fmi2GetTypesPlatform() {
    return fmi2TypesPlatform;
}
const char* fmi2GetVersion() {
    return "2.0";
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions* functions, fmi2Boolean, fmi2Boolean logging) {
    const std::string called = name ? name : "";
    try {
        const Instance::Log log = log_of(functions, called);
        const Kind* kind = kind_with(guid ? guid : "");
        const char* wrong = called.empty()             ? "An instance needs a name."
                            : type != fmi2CoSimulation ? "This FMU is for co-simulation, not for model exchange."
                            : kind == nullptr          ? "The GUID is that of another FMU; its modelDescription.xml "
                                                         "belongs to another shared object."
                                                       : nullptr;
        if (wrong != nullptr) return log(Status::error, Category::errors, wrong), nullptr;
        auto made = std::make_unique<Instance>(*kind, path_of(resources ? resources : ""), log);
        made->set_log(logging, {});
        return Live<Instance>::all().add(std::move(made));
    } catch (...) {
        return nullptr;
    }
}

void fmi2FreeInstance(fmi2Component c) {
    Live<Instance>::all().take(c);
}

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, std::size_t count, const fmi2String categories[]) {
    return with(c, [&](Instance& instance) { instance.set_log(on, texts_of(categories, count)); });
}

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean, fmi2Real, fmi2Real start, fmi2Boolean stops,
                               fmi2Real stop) {
    return with(c, [&](Instance& instance) { instance.set_start(start, stops ? std::optional(stop) : std::nullopt); });
}
fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
    return with(c, [](Instance& instance) { instance.enter_initialization(); });
}
fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
    return with(c, [](Instance& instance) { instance.exit_initialization(); });
}
fmi2Status fmi2Terminate(fmi2Component c) {
    return with(c, [](Instance& instance) { instance.terminate(); });
}
fmi2Status fmi2Reset(fmi2Component c) {
    return with(c, [](Instance& instance) { instance.reset(); });
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], std::size_t count, fmi2Real value[]) {
    return get(c, vr, count, value, {Type::real});
}
fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], std::size_t count, fmi2Integer value[]) {
    return get(c, vr, count, value, {Type::integer, Type::enumeration});
}
fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], std::size_t count, fmi2Boolean value[]) {
    return get(c, vr, count, value, {Type::boolean});
}
fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], std::size_t count, fmi2String value[]) {
    return with(c, [&](Instance& instance) {
        given(vr, count, "vr"), given(value, count, "value");
        for (std::size_t k = 0; k < count; ++k) value[k] = instance.text(vr[k]).c_str();
    });
}
fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], std::size_t count, const fmi2Real value[]) {
    return set(c, vr, count, value, {Type::real});
}
fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], std::size_t count,
                          const fmi2Integer value[]) {
    return set(c, vr, count, value, {Type::integer, Type::enumeration});
}
fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], std::size_t count,
                          const fmi2Boolean value[]) {
    return with(c, [&](Instance& instance) {
        given(vr, count, "vr"), given(value, count, "value");
        for (std::size_t k = 0; k < count; ++k) instance.set_number(vr[k], {Type::boolean}, value[k] != fmi2False);
    });
}
fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], std::size_t count, const fmi2String value[]) {
    return with(c, [&](Instance& instance) {
        given(vr, count, "vr"), given(value, count, "value");
        for (std::size_t k = 0; k < count; ++k) instance.set_text(vr[k], &given(value[k], "value"));
    });
}
