// Windows calls this when it loads one of the DLLs: they are refused where the processor lacks what they are compiled
// for, before anything of theirs runs into it.
#define WIN32_LEAN_AND_MEAN
#include <stdio.h>
#include <windows.h>

BOOL WINAPI DllMain(HINSTANCE library, DWORD reason, LPVOID reserved);

BOOL WINAPI DllMain(HINSTANCE library, DWORD reason, LPVOID reserved) {
    (void)library;
    (void)reserved;
    if (reason != DLL_PROCESS_ATTACH) return TRUE;
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return TRUE;
    fputs("contactd needs a processor with AVX2 and FMA.\n", stderr);
    return FALSE;
}
