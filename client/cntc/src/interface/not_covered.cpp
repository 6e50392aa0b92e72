// Functions that programs look up and contactd does not have: they report that, and answer no number.
#include "interface/entry.hpp"

using namespace contactd::cntc;

namespace {

int refuse(const char* function, const char* what) {
    return answer(function, [&] { throw Refused(error_code::other, std::string(what) + " is not covered."); });
}

constexpr const char* heat = "Temperature";

}  // namespace

/// A program that asks for heat gets no solution without it.
extern "C" void cntc_settemperaturedata(int* ire, int* icp, int* imeth, int*, double*) {
    set("cntc_settemperaturedata", ire, icp, "temperature", [&](Settings&) {
        if (imeth != nullptr && *imeth == 0) return;  // none
        throw Refused(error_code::other, std::string(heat) + " is not covered.");
    });
}
CONTACTD_FORTRAN_NAME(cntc_settemperaturedata)

extern "C" void cntc_getmaximumtemperature(int*, int*, double* t1max, double* t2max) {
    clear(t1max);
    clear(t2max);
    refuse("cntc_getmaximumtemperature", heat);
}
CONTACTD_FORTRAN_NAME(cntc_getmaximumtemperature)
