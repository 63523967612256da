/* sheet.h -- the sheet of a basis: what is asked of every basis of curves, each with the values of the parameter for which it is so. */
#ifndef CAGD_CLI_CHECK_SHEET_H
#define CAGD_CLI_CHECK_SHEET_H

#include "cli/check/document.h"
#include "exact/expression/finding.h"
#include "figures/svg.h"

#include <jansson.h>

/* Decides all of it, and prints the page, or adds the sheet to the list, which may be NULL; draws the functions where `picture` is not NULL;
 * whether everything was decided. */
int check_sheet(const struct document *d, const struct sheet *s, json_t *list, svg *picture);
#endif
