/* Computes the forces on a wheelset's wheels for MBDyn in a separate process. MBDyn's "external structural" force, with
 * one node, orientation matrices and loose coupling, sends it a motion in each step through a socket of libmbc.
 *
 *     export PKG="$(pkg-config --cflags --libs contactd-local)"
 *     cc -std=c99 -o wheelset_peer wheelset_peer.c -I../multibody $PKG -lmbc -lm
 *     ./wheelset_peer /tmp/mbdyn.sock local fastsim 0.3 0.001
 *
 * The arguments are the path of the socket, where contacts are solved, the model, the friction coefficient, and the
 * size of elements (m). The node is the wheelset's centre. Its coordinates are those of contactd_wheelset.h: x
 * forwards, y to the right, z down. The forces and moments have the same axes, in N and N m. The exit status is 0 when
 * MBDyn has ended, and 1 after a failure. */
#include "contactd_wheelset.h"

#include <mbc.h>
#include <stdio.h>
#include <stdlib.h>

static int failed(const char* what) {
    fprintf(stderr, "wheelset_peer: %s\n", what);
    return 1;
}

static int follow(mbc_nodal_t* mbc, contactd_wheelset* wheels) {
    while (mbc_nodal_get_motion(mbc) == 0) {
        const double* by_columns = MBC_N_R(mbc);
        double rotation[9];
        for (int k = 0; k < 9; ++k) rotation[k] = by_columns[3 * (k % 3) + k / 3];
        if (contactd_wheelset_solve(wheels, MBC_N_X(mbc), rotation, MBC_N_XP(mbc), MBC_N_OMEGA(mbc), MBC_N_F(mbc),
                                    MBC_N_M(mbc)) != CONTACTD_OK)
            return failed(contactd_last_error(NULL));
        if (mbc_nodal_put_forces(mbc, 1)) return failed("MBDyn takes no forces any more");
    }
    return 0;
}

int main(int count, char** arguments) {
    if (count != 6) return failed("takes SOCKET WHERE MODEL FRICTION ELEMENT");
    contactd_wheelset wheels;
    if (contactd_wheelset_open(&wheels, arguments[2], arguments[3], atof(arguments[4]), atof(arguments[5])) !=
        CONTACTD_OK)
        return failed(contactd_last_error(NULL));
    mbc_nodal_t mbc = {0};
    mbc.mbc.data_and_next = 1; /* sends the forces and ends the step */
    mbc.mbc.timeout = -1;
    int status = 1;
    if (mbc_unix_init((mbc_t*)&mbc, arguments[1]))
        failed("no program listens at the socket");
    else if (mbc_nodal_init(&mbc, 0, 1, 0, MBC_ROT_MAT, 0) || mbc_nodal_negotiate_request(&mbc))
        failed("MBDyn has another idea of the nodes");
    else
        status = follow(&mbc, &wheels);
    mbc_nodal_destroy(&mbc);
    contactd_wheelset_close(&wheels);
    return status;
}
