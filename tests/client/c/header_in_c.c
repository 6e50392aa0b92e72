/* The header is C99, with nothing before it. */
#include "contactd.h"

/* What a C compiler makes of the words. */
int words_in_c(void);
int words_in_c(void) {
    return CONTACTD_SLIP + (int)sizeof(contactd_log) * 0;
}
