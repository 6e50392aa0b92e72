// Windows calls this when it loads one of the DLLs. It refuses to load them if the processor lacks the instruction set
// for which they are compiled, before any such instruction runs.
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
