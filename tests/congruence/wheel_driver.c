/*
 * Runs the cases of wheel_cases.py, in a file, through contactd.h. The arguments and the linked library determine where
 * they are solved.
 *
 *     congruence-wheel-c ipc:///run/contactd.sock cases.txt        congruence-wheel-c-local local cases.txt
 *
 * Prints a line for each solve; wheel_telling.py defines its contents.
 */
#include "wheel_answers.h"
#include "words.h"

static contactd_wheel* wheel;

/* What a slice takes over: the line that set the profile of wheel and rail last; and the slices that there are. */
static char profiles[2][1000];
static int slices[2];

/* --- what a line says ---------------------------------------------------------------------------------------- */

/* Sets the next of these paths to the number after each word. */
static const struct {
    const char *word, *paths[6];
} numbers[] = {
    {"track", {"setup.track.gauge", "setup.track.gauge_height", "setup.track.cant"}},
    {"rail_origin", {"setup.track.rail_origin.y", "setup.track.rail_origin.z"}},
    {"roller", {"setup.track.roller_radius"}},
    {"wheelset",
     {"setup.wheelset.flange_back_distance", "setup.wheelset.flange_back_position", "setup.wheelset.nominal_radius"}},
    {"mu", {"setup.friction.mu"}},
    {"elements", {"setup.dx", "setup.dy", "setup.dq"}},
    {"patch_rules",
     {"setup.patches.angle_separate", "setup.patches.distance_separate", "setup.patches.distance_combine",
      "setup.patches.distance_turn", "setup.patches.locus_step"}},
    {"position", {"state.position.y", "state.position.z", "state.position.roll", "state.position.yaw"}},
    {"x", {"state.position.x"}},
    {"pitch_angle", {"state.position.pitch"}},
    {"velocity",
     {"state.velocity.x", "state.velocity.y", "state.velocity.z", "state.velocity.roll", "state.velocity.yaw",
      "state.velocity.pitch"}},
    {"deviation", {"state.rail.y", "state.rail.z", "state.rail.roll"}},
    {"deviation_rate", {"state.rail.y_velocity", "state.rail.z_velocity", "state.rail.roll_velocity"}},
    {"rail_forces", {"state.rail.Fy", "state.rail.Fz"}},
    {"roller_pitch", {"state.roller_pitch"}},
    {"Fz", {"state.Fz"}},
    {"Fx", {"state.Fx"}},
    {"derivatives", {"state.derivatives"}},
};

static const struct {
    const char *word, *path, *zero, *one; /* where the line has 0 or 1 */
} keywords[] = {
    {"side", "setup.side", NULL, NULL},
    {"model", "setup.model", NULL, NULL},
    {"conformal", "setup.conformal", NULL, NULL},
    {"bilinear", "setup.wheel_surface", "exact", "bilinear"},
    {"slip_of_surfaces", "setup.rigid_slip", "plane", "surfaces"},
    {"mesh_search", "setup.patches.search", "locus", "mesh"},
};

/* Sets or reads the field below `prefix`. */
static int32_t set_below(const char* prefix, const char* field_name, double value) {
    char path[200];
    snprintf(path, sizeof path, "%s.%s", prefix, field_name);
    return contactd_set(wheel, path, value);
}

static int32_t first(int32_t code, int32_t next) {
    return code != CONTACTD_OK ? code : next;
}

/* Returns the count of words from i on that are numbers. */
static int32_t all_numbers(int i, double* made) {
    int32_t n = 0;
    for (; i < count; ++i) made[n++] = number(i);
    return n;
}

static int32_t set_numbers(const char* path, int i) {
    double made[most_words];
    return contactd_set_array(wheel, path, made, all_numbers(i, made));
}

/* --- setters ------------------------------------------------------------------------------------------------- */

static const char* body(int i) {
    return strcmp(words[i], "wheel") == 0 ? "setup.bodies.lower" : "setup.bodies.upper";
}

/* Sets the profile at `path` from the line; returns -1 if the line is not a profile. */
static int32_t set_profile_at(const char* path) {
    char field_name[200];
    int32_t code;
    if (is("rail_60e1")) return set_below(path, "rail_60e1.inclination", number(1));
    if (is("points")) {
        snprintf(field_name, sizeof field_name, "%s.points", path);
        return set_numbers(field_name, 2);
    }
    if (!is("arc") && !is("cone")) return -1;
    code = is("arc") ? set_below(path, "arc.radius", number(2)) : CONTACTD_OK;
    snprintf(field_name, sizeof field_name, "%s.slope", words[0]);
    code = first(code, set_below(path, field_name, number(count - 3)));
    snprintf(field_name, sizeof field_name, "%s.%s.ends", path, words[0]);
    return first(code, set_numbers(field_name, count - 2));
}

