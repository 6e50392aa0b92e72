// Imports FMUs: loads the binary of one, and steps an instance of it.
//
//     fmu-host LIBRARY VERSION GUID STEPS SIZE [REFERENCE=NUMBER ...] -- [REFERENCE ...]
//
// Prints the real outputs of these references after each step, to the last digit.
#include <fmi2FunctionTypes.h>
#include <fmi3FunctionTypes.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <filesystem>

#include <shellapi.h>
#else
#include <dlfcn.h>
#endif

namespace {

#ifdef _WIN32
/// Converts arguments to UTF-8, as on other systems; on Windows they are in the code page.
std::vector<std::string> arguments_of(int, char**) {
    int count = 0;
    wchar_t** given = CommandLineToArgvW(GetCommandLineW(), &count);
    std::vector<std::string> arguments;
    for (int k = 0; k < count; ++k) arguments.push_back(std::filesystem::path(given[k]).string());
    LocalFree(given);
    return arguments;
}
using Library = HMODULE;
Library loaded(const std::string& path) {
    return LoadLibraryW(std::filesystem::path(path).c_str());
}
void* found(Library library, const std::string& name) {
    return reinterpret_cast<void*>(GetProcAddress(library, name.c_str()));
}
#else
std::vector<std::string> arguments_of(int count, char** given) {
    return {given, given + count};
}
using Library = void*;
Library loaded(const std::string& path) {
    return dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
}
void* found(Library library, const std::string& name) {
    return dlsym(library, name.c_str());
}
#endif

struct Run {
    Library library;
    std::string guid;
    int steps = 0;
    double size = 0;
    std::vector<unsigned> inputs, outputs;
    std::vector<double> values;

    template <class Function>
    Function* call(const std::string& name) const {
        void* address = found(library, name);
        if (!address) {
            std::printf("text the library lacks %s\n", name.c_str());
            std::exit(1);
        }
        return reinterpret_cast<Function*>(address);
    }
};

void check(int status, const char* what) {
    if (status <= 1) return;
    std::printf("text FAILED %s: %d\n", what, status);
    std::exit(1);
}

void print(const std::vector<double>& outputs) {
    std::printf("outputs");
    for (const double output : outputs) std::printf(" %.17g", output);
    std::printf("\n");
}

void log2(fmi2ComponentEnvironment, fmi2String, fmi2Status, fmi2String, fmi2String sentence, ...) {
    std::fprintf(stderr, "%s\n", sentence);
}

void run2(const Run& run) {
    fmi2CallbackFunctions functions{log2, std::calloc, std::free, nullptr, nullptr};
    fmi2Component c = run.call<fmi2InstantiateTYPE>("fmi2Instantiate")("one", fmi2CoSimulation, run.guid.c_str(), "",
                                                                       &functions, fmi2False, fmi2True);
    if (!c) check(3, "fmi2Instantiate");
    check(run.call<fmi2SetupExperimentTYPE>("fmi2SetupExperiment")(c, fmi2False, 0, 0, fmi2False, 0), "set-up");
    check(run.call<fmi2SetRealTYPE>("fmi2SetReal")(c, run.inputs.data(), run.inputs.size(), run.values.data()), "set");
    check(run.call<fmi2EnterInitializationModeTYPE>("fmi2EnterInitializationMode")(c), "enter");
    check(run.call<fmi2ExitInitializationModeTYPE>("fmi2ExitInitializationMode")(c), "exit");
    std::vector<double> outputs(run.outputs.size());
    for (int k = 0; k < run.steps; ++k) {
        check(run.call<fmi2DoStepTYPE>("fmi2DoStep")(c, k * run.size, run.size, fmi2True), "step");
        check(run.call<fmi2GetRealTYPE>("fmi2GetReal")(c, run.outputs.data(), outputs.size(), outputs.data()), "get");
        print(outputs);
    }
    check(run.call<fmi2TerminateTYPE>("fmi2Terminate")(c), "terminate");
    run.call<fmi2FreeInstanceTYPE>("fmi2FreeInstance")(c);
}

void log3(fmi3InstanceEnvironment, fmi3Status, fmi3String, fmi3String sentence) {
    std::fprintf(stderr, "%s\n", sentence);
}

void run3(const Run& run) {
    fmi3Instance c = run.call<fmi3InstantiateCoSimulationTYPE>("fmi3InstantiateCoSimulation")(
        "one", run.guid.c_str(), "", fmi3False, fmi3True, fmi3False, fmi3False, nullptr, 0, nullptr, log3, nullptr);
    if (!c) check(3, "fmi3InstantiateCoSimulation");
    const std::size_t given = run.inputs.size();
    check(run.call<fmi3SetFloat64TYPE>("fmi3SetFloat64")(c, run.inputs.data(), given, run.values.data(), given), "set");
    check(run.call<fmi3EnterInitializationModeTYPE>("fmi3EnterInitializationMode")(c, fmi3False, 0, 0, fmi3False, 0),
          "enter");
    check(run.call<fmi3ExitInitializationModeTYPE>("fmi3ExitInitializationMode")(c), "exit");
    std::vector<double> outputs(run.outputs.size());
    const std::size_t count = outputs.size();
    for (int k = 0; k < run.steps; ++k) {
        fmi3Boolean event = false, terminated = false, early = false;
        double last = 0;
        check(run.call<fmi3DoStepTYPE>("fmi3DoStep")(c, k * run.size, run.size, fmi3True, &event, &terminated, &early,
                                                     &last),
              "step");
        check(run.call<fmi3GetFloat64TYPE>("fmi3GetFloat64")(c, run.outputs.data(), count, outputs.data(), count),
              "get");
        print(outputs);
    }
    check(run.call<fmi3TerminateTYPE>("fmi3Terminate")(c), "terminate");
    run.call<fmi3FreeInstanceTYPE>("fmi3FreeInstance")(c);
}

}  // namespace

int main(int count, char** given) {
    const std::vector<std::string> arguments = arguments_of(count, given);
    if (arguments.size() < 6) return 2;
    Run run{loaded(arguments[1]),
            arguments[3],
            std::atoi(arguments[4].c_str()),
            std::atof(arguments[5].c_str()),
            {},
            {},
            {}};
    if (!run.library) {
        std::printf("text the library cannot be loaded\n");
        return 1;
    }
    bool are_outputs = false;
    for (std::size_t k = 6; k < arguments.size(); ++k) {
        const std::string& argument = arguments[k];
        const auto reference = static_cast<unsigned>(std::strtoul(argument.c_str(), nullptr, 10));
        if (argument == "--") {
            are_outputs = true;
        } else if (are_outputs) {
            run.outputs.push_back(reference);
        } else {
            run.inputs.push_back(reference);
            run.values.push_back(std::atof(argument.c_str() + argument.find('=') + 1));
        }
    }
    arguments[2] == "2" ? run2(run) : run3(run);
    return 0;
}
