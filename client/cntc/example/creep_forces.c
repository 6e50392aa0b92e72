/* Forces of a steel wheel on a rail for some creepages, by the functions of the CONTACT program's library.
 *
 *     cc creep_forces.c $(pkg-config --cflags --libs contactd-cntc) -o creep_forces */
#include <contactd_cntc.h>
#include <stdio.h>

int main(void) {
    int ire = 1, icp = 1; /* the result element and its contact problem */
    int module = 3, version, error, length = 0;
    cntc_initialize(&ire, &module, &version, &error, "", &length);
    if (error != 0) return 1;

    /* 1. What to solve: mm and N, forces on the wheel (body 1); steady rolling. */
    int flags = 2, codes[] = {1933, 1972}, values[] = {1934, 3};
    cntc_setflags(&ire, &icp, &flags, codes, values);

    /* 2. Steel on steel, friction 0.3, semi-axes 6 x 4 mm under 50 kN. */
    int elastic = 0, coulomb = 0, semi_axes = -3, two = 2, four = 4, five = 5;
    double steel[] = {0.28, 0.28, 82000, 82000}, friction[] = {0.3, 0.3}, ellipse[] = {25, 25, 6, 4, 1.1};
    double fn = 50000;
    cntc_setmaterialparameters(&ire, &icp, &elastic, &four, steel);
    cntc_setfrictionmethod(&ire, &icp, &coulomb, &two, friction);
    cntc_sethertzcontact(&ire, &icp, &semi_axes, &five, ellipse);
    cntc_setnormalforce(&ire, &icp, &fn);

    /* 3. Each creepage is a solve; the operators are kept. */
    for (int k = 1; k <= 4; ++k) {
        double vx = 5e-4 * k, vy = 0.001, phi = 1e-4, fx, fy, mz;
        cntc_setcreepages(&ire, &icp, &vx, &vy, &phi);
        cntc_calculate(&ire, &icp, &error);
        if (error < 0) {
            fprintf(stderr, "%s\n", contactd_cntc_last_error(NULL));
            return 1;
        }
        cntc_getcontactforces(&ire, &icp, &fn, &fx, &fy, &mz);
        printf("creepage %.4f: Fx %8.1f N, Fy %8.1f N, Mz %7.1f N mm\n", vx, fx, fy, mz);
    }
    cntc_finalize(&ire);
    cntc_finalizelast();
    return 0;
}
