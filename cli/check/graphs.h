/* graphs.h -- the functions of a basis, drawn for some values of the parameter. */
#ifndef CAGD_CLI_CHECK_GRAPHS_H
#define CAGD_CLI_CHECK_GRAPHS_H

#include "cli/check/document.h"
#include "figures/svg.h"

/* A row of panels, one for each of `count` values of the parameter; one panel where there is no parameter. */
void draw_basis(svg *s, const struct sheet *sheet, const cagd_basis *b, int count, const cagd_num_q value[]);
#endif
