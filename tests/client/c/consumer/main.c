/* Uses the installed library, and succeeds if the library reports that no daemon listens. */
#include <contactd.h>
#include <contactd/paths.h>

int main(void) {
    contactd_connection* connection;
    if (contactd_open("tcp://127.0.0.1:1", &connection) != CONTACTD_OK) return 1;
    if (contactd_set_connect_timeout(connection, 0.05) != CONTACTD_OK) return 2;
    if (contactd_ping(connection) != CONTACTD_UNAVAILABLE) return 3;
    return contactd_close(connection) == CONTACTD_OK ? 0 : 4;
}
