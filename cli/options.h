/* options.h -- the options that a command has, and whether those that are typed are among them. */
#ifndef CAGD_OPTIONS_H
#define CAGD_OPTIONS_H

#include "cli/command.h"

/* What commands share, and what every command has. */
extern const struct argp_option json_row[], jobs_row[], help_rows[];
enum { KEY_USAGE = 0x10000 };

/* Refuses a call with an option that the command does not have, that may be one of several, lacks its value, or has one that it
 * does not take. */
void check_options(const struct call *c);
#endif
