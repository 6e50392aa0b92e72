/*
 * Runs the cases written by paths.py, in a file, through contactd.h. The arguments and the linked library determine
 * where they are solved.
 *
 *     congruence-c ipc:///run/contactd.sock cases.txt        congruence-c-local local cases.txt
 *
 * Prints a line for each start, step and restore; telling.py defines its contents.
 */
#include "answers.h"
#include "words.h"

enum { most_states = 10, most_rows = 64 };

static contactd_contact* contact;
static int32_t states[most_states];

/* Returns words from i on as numbers. */
static const double* numbers(int i) {
    static double made[most_words];
    for (int n = i; n < count; ++n) made[n - i] = number(n);
    return made;
}

/* Reads "ny direction y z": contact on the columns of the lower body's section. */
static int32_t set_columns(void) {
    double y[most_rows], z[most_rows], angle[most_rows], frames[3 * most_rows];
    const int32_t rows = whole(1);
    int32_t code = contactd_get_frames(contact, "lower", y, z, angle, rows);
    if (code != CONTACTD_OK) return code;
    for (int32_t row = 0; row < rows; ++row) {
        frames[3 * row] = y[row];
        frames[3 * row + 1] = z[row];
        frames[3 * row + 2] = angle[row];
    }
    code = contactd_set_array(contact, "columns.frames", frames, 3 * rows);
    if (code == CONTACTD_OK) code = contactd_set(contact, "columns.direction", number(2));
    return code == CONTACTD_OK ? contactd_set_array(contact, "columns.origin", numbers(3), 2) : code;
}

static int32_t set(void) {
    if (is("set")) return contactd_set(contact, words[1], number(2));
    if (is("word")) return contactd_set_word(contact, words[1], words[2]);
    if (is("clear")) return contactd_clear(contact, words[1]);
    if (is("array")) return contactd_set_array(contact, words[1], numbers(2), count - 2);
    if (is("columns")) return set_columns();
    if (is("table"))
        return contactd_set_table(contact, words[1], whole(2), whole(3), number(4), number(5), numbers(6), count - 6);
    return -1;
}

/* Prints the line of a call, which is not made if a setter has refused a value for it. */
static void call(void) {
    printf("%s %s", name, words[0]);
    if (refused == CONTACTD_OK) {
        if (is("start")) note(contact, contactd_start(contact));
        if (is("step")) note(contact, contactd_step(contact));
        if (is("again")) note(contact, contactd_step_again(contact));
        if (is("save")) note(contact, contactd_save(contact, &states[whole(1)]));
        if (is("restore")) note(contact, contactd_restore(contact, states[whole(1)]));
        if (is("forget")) note(contact, contactd_forget(contact, states[whole(1)]));
    }
    if (refused != CONTACTD_OK)
        printf(" refused %" PRId32 " %s %s", refused, reason, field);
    else if (is("step") || is("again"))
        tell_step(contact);
    printf("\n");
    refused = CONTACTD_OK;
}

static void next_case(void) {
    if (contact != NULL) contactd_free(contact);
    if (contactd_new(place, &contact) != CONTACTD_OK) exit(3);
    refused = CONTACTD_OK;
    snprintf(name, sizeof name, "%s", words[1]);
    for (int which = 0; which < contact_arrays; ++which) contactd_want(contact, arrays[which], 1);
}

static void take(void) {
    if (is("case"))
        next_case();
    else if (is("start") || is("step") || is("again") || is("save") || is("restore") || is("forget"))
        call();
    else
        note_setter(contact, set());
}

int main(int arguments, char** argument) {
    const int status = read_cases(arguments, argument, take);
    if (status != 0) return status;
    if (contact != NULL) contactd_free(contact);
    return contactd_close(place) == CONTACTD_OK ? 0 : 3;
}
