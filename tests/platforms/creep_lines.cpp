// Prints the drop-in's table of creepages, 3220 lines with all digits, to compare platforms.
#include <cstdio>

#include "client/cntc/creep_table.hpp"

int main() {
    using namespace contactd::cntc::test;
    CreepTable table(1);
    int failed = 0;
    CreepTable::for_each([&](const CreepCase& k) {
        const CreepLine line = table.solve(k);
        failed += line.error != 0;
        std::printf("creepages %.17g %.17g %.17g %.17g\n", line.fx, line.fy, line.mz, line.slip);
    });
    cntc_finalizelast();
    return failed > 0 ? 1 : 0;
}
