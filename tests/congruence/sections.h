/* Cross-sections and curved columns, for driver.c, whose words they are. */
#ifndef SECTIONS_H
#define SECTIONS_H

enum { most_numbers = 20, most_rows = 64, half_width = 34 };

static int32_t section(void) {
    const char* shapes[] = {"outline",   "rail_60e1", "rim_s1002",  "edge_block", "groove",
                            "round_end", "disc",      "plate_hole", "slab",       NULL};
    double numbers[most_numbers];
    for (int i = 3; i < count; ++i) numbers[i - 3] = number(i);
    return contactd_set_section(contact, body(1), word(2, shapes), numbers, count - 3);
}

/* "body clamped y z y z ..." */
static int32_t spline(void) {
    double y[most_numbers], z[most_numbers];
    int32_t points = 0;
    for (; 4 + 2 * points < count; ++points) {
        y[points] = number(3 + 2 * points);
        z[points] = number(4 + 2 * points);
    }
    return contactd_add_spline(contact, body(1), y, z, points, whole(2));
}

/* "body kind curvature smoothing depth from": a parabola. */
static int32_t profile(void) {
    double y[2 * half_width + 1], z[2 * half_width + 1];
    const char* kinds[] = {"wheel", "rail", NULL};
    for (int32_t i = -half_width; i <= half_width; ++i) {
        y[i + half_width] = i;
        z[i + half_width] = i * i * number(3);
    }
    return contactd_set_profile_points(contact, body(1), word(2, kinds), y, z, 2 * half_width + 1, number(4), number(5),
                                       number(6));
}

/* "direction origin": those of the lower body's section, or of a plane. */
static int32_t columns(void) {
    double y[most_rows], z[most_rows] = {0}, angle[most_rows] = {0};
    int32_t code = CONTACTD_OK, row;
    for (row = 0; row < ny; ++row) y[row] = row;
    if (is("columns")) code = contactd_get_frames(contact, CONTACTD_LOWER, y, z, angle, ny);
    if (code != CONTACTD_OK) return code;
    return contactd_set_columns(contact, y, z, angle, ny, number(1), number(2), number(3));
}

static int32_t set_section(void) {
    if (is("section")) return section();
    if (is("section_place")) return contactd_set_section_place(contact, body(1), number(2), number(3));
    if (is("section_accuracy")) return contactd_set_section_accuracy(contact, body(1), number(2));
    if (is("outline")) return contactd_set_outline(contact, body(1), number(2), number(3));
    if (is("line")) return contactd_add_line(contact, body(1), number(2), number(3), whole(4));
    if (is("arc")) return contactd_add_arc(contact, body(1), number(2), number(3), number(4), whole(5));
    if (is("spline")) return spline();
    if (is("hole")) return contactd_add_hole(contact, body(1), number(2), number(3));
    if (is("first_column")) return contactd_set_first_column(contact, body(1), whole(2), whole(3), number(4));
    if (is("profile")) return profile();
    if (is("columns") || is("flat_columns")) return columns();
    return -1;
}

#endif
