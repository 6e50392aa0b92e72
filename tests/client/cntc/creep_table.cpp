// Prints the table of creep_table.hpp, a line each, by the functions of libcontactd-cntc.
//
//     ./dev shell cmake --build build/development --target creep_table
//     ./dev shell build/development/bin/creep_table
#include "client/cntc/creep_table.hpp"

#include <cstdio>

int main() {
    using namespace contactd::cntc::test;
    CreepTable table(1);
    int failed = 0;
    CreepTable::for_each([&](const CreepCase& k) {
        const CreepLine line = table.solve(k);
        failed += line.error != 0;
        std::printf("Fx=%11.6f, Fy=%11.6f, Mz=%11.6f, %%Slip=%6.1f\n", line.fx, line.fy, line.mz, line.slip);
    });
    cntc_finalizelast();
    if (failed > 0) std::fprintf(stderr, "%d lines have an error.\n", failed);
    return failed > 0 ? 1 : 0;
}
