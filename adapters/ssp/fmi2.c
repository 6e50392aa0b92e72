/* Implements the functions of FMI 2.0 for a part (part.h). Optional functions of co-simulation return an error. */
#include "part.h"

#include <fmi2Functions.h>
#include <stdlib.h>
#include <string.h>

#include "part_variables.h"

typedef struct {
    double values[MOST_VARIABLES];
    int count;
} Part;

static int take_starts(double* values) {
    static const double starts[] = {PART_STARTS};
    memcpy(values, starts, sizeof starts);
    return (int)(sizeof starts / sizeof *starts);
}

static fmi2Status within(const Part* part, const fmi2ValueReference* references, size_t count) {
    for (size_t k = 0; k < count; ++k)
        if (references[k] >= (fmi2ValueReference)part->count) return fmi2Error;
    return fmi2OK;
}

FMI2_Export const char* fmi2GetTypesPlatform(void) {
    return fmi2TypesPlatform;
}
FMI2_Export const char* fmi2GetVersion(void) {
    return fmi2Version;
}
FMI2_Export fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t count, const fmi2String names[]) {
    (void)c, (void)on, (void)count, (void)names;
    return fmi2OK;
}

FMI2_Export fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                                          const fmi2CallbackFunctions* functions, fmi2Boolean visible, fmi2Boolean on) {
    (void)name, (void)guid, (void)resources, (void)functions, (void)visible, (void)on;
    if (type != fmi2CoSimulation) return NULL;
    Part* part = calloc(1, sizeof *part);
    if (part) part->count = take_starts(part->values);
    return part;
}
FMI2_Export void fmi2FreeInstance(fmi2Component c) {
    free(c);
}

FMI2_Export fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean relative, fmi2Real tolerance, fmi2Real start,
                                           fmi2Boolean ends, fmi2Real stop) {
    (void)c, (void)relative, (void)tolerance, (void)start, (void)ends, (void)stop;
    return fmi2OK;
}
FMI2_Export fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
    return c ? fmi2OK : fmi2Error;
}
FMI2_Export fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
    part_begin(((Part*)c)->values);
    return fmi2OK;
}
FMI2_Export fmi2Status fmi2Terminate(fmi2Component c) {
    return c ? fmi2OK : fmi2Error;
}
FMI2_Export fmi2Status fmi2Reset(fmi2Component c) {
    take_starts(((Part*)c)->values);
    return fmi2OK;
}

FMI2_Export fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference r[], size_t count, fmi2Real v[]) {
    const Part* part = c;
    if (within(part, r, count) != fmi2OK) return fmi2Error;
    for (size_t k = 0; k < count; ++k) v[k] = part->values[r[k]];
    return fmi2OK;
}
FMI2_Export fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference r[], size_t count, const fmi2Real v[]) {
    Part* part = c;
    if (within(part, r, count) != fmi2OK) return fmi2Error;
    for (size_t k = 0; k < count; ++k) part->values[r[k]] = v[k];
    return fmi2OK;
}
FMI2_Export fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real size, fmi2Boolean no_way_back) {
    (void)no_way_back;
    return part_step(((Part*)c)->values, time, size) == 0 ? fmi2OK : fmi2Error;
}

/* There are no variables of other types. */
FMI2_Export fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference r[], size_t n, fmi2Integer v[]) {
    (void)c, (void)r, (void)v;
    return n == 0 ? fmi2OK : fmi2Error;
}
FMI2_Export fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference r[], size_t n, const fmi2Integer v[]) {
    (void)c, (void)r, (void)v;
    return n == 0 ? fmi2OK : fmi2Error;
}
FMI2_Export fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference r[], size_t n, fmi2Boolean v[]) {
    (void)c, (void)r, (void)v;
    return n == 0 ? fmi2OK : fmi2Error;
}
FMI2_Export fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference r[], size_t n, const fmi2Boolean v[]) {
    (void)c, (void)r, (void)v;
    return n == 0 ? fmi2OK : fmi2Error;
}
FMI2_Export fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference r[], size_t n, fmi2String v[]) {
    (void)c, (void)r, (void)v;
    return n == 0 ? fmi2OK : fmi2Error;
}
FMI2_Export fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference r[], size_t n, const fmi2String v[]) {
    (void)c, (void)r, (void)v;
    return n == 0 ? fmi2OK : fmi2Error;
}

/* An instance consists of its values, so a state is a copy of it. */
FMI2_Export fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* state) {
    if (!*state) *state = malloc(sizeof(Part));
    if (!*state) return fmi2Error;
    memcpy(*state, c, sizeof(Part));
    return fmi2OK;
}
FMI2_Export fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
    memcpy(c, state, sizeof(Part));
    return fmi2OK;
}
FMI2_Export fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* state) {
    (void)c;
    free(*state);
    *state = NULL;
    return fmi2OK;
}
FMI2_Export fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t* size) {
    (void)c, (void)state, (void)size;
    return fmi2Error;
}
FMI2_Export fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
    (void)c, (void)state, (void)bytes, (void)size;
    return fmi2Error;
}
FMI2_Export fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate* s) {
    (void)c, (void)bytes, (void)size, (void)s;
    return fmi2Error;
}

FMI2_Export fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference of[], size_t n,
                                                    const fmi2ValueReference by[], size_t m, const fmi2Real d[],
                                                    fmi2Real found[]) {
    (void)c, (void)of, (void)n, (void)by, (void)m, (void)d, (void)found;
    return fmi2Error;
}
FMI2_Export fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference r[], size_t n,
                                                   const fmi2Integer order[], const fmi2Real v[]) {
    (void)c, (void)r, (void)n, (void)order, (void)v;
    return fmi2Error;
}
FMI2_Export fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference r[], size_t n,
                                                    const fmi2Integer order[], fmi2Real v[]) {
    (void)c, (void)r, (void)n, (void)order, (void)v;
    return fmi2Error;
}
FMI2_Export fmi2Status fmi2CancelStep(fmi2Component c) {
    (void)c;
    return fmi2Error;
}
FMI2_Export fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Status* v) {
    (void)c, (void)kind, (void)v;
    return fmi2Discard;
}
FMI2_Export fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Real* v) {
    (void)c, (void)kind, (void)v;
    return fmi2Discard;
}
FMI2_Export fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Integer* v) {
    (void)c, (void)kind, (void)v;
    return fmi2Discard;
}
FMI2_Export fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean* v) {
    (void)c, (void)kind, (void)v;
    return fmi2Discard;
}
FMI2_Export fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind kind, fmi2String* v) {
    (void)c, (void)kind, (void)v;
    return fmi2Discard;
}
