/*
 * The cases of cases.py, in a file, through contactd.h: where they are solved is what this is told, and what it is
 * linked with.
 *
 *     congruence-c ipc:///run/contactd.sock cases.txt        congruence-c-local local cases.txt
 *
 * A line for each start, step and restore; telling.py says what stands in it.
 */
#include "answers.h"
#include "words.h"

enum { most_states = 10 };

static contactd_contact* contact;
static int32_t nx, ny;
static int32_t states[most_states];

/* The place of a word in a list. */
static int32_t word(int i, const char* list[]) {
    for (int32_t n = 0; i < count && list[n] != NULL; ++n)
        if (strcmp(words[i], list[n]) == 0) return n;
    fprintf(stderr, "%s: %s has no such word\n", name, words[0]);
    exit(2);
}

/* --- what a line says ---------------------------------------------------------------------------------------- */

static int32_t body(int i) {
    const char* bodies[] = {"upper", "lower", "both", "pair", NULL};
    return word(i, bodies);
}

/* "base scale step period": base + scale ((step i) mod period), exactly. */
static double* ramp(int i) {
    double* made = values(nx * ny);
    for (int32_t n = 0; n < nx * ny; ++n) made[n] = number(i) + number(i + 1) * (n * whole(i + 2) % whole(i + 3));
    return made;
}

/* A bowl around the middle of the grid, the same in both directions. */
static double* bowl(double scale) {
    double* made = values(nx * ny);
    for (int32_t y = 0; y < ny; ++y)
        for (int32_t x = 0; x < nx; ++x) {
            const int32_t across = 2 * x - nx + 1, along = 2 * y - ny + 1;
            made[y * nx + x] = scale * (across * across + along * along);
        }
    return made;
}

/* xx, yy and zz that fall by four with each offset, and nothing else. */
static double* table(int32_t columns, int32_t rows, double origin) {
    double* made = values(9 * columns * rows);
    for (int32_t axis = 0; axis < 3; ++axis)
        for (int32_t y = 0; y < rows; ++y)
            for (int32_t x = 0; x < columns; ++x)
                made[(4 * axis * rows + y) * columns + x] = ldexp(origin, -2 * (x + y));
    return made;
}

/* --- setters ------------------------------------------------------------------------------------------------- */

static int32_t with(double* x, double* y, double* z) {
    int32_t code;
    if (is("gap") || is("gap_of"))
        code = contactd_set_gap(contact, x, is("gap") ? nx * ny : whole(1));
    else if (is("mu_array"))
        code = contactd_set_mu_array(contact, x, nx * ny);
    else if (is("rigid_slip"))
        code = contactd_set_rigid_slip(contact, x, y, nx * ny);
    else if (is("previous"))
        code = contactd_set_previous(contact, x, y, z, nx * ny);
    else
        code =
            contactd_set_table(contact, body(1), whole(2), whole(3), number(4), number(5), x, 9 * whole(2) * whole(3));
    free(x);
    free(y);
    free(z);
    return code;
}

/* "body shape base_G base_nu", and "thickness G nu" of each layer. */
static int32_t layers(int32_t shape) {
    double thickness[most_words], G[most_words], nu[most_words];
    int32_t layer = 0;
    for (; 5 + 3 * layer < count; ++layer) {
        thickness[layer] = number(5 + 3 * layer);
        G[layer] = number(6 + 3 * layer);
        nu[layer] = number(7 + 3 * layer);
    }
    return contactd_set_layers(contact, body(1), shape, thickness, G, nu, layer, number(3), number(4));
}

static int32_t set_up(void) {
    const char* shapes[] = {"constant", "bilinear", NULL};
    const char* models[] = {"full", "hertz", "fastsim", NULL};
    const char* solvers[] = {"normal", "tangential", "outer", NULL};
    if (is("grid")) {
        nx = whole(1);
        ny = whole(2);
        return contactd_set_grid(contact, nx, ny, number(3), number(4), number(5), number(6));
    }
    if (is("material")) return contactd_set_material(contact, body(1), number(2), number(3));
    if (is("rigid")) return contactd_set_rigid(contact, body(1));
    if (is("half_space")) return contactd_set_half_space(contact, body(1), word(2, shapes));
    if (is("layers")) return layers(word(2, shapes));
    if (is("fem")) return contactd_set_fem(contact, body(1), CONTACTD_HALF_SPACE, CONTACTD_CONSTANT, number(2), 0);
    if (is("table")) return with(table(whole(2), whole(3), number(6)), NULL, NULL);
    if (is("line_contact")) return contactd_set_line_contact(contact, number(1));
    if (is("model")) return contactd_set_model(contact, word(1, models));
    if (is("tolerance")) return contactd_set_tolerance(contact, word(1, solvers), number(2), whole(3));
    if (is("accept_unconverged")) return contactd_set_accept_unconverged(contact, 1);
    if (is("lease")) return contactd_set_lease(contact, number(1));
    if (is("previous")) return with(ramp(1), ramp(5), ramp(9));
    return -1;
}

#include "sections.h"

static int32_t load(void) {
    const char* laws[] = {"linear", "exponential", NULL};
    const char* kinds[] = {"steady", "transient", NULL};
    if (is("approach")) return contactd_set_approach(contact, number(1));
    if (is("Fn")) return contactd_set_Fn(contact, number(1));
    if (is("paraboloid")) return contactd_set_paraboloid(contact, number(1), number(2));
    if (is("semi_axes")) return contactd_set_semi_axes(contact, number(1), number(2));
    if (is("gap")) return with(bowl(number(1)), NULL, NULL);
    if (is("gap_of")) return with(values(whole(1)), NULL, NULL);
    if (is("mu")) return contactd_set_mu(contact, number(1));
    if (is("mu_array")) return with(ramp(1), NULL, NULL);
    if (is("kinetic")) return contactd_set_kinetic(contact, word(1, laws), number(2), number(3));
    if (is("shift")) return contactd_set_shift(contact, number(1), number(2), number(3));
    if (is("duration")) return contactd_set_duration(contact, number(1));
    if (is("rolling")) return contactd_set_rolling(contact, word(1, kinds), number(2), number(3), number(4));
    if (is("direction")) return contactd_set_direction(contact, number(1), number(2));
    if (is("spin_offset")) return contactd_set_spin_offset(contact, number(1));
    if (is("rolling_steps")) return contactd_set_rolling_steps(contact, whole(1));
    if (is("velocity")) return contactd_set_velocity(contact, number(1));
    if (is("Fx")) return contactd_set_Fx(contact, number(1));
    if (is("Fy")) return contactd_set_Fy(contact, number(1));
    if (is("clear_forces")) return contactd_clear_forces(contact);
    if (is("rigid_slip")) return with(ramp(1), ramp(5), NULL);
    if (is("derivatives")) return contactd_want_derivatives(contact, whole(1));
    return -1;
}

/* The line of a call; one that a setter has refused for is not made. */
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
        tell_step(contact, nx * ny);
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
    if (is("case")) {
        next_case();
    } else if (is("start") || is("step") || is("again") || is("save") || is("restore") || is("forget")) {
        call();
    } else {
        int32_t code = set_up();
        if (code == -1) code = set_section();
        if (code == -1) code = load();
        note_setter(contact, code);
    }
}

int main(int arguments, char** argument) {
    const int status = read_cases(arguments, argument, take);
    if (status != 0) return status;
    if (contact != NULL) contactd_free(contact);
    return contactd_close(place) == CONTACTD_OK ? 0 : 3;
}
