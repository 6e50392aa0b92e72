/* The header is C99, without headers before it. Handles as unions would exempt it from pedantic warnings. */
#define CONTACTD_UNTYPED_HANDLES
#include "contactd.h"

/* Checks the declarations with a C compiler. */
int words_in_c(void);
int words_in_c(void) {
    return CONTACTD_SLIP + (int)sizeof(contactd_log) * 0;
}