static int32_t set_profile(void) {
    const int of_rail = is("rail_60e1") || (count > 1 && strcmp(words[1], "rail") == 0);
    const int32_t code = set_profile_at(of_rail ? "setup.rail" : "setup.wheel");
    char* kept = profiles[of_rail];
    if (code == -1) return -1;
    *kept = '\0';
    for (int i = 0; i < count; ++i) strcat(strcat(kept, words[i]), " ");
    return code;
}

static int32_t add_slice(int of_rail) {
    char path[100];
    int32_t code;
    snprintf(path, sizeof path, "setup.%s_slices[%d]", of_rail ? "rail" : "wheel", slices[of_rail]++);
    code = set_below(path, of_rail ? "x" : "angle", number(1));
    if (code != CONTACTD_OK || profiles[of_rail][0] == '\0') return code;
    strcat(path, ".profile");
    char line[sizeof profiles[0]];
    strcpy(line, profiles[of_rail]);
    split(line);
    return set_profile_at(path);
}

static int32_t clear_wheel_slices(void) {
    slices[0] = 0;
    return contactd_clear(wheel, "setup.wheel_slices");
}

static int32_t set_springs(void) {
    int32_t code = contactd_clear(wheel, "setup.track.springs");
    if (number(1) != 0) code = first(code, contactd_set(wheel, "setup.track.springs.y", number(1)));
    if (number(2) != 0) code = first(code, contactd_set(wheel, "setup.track.springs.z", number(2)));
    return code;
}

static int32_t set_tolerance(void) {
    const char* above = strcmp(words[1], "force") == 0 ? "setup" : "setup.settings";
    char path[100];
    snprintf(path, sizeof path, "%s.%s", above, words[1]);
    return first(set_below(path, "tolerance", number(2)), set_below(path, "max_iterations", whole(3)));
}

static int32_t set_up(void) {
    if (is("springs")) return set_springs();
    if (is("material")) return first(set_below(body(1), "G", number(2)), set_below(body(1), "nu", number(3)));
    if (is("rigid")) return set_below(body(1), "rigid", 1);
    if (is("mu_by_angle"))
        return first(set_numbers("setup.friction.mu", 2),
                     contactd_set(wheel, "setup.friction.along_profile", number(1)));
    if (is("kinetic"))
        return first(first(contactd_set_word(wheel, "setup.friction.kinetic.law", words[1]),
                           contactd_set(wheel, "setup.friction.kinetic.mu", number(2))),
                     contactd_set(wheel, "setup.friction.kinetic.slip_velocity", number(3)));
    if (is("frictionless")) return contactd_clear(wheel, "setup.friction");
    if (is("clear_forces")) return first(contactd_clear(wheel, "state.Fz"), contactd_clear(wheel, "state.Fx"));
    if (is("tolerance")) return set_tolerance();
    if (is("add_slice")) return add_slice(1);
    if (is("add_wheel_slice")) return add_slice(0);
    if (is("clear_wheel_slices")) return clear_wheel_slices();
    return set_profile();
}

static int32_t set(void) {
    int32_t code = CONTACTD_OK;
    for (size_t k = 0; k < sizeof keywords / sizeof keywords[0]; ++k)
        if (is(keywords[k].word)) {
            const char* word = keywords[k].zero == NULL ? words[1] : whole(1) != 0 ? keywords[k].one : keywords[k].zero;
            return contactd_set_word(wheel, keywords[k].path, word);
        }
    for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; ++k) {
        if (!is(numbers[k].word)) continue;
        for (int i = 0; i < 6 && numbers[k].paths[i] != NULL; ++i)
            code = first(code, contactd_set(wheel, numbers[k].paths[i], number(i + 1)));
        return code;
    }
    return set_up();
}

static void solve(void) {
    printf("%s solve", name);
    if (refused == CONTACTD_OK) note(wheel, contactd_step_again(wheel));
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
    for (int which = 0; which < wheel_arrays; ++which) contactd_want(wheel, arrays[which], 1);
    profiles[0][0] = profiles[1][0] = '\0';
    slices[0] = slices[1] = 0;
}

static void take(void) {
    if (is("case")) {
        next_case();
    } else if (is("solve")) {
        solve();
    } else {
        note_setter(wheel, set());
    }
}

int main(int arguments, char** argument) {
    const int status = read_cases(arguments, argument, take);
    if (status != 0) return status;
    if (wheel != NULL) contactd_wheel_free(wheel);
    return contactd_close(place) == CONTACTD_OK ? 0 : 3;
}
