/* counterexample.h -- a counterexample, drawn. */
#ifndef CAGD_CLI_CHECK_COUNTEREXAMPLE_H
#define CAGD_CLI_CHECK_COUNTEREXAMPLE_H

#include "cli/check/document.h"
#include "exact/expression/finding.h"
#include "figures/svg.h"

/* A panel: both sides of the relation that fails over one name of its counterexample (cagd_free_name), the others being as in it,
 * and the place where it fails.  `panel` of them were drawn before.  1; 0 where the counterexample has no such name. */
int draw_counterexample(svg *s, const struct formula *one, const cagd_finding *f, int panel);

/* What the lines and marks of all panels are. */
void draw_legend_of_counterexamples(svg *s);
#endif
