/* Binds functions of Debian 13's glibc to their older versions, because the newer versions differ in side effects only.
 * The module then also loads with an older glibc, from 2.35 on, which the unwinding of exceptions requires. Code linked
 * into the module finds these functions before those of the library; they are not visible outside.
 *
 * fmod 2.38 and hypot 2.35 no longer set errno by a wrapper. The others are strtol, sscanf and similar functions with
 * the rules of C23, which also read "0b1"; a C++20 program requires the old rules. Compiled as C11, this file names the
 * older ones. strlcpy was added in 2.38 and arc4random in 2.36: ZeroMQ and std::random_device require them, in FMUs. */
#undef _GNU_SOURCE
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>

#define HERE __attribute__((visibility("hidden")))

/* Names the first version of glibc for this processor. */
#ifdef __aarch64__
#define FIRST "GLIBC_2.17"
#else
#define FIRST "GLIBC_2.2.5"
#endif

double first_fmod(double x, double y);
__asm__(".symver first_fmod, fmod@" FIRST);
HERE double fmod(double x, double y) { return first_fmod(x, y); }

double first_hypot(double x, double y);
__asm__(".symver first_hypot, hypot@" FIRST);
HERE double hypot(double x, double y) { return first_hypot(x, y); }

HERE long __isoc23_strtol(const char* text, char** end, int base) { return strtol(text, end, base); }
HERE unsigned long __isoc23_strtoul(const char* text, char** end, int base) { return strtoul(text, end, base); }
HERE long long __isoc23_strtoll(const char* text, char** end, int base) { return strtoll(text, end, base); }
HERE unsigned long long __isoc23_strtoull(const char* text, char** end, int base) { return strtoull(text, end, base); }

HERE int __isoc23_sscanf(const char* text, const char* format, ...) {
    va_list values;
    va_start(values, format);
    const int count = vsscanf(text, format, values);
    va_end(values);
    return count;
}

HERE size_t strlcpy(char* to, const char* from, size_t size) {
    const size_t length = strlen(from);
    if (size > 0) {
        const size_t copied = length < size ? length : size - 1;
        memcpy(to, from, copied);
        to[copied] = '\0';
    }
    return length;
}

HERE uint32_t arc4random(void) {
    uint32_t value = 0;
    while (getrandom(&value, sizeof value, 0) != (ssize_t)sizeof value) {
    }
    return value;
}
