// Functions that programs look up and contactd does not have: they report that, and answer no number.
#include "interface/entry.hpp"

using namespace contactd::cntc;

namespace {

int refuse(const char* function, const char* what) {
    return answer(function, [&] { throw Refused(error_code::other, std::string(what) + " is not covered."); });
}

constexpr const char* wheel_on_rail = "Wheel on rail (module 1)";
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

extern "C" void cntc_setverticalforce(int*, double*) {
    refuse("cntc_setverticalforce", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_setverticalforce)

extern "C" void cntc_setprofileinputfname(int*, const char*, int*, int*, int*, int*, double*) {
    refuse("cntc_setprofileinputfname", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_setprofileinputfname)

extern "C" void cntc_setprofileinputvalues(int*, int*, double*, int*, int*, int*, double*) {
    refuse("cntc_setprofileinputvalues", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_setprofileinputvalues)

extern "C" void cntc_settrackdimensions(int*, int*, int*, double*) {
    refuse("cntc_settrackdimensions", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_settrackdimensions)

extern "C" void cntc_setwheelsetdimensions(int*, int*, int*, double*) {
    refuse("cntc_setwheelsetdimensions", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_setwheelsetdimensions)

extern "C" void cntc_setwheelsetposition(int*, int*, int*, double*) {
    refuse("cntc_setwheelsetposition", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_setwheelsetposition)

extern "C" void cntc_setwheelsetvelocity(int*, int*, int*, double*) {
    refuse("cntc_setwheelsetvelocity", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_setwheelsetvelocity)

extern "C" void cntc_setwheelsetflexibility(int*, int*, int*, double*) {
    refuse("cntc_setwheelsetflexibility", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_setwheelsetflexibility)

extern "C" void cntc_getnumcontactpatches(int*, int* npatch) {
    if (npatch != nullptr) *npatch = -1;  // not a number of patches, and none to go through
    refuse("cntc_getnumcontactpatches", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_getnumcontactpatches)

extern "C" void cntc_getcontactlocation(int*, int*, int* lenarr, double* values) {
    clear(values, lenarr);
    refuse("cntc_getcontactlocation", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_getcontactlocation)

extern "C" void cntc_getglobalforces(int*, int*, int* lenarr, double* values) {
    clear(values, lenarr);
    refuse("cntc_getglobalforces", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_getglobalforces)

extern "C" void cntc_getwheelsetposition(int*, int* lenarr, double* values) {
    clear(values, lenarr);
    refuse("cntc_getwheelsetposition", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_getwheelsetposition)

extern "C" void cntc_getwheelsetvelocity(int*, int* lenarr, double* values) {
    clear(values, lenarr);
    refuse("cntc_getwheelsetvelocity", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_getwheelsetvelocity)

extern "C" void cntc_getprofilevalues(int*, int*, int*, int*, int* lenarr, double* values) {
    clear(values, lenarr);
    refuse("cntc_getprofilevalues", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_getprofilevalues)

extern "C" void cntc_getprofilevalues_new(int*, int*, int*, int*, int*, double*, int* lenarr, double* values) {
    clear(values, lenarr);
    refuse("cntc_getprofilevalues_new", wheel_on_rail);
}
CONTACTD_FORTRAN_NAME(cntc_getprofilevalues_new)
