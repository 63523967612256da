/* output.h -- files that are written: whole or not at all, and in place of nothing that was not meant.
 *
 * A new file, and a regular file that is there, is written beside its place under another name and renamed when it is whole;
 * what was there keeps its mode and its owner.  Symbolic links are followed.  Devices, FIFOs, files with several names and
 * files in a folder that takes no new ones are written in place. */
#ifndef CAGD_OUTPUT_H
#define CAGD_OUTPUT_H

#include <stdio.h>

/* NULL and a line on stderr when the file cannot be written. */
struct output;
struct output *output_open(const char *path);
FILE *output_stream(struct output *o);
/* Puts the file in its place and frees `o`.  This and the next two: 0, or -1 and a line on stderr. */
int output_close(struct output *o);
void output_forget(void); /* what is not whole is taken away: in a handler, before the process ends */
int write_text_file(const char *path, const char *text);
/* The same where several threads write: one after the other, and none after one of them has failed, so that one line says it.
 * *failed begins as 0 and is theirs together. */
int write_text_in_turn(const char *path, const char *text, int *failed);
int make_folder(const char *path); /* with its parents */

/* What is to be done where writing failed for that cause, an errno, 0 if it is not known: "make room there, or " where that may
 * help, otherwise nothing; then the caller says where else it can go. */
const char *output_advice(int cause);

/* Before anything is computed; nothing is made or written by these.  Each returns 0, or EXIT_USAGE and a line on stderr.
 *
 * A file that is read, "-" for standard input: no output may take its place. */
int output_spare(const char *path);
/* Whether an option may write to the file, or into the folder, which make_folder makes: not to a file that is read, that
 * standard output goes to, or that another option writes, and not where nothing can be written. */
int output_promise(const char *option, const char *path);
int output_promise_folder(const char *option, const char *path);
#endif
