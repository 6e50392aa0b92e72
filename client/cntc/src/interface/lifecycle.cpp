// Starts and ends the use of the library.
#include "interface/entry.hpp"

using namespace contactd::cntc;

namespace {

void start(const char* function, int* ifcver, int* ierror) {
    const int code = answer(function, [&] { require(ierror, "ierror"); });
    if (ifcver != nullptr) *ifcver = interface_version;
    if (ierror != nullptr) *ierror = code;
}

}  // namespace

// The arguments from the fourth on describe two lists, which are ignored.
extern "C" void cntc_initializefirst(int* ifcver, int* ierror, int*, const char*, const char*, const char*, int*, int*,
                                     int*) {
    start("cntc_initializefirst", ifcver, ierror);
}
CONTACTD_FORTRAN_NAME(cntc_initializefirst)

extern "C" void cntc_initializefirst_new(int* ifcver, int* ierror, int*, const char*, const char*, const char*, int*,
                                         int*, int*) {
    start("cntc_initializefirst_new", ifcver, ierror);
}
CONTACTD_FORTRAN_NAME(cntc_initializefirst_new)

extern "C" void cntc_initialize(int* ire, int* imodul, int* ifcver, int* ierror, const char*, int*) {
    const int code = answer("cntc_initialize", [&] {
        require(ierror, "ierror");
        const int module = integer(imodul, "imodul");
        Registry::of_process().initialize(number_of(ire), module);
        if (module != module_number::basic_contact && module != module_number::wheel_rail &&
            module != module_number::wheel_rail_inputs)
            throw Refused(error_code::other,
                          "Module " + std::to_string(module) +
                              " is not supported; use 1 or 11 for wheel-rail contact, or 3 for basic contact.");
    });
    if (ifcver != nullptr) *ifcver = interface_version;
    if (ierror != nullptr) *ierror = code;
}
CONTACTD_FORTRAN_NAME(cntc_initialize)

// The library opens no files and creates no threads: it solves in the calling thread.
extern "C" void cntc_setfileunits(int* nunits, int* iunits) {
    answer("cntc_setfileunits", [&] { integers(iunits, nunits, 0, "iunits"); });
}
CONTACTD_FORTRAN_NAME(cntc_setfileunits)

extern "C" void cntc_getmaxnumthreads(int* mxthrd) {
    answer("cntc_getmaxnumthreads", [&] {
        require(mxthrd, "mxthrd");
        *mxthrd = 1;
    });
}
CONTACTD_FORTRAN_NAME(cntc_getmaxnumthreads)

extern "C" void cntc_finalize(int* ire) {
    answer("cntc_finalize", [&] { Registry::of_process().finalize(number_of(ire)); });
}
CONTACTD_FORTRAN_NAME(cntc_finalize)

extern "C" void cntc_finalizelast(void) {
    answer("cntc_finalizelast", [] { Registry::of_process().finalize_all(); });
}
CONTACTD_FORTRAN_NAME(cntc_finalizelast)
