/* Replaces the part of MBDyn's libmbc that wheelset_peer.c calls, with the declarations of its header mbc.h. Motions
 * come from a file, one per line: x[3], rotation[9] by columns, velocity[3], angular velocity[3]. Forces and moments
 * are printed, one line each. MBDyn is not among the packages. */
#ifndef MBC_H
#define MBC_H

#include <stdint.h>
#include <stdio.h>

typedef struct {
    int data_and_next, timeout;
} mbc_t;

typedef struct {
    mbc_t mbc;
    double x[3], r[9], xp[3], omega[3], f[3], m[3];
} mbc_nodal_t;

enum { MBC_ROT_MAT = 1 };

#define MBC_N_X(mbc) ((mbc)->x)
#define MBC_N_R(mbc) ((mbc)->r)
#define MBC_N_XP(mbc) ((mbc)->xp)
#define MBC_N_OMEGA(mbc) ((mbc)->omega)
#define MBC_N_F(mbc) ((mbc)->f)
#define MBC_N_M(mbc) ((mbc)->m)

static FILE* motions;

static int mbc_unix_init(mbc_t* mbc, const char* path) {
    motions = mbc->data_and_next ? fopen(path, "r") : NULL;
    return motions == NULL;
}
static int mbc_nodal_init(mbc_nodal_t* mbc, unsigned refnode, unsigned nodes, unsigned labels, unsigned rot,
                          unsigned accels) {
    (void)mbc;
    return refnode || nodes != 1 || labels || rot != MBC_ROT_MAT || accels;
}
static int mbc_nodal_negotiate_request(mbc_nodal_t* mbc) {
    (void)mbc;
    return 0;
}
static int mbc_numbers(double* values, int count) {
    for (int k = 0; k < count; ++k)
        if (fscanf(motions, "%lf", &values[k]) != 1) return 1;
    return 0;
}
static int mbc_nodal_get_motion(mbc_nodal_t* mbc) {
    return mbc_numbers(mbc->x, 3) || mbc_numbers(mbc->r, 9) || mbc_numbers(mbc->xp, 3) || mbc_numbers(mbc->omega, 3);
}
static int mbc_nodal_put_forces(mbc_nodal_t* mbc, int last) {
    printf("%.17g %.17g %.17g %.17g %.17g %.17g\n", mbc->f[0], mbc->f[1], mbc->f[2], mbc->m[0], mbc->m[1], mbc->m[2]);
    return !last;
}
static int mbc_nodal_destroy(mbc_nodal_t* mbc) {
    (void)mbc;
    if (motions) fclose(motions);
    return 0;
}

#endif
