/* input.h -- what is wrong with an input, as readers return it and commands report it. */
#ifndef CAGD_INPUT_H
#define CAGD_INPUT_H

#include <stdarg.h>
#include <stdio.h>

/* Where in the input ("points[3]", "line 2, column 7"; empty: the whole), and what, with what was expected instead. */
struct input_error {
    char place[64], cause[320];
};

/* Fills the error; -1, as a reader returns it. */
int input_refuse(struct input_error *error, const char *place, const char *format, va_list list);

/* What messages call the file: its path, and "standard input" for "-". */
const char *name_of_input(const char *path);

/* The file, opened for reading, standard input for "-".  NULL and the error when it cannot be, or is a folder; what: what it
 * should hold, as "a curve". */
FILE *open_input(const char *path, const char *what, struct input_error *error);

/* One line on stderr: the file, the place and the cause. */
void report_input_error(const char *path, const struct input_error *error);
#endif
