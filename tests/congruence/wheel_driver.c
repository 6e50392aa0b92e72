/*
 * The cases of wheel_cases.py, in a file, through contactd.h: where they are solved is what this is told, and what it
 * is linked with.
 *
 *     congruence-wheel-c ipc:///run/contactd.sock cases.txt        congruence-wheel-c-local local cases.txt
 *
 * A line for each solve; wheel_telling.py says what stands in it.
 */
#include "wheel_answers.h"
#include "words.h"

static contactd_wheel* wheel;

/* --- what a line says ---------------------------------------------------------------------------------------- */

static int32_t body(int i) {
    const char* bodies[] = {"wheel", "rail", NULL};
    return word(i, bodies);
}

/* Words from i on, by turns to both lists; how many each has. */
static int32_t pairs(int i, double* first, double* second) {
    int32_t n = 0;
    for (; i + 1 < count; i += 2, ++n) {
        first[n] = number(i);
        second[n] = number(i + 1);
    }
    return n;
}

/* --- setters ------------------------------------------------------------------------------------------------- */

static int32_t set_profile(void) {
    double y[most_words], z[most_words];
    int32_t n;
    if (is("rail_60e1")) return contactd_wheel_set_rail_60e1(wheel, number(1));
    if (is("arc")) return contactd_wheel_set_arc(wheel, body(1), number(2), number(3), number(4), number(5));
    if (is("cone")) return contactd_wheel_set_cone(wheel, body(1), number(2), number(3), number(4));
    if (is("points")) {
        n = pairs(2, y, z);
        return contactd_wheel_set_points(wheel, body(1), y, z, n, 0);
    }
    if (is("add_slice")) return contactd_wheel_add_slice(wheel, number(1));
    if (is("add_wheel_slice")) return contactd_wheel_add_wheel_slice(wheel, number(1));
    if (is("clear_wheel_slices")) return contactd_wheel_clear_wheel_slices(wheel);
    return -1;
}

static int32_t set_up(void) {
    const char* sides[] = {"left", "right", NULL};
    const char* models[] = {"full", "hertz", "fastsim", NULL};
    const char* laws[] = {"linear", "exponential", NULL};
    const char* conformals[] = {"off", "half_space", "rotated", NULL};
    const char* solvers[] = {"normal", "tangential", "outer", "force", NULL};
    double angle[most_words], mu[most_words];
    int32_t n;
    if (is("side")) return contactd_wheel_set_side(wheel, word(1, sides));
    if (is("track")) return contactd_wheel_set_track(wheel, number(1), number(2), number(3));
    if (is("rail_origin")) return contactd_wheel_set_rail_origin(wheel, number(1), number(2));
    if (is("roller")) return contactd_wheel_set_roller(wheel, number(1));
    if (is("springs")) return contactd_wheel_set_springs(wheel, number(1), number(2));
    if (is("wheelset")) return contactd_wheel_set_wheelset(wheel, number(1), number(2), number(3));
    if (is("material")) return contactd_wheel_set_material(wheel, body(1), number(2), number(3));
    if (is("rigid")) return contactd_wheel_set_rigid(wheel, body(1));
    if (is("model")) return contactd_wheel_set_model(wheel, word(1, models));
    if (is("mu")) return contactd_wheel_set_mu(wheel, number(1));
    if (is("mu_by_angle")) {
        n = pairs(2, angle, mu);
        return contactd_wheel_set_mu_by_angle(wheel, angle, mu, n, whole(1));
    }
    if (is("kinetic")) return contactd_wheel_set_kinetic(wheel, word(1, laws), number(2), number(3));
    if (is("frictionless")) return contactd_wheel_set_frictionless(wheel);
    if (is("elements")) return contactd_wheel_set_elements(wheel, number(1), number(2), number(3));
    if (is("patch_rules"))
        return contactd_wheel_set_patch_rules(wheel, number(1), number(2), number(3), number(4), number(5));
    if (is("bilinear")) return contactd_wheel_set_bilinear(wheel, whole(1));
    if (is("slip_of_surfaces")) return contactd_wheel_set_slip_of_surfaces(wheel, whole(1));
    if (is("mesh_search")) return contactd_wheel_set_mesh_search(wheel, whole(1));
    if (is("conformal")) return contactd_wheel_set_conformal(wheel, word(1, conformals));
    if (is("tolerance")) return contactd_wheel_set_tolerance(wheel, word(1, solvers), number(2), whole(3));
    return set_profile();
}

static int32_t move(void) {
    if (is("position")) return contactd_wheel_set_position(wheel, number(1), number(2), number(3), number(4));
    if (is("x")) return contactd_wheel_set_x(wheel, number(1));
    if (is("pitch_angle")) return contactd_wheel_set_pitch_angle(wheel, number(1));
    if (is("velocity"))
        return contactd_wheel_set_velocity(wheel, number(1), number(2), number(3), number(4), number(5), number(6));
    if (is("deviation")) return contactd_wheel_set_deviation(wheel, number(1), number(2), number(3));
    if (is("deviation_rate")) return contactd_wheel_set_deviation_rate(wheel, number(1), number(2), number(3));
    if (is("rail_forces")) return contactd_wheel_set_rail_forces(wheel, number(1), number(2));
    if (is("roller_pitch")) return contactd_wheel_set_roller_pitch(wheel, number(1));
    if (is("Fz")) return contactd_wheel_set_Fz(wheel, number(1));
    if (is("Fx")) return contactd_wheel_set_Fx(wheel, number(1));
    if (is("clear_forces")) return contactd_wheel_clear_forces(wheel);
    if (is("derivatives")) return contactd_wheel_want_derivatives(wheel, whole(1));
    return -1;
}

static void solve(void) {
    printf("%s solve", name);
    if (refused == CONTACTD_OK) note(wheel, contactd_wheel_solve(wheel));
    if (refused != CONTACTD_OK)
        printf(" refused %" PRId32 " %s %s", refused, reason, field);
    else
        tell_wheel(wheel);
    printf("\n");
    refused = CONTACTD_OK;
}

static void next_case(void) {
    if (wheel != NULL) contactd_wheel_free(wheel);
    if (contactd_wheel_new(place, &wheel) != CONTACTD_OK) exit(3);
    refused = CONTACTD_OK;
    snprintf(name, sizeof name, "%s", words[1]);
    for (int32_t array = CONTACTD_DIVISION; array <= CONTACTD_GAP; ++array) contactd_wheel_want(wheel, array, 1);
}

static void take(void) {
    if (is("case")) {
        next_case();
    } else if (is("solve")) {
        solve();
    } else {
        int32_t code = set_up();
        if (code == -1) code = move();
        note_setter(wheel, code);
    }
}

int main(int arguments, char** argument) {
    const int status = read_cases(arguments, argument, take);
    if (status != 0) return status;
    if (wheel != NULL) contactd_wheel_free(wheel);
    return contactd_close(place) == CONTACTD_OK ? 0 : 3;
}
