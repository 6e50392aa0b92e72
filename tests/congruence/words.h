/* Reads the cases for both drivers in C: a line is a word and its arguments. */
#ifndef WORDS_H
#define WORDS_H

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contactd.h"

enum { most_words = 2000, longest_line = 65536 };

static contactd_connection* place;
static char name[100];  /* of the case */
static int32_t refused; /* result of a setter since the last line, which a step would not report */
static char reason[100], field[100];

static char* words[most_words];
static int count;

static int is(const char* word) {
    return strcmp(words[0], word) == 0;
}
static double number(int i) {
    return i < count ? strtod(words[i], NULL) : NAN;
}
static int32_t whole(int i) {
    return i < count ? (int32_t)strtol(words[i], NULL, 10) : -1;
}

static void note(const void* handle, int32_t code) {
    if (code == CONTACTD_OK || refused != CONTACTD_OK) return;
    refused = code;
    snprintf(reason, sizeof reason, "%s", contactd_last_reason(handle));
    snprintf(field, sizeof field, "%s", contactd_last_field(handle));
}

static void note_setter(const void* handle, int32_t code) {
    if (code == -1) {
        fprintf(stderr, "%s: there is no %s\n", name, words[0]);
        exit(2);
    }
    note(handle, code);
}

static void split(char* line) {
    count = 0;
    for (char* next = strtok(line, " \r\n"); next != NULL && count < most_words; next = strtok(NULL, " \r\n"))
        words[count++] = next;
}

/* Takes the arguments "WHERE CASES", opens the connection, and processes each line with a statement. */
static int read_cases(int arguments, char** argument, void (*take)(void)) {
    static char line[longest_line];
    FILE* cases = arguments == 3 ? fopen(argument[2], "r") : NULL;
    if (cases == NULL || contactd_open(argument[1], &place) != CONTACTD_OK) {
        fprintf(stderr, "usage: %s WHERE CASES\n", argument[0]);
        return 2;
    }
    while (fgets(line, sizeof line, cases) != NULL) {
        split(line);
        if (count > 0) take();
    }
    fclose(cases);
    return 0;
}

#endif
