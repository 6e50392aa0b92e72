#include "refused.hpp"

#include <string_view>

#include "edge/codes.hpp"
#include "given/not_covered.hpp"

namespace contactd::cntc {
namespace {

int code_of(std::string_view field) {
    if (field.starts_with("friction.mu") || field.starts_with("friction.kinetic")) return error_code::friction;
    if (field.starts_with("grid") || field == "friction.rolling.dq") return error_code::discretisation;
    for (const std::string_view part : {"profile", "rail.", "wheel.", "rail_slices", "wheel_slices"})
        if (field.starts_with(part)) return error_code::profile;
    return error_code::input;
}

int code_of(cases::Subject subject) {
    switch (subject) {
        case cases::Subject::file:
        case cases::Subject::profile:
            return error_code::profile;
        case cases::Subject::friction:
            return error_code::friction;
        case cases::Subject::discretisation:
            return error_code::discretisation;
        case cases::Subject::tolerance:
            return error_code::tolerance;
        case cases::Subject::coefficients:
        case cases::Subject::input:
            return error_code::input;
        default:
            return error_code::other;
    }
}

}  // namespace

Refused refused_of_exception() {
    try {
        throw;
    } catch (const Refused& refused) {
        return refused;
    } catch (const cases::NotCovered& refused) {
        return {code_of(refused.subject()), refused.what()};
    } catch (const InvalidArgument& error) {
        return {code_of(error.field()), error.what()};
    } catch (const std::exception& error) {
        return {error_code::other, error.what()};
    } catch (...) {
        return {error_code::other, "An unknown error occurred."};
    }
}

}  // namespace contactd::cntc
