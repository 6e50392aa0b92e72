// Implements FMI 3.0: values of variables, which are all scalars.
#include "fmi3.hpp"

using namespace contactd::fmu;

namespace {

using References = const fmi3ValueReference*;

void require_scalars(std::size_t references, std::size_t values) {
    if (references != values) throw Failure("All variables are scalars, so there are as many values as references.");
}

template <class Value>
fmi3Status get(fmi3Instance handle, References references, std::size_t count, Value* values, std::size_t length,
               Type type) {
    return with(handle, [&](Instance& instance) {
        given(references, count, "valueReferences"), given(values, length, "values");
        require_scalars(count, length);
        for (std::size_t k = 0; k < count; ++k) values[k] = static_cast<Value>(instance.number(references[k], {type}));
    });
}

template <class Value>
fmi3Status set(fmi3Instance handle, References references, std::size_t count, const Value* values, std::size_t length,
               Type type) {
    return with(handle, [&](Instance& instance) {
        given(references, count, "valueReferences"), given(values, length, "values");
        require_scalars(count, length);
        for (std::size_t k = 0; k < count; ++k)
            instance.set_number(references[k], {type}, static_cast<double>(values[k]));
    });
}

/// Answers a call for a type without variables.
fmi3Status nothing_of_this_type(fmi3Instance handle, std::size_t references) {
    return with(handle, [&](Instance&) {
        if (references > 0)
            throw Failure(
                "No variable has this type; there are Float64, Int32, Int64 (enumerations), Boolean, String.");
    });
}

}  // namespace

// NOLINTBEGIN: names and arguments are those of the headers
#define HAS(Name, Of)                                                                                                 \
    fmi3Status fmi3Get##Name(fmi3Instance handle, References vr, std::size_t n, fmi3##Name values[], std::size_t m) { \
        return get(handle, vr, n, values, m, Of);                                                                     \
    }                                                                                                                 \
    fmi3Status fmi3Set##Name(fmi3Instance handle, References vr, std::size_t n, const fmi3##Name values[],            \
                             std::size_t m) {                                                                         \
        return set(handle, vr, n, values, m, Of);                                                                     \
    }
#define HAS_NOT(Name)                                                                                           \
    fmi3Status fmi3Get##Name(fmi3Instance handle, References, std::size_t n, fmi3##Name[], std::size_t) {       \
        return nothing_of_this_type(handle, n);                                                                 \
    }                                                                                                           \
    fmi3Status fmi3Set##Name(fmi3Instance handle, References, std::size_t n, const fmi3##Name[], std::size_t) { \
        return nothing_of_this_type(handle, n);                                                                 \
    }

HAS(Float64, Type::real)
HAS(Int32, Type::integer)
HAS(Int64, Type::enumeration)
HAS(Boolean, Type::boolean)
HAS_NOT(Float32)
HAS_NOT(Int8)
HAS_NOT(UInt8)
HAS_NOT(Int16)
HAS_NOT(UInt16)
HAS_NOT(UInt32)
HAS_NOT(UInt64)
// NOLINTEND

fmi3Status fmi3GetString(fmi3Instance handle, References references, std::size_t count, fmi3String values[],
                         std::size_t length) {
    return with(handle, [&](Instance& instance) {
        given(references, count, "valueReferences"), given(values, length, "values");
        require_scalars(count, length);
        for (std::size_t k = 0; k < count; ++k) values[k] = instance.text(references[k]).c_str();
    });
}

fmi3Status fmi3SetString(fmi3Instance handle, References references, std::size_t count, const fmi3String values[],
                         std::size_t length) {
    return with(handle, [&](Instance& instance) {
        given(references, count, "valueReferences"), given(values, length, "values");
        require_scalars(count, length);
        for (std::size_t k = 0; k < count; ++k) instance.set_text(references[k], &given(values[k], "value"));
    });
}

fmi3Status fmi3GetBinary(fmi3Instance handle, References, std::size_t count, std::size_t[], fmi3Binary[], std::size_t) {
    return nothing_of_this_type(handle, count);
}
fmi3Status fmi3SetBinary(fmi3Instance handle, References, std::size_t count, const std::size_t[], const fmi3Binary[],
                         std::size_t) {
    return nothing_of_this_type(handle, count);
}
fmi3Status fmi3GetClock(fmi3Instance handle, References, std::size_t count, fmi3Clock[]) {
    return nothing_of_this_type(handle, count);
}
fmi3Status fmi3SetClock(fmi3Instance handle, References, std::size_t count, const fmi3Clock[]) {
    return nothing_of_this_type(handle, count);
}
