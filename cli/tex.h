/* tex.h -- formulas for a terminal: the small part of TeX that statements are written in, as text. */
#ifndef CAGD_CLI_TEX_H
#define CAGD_CLI_TEX_H

/* "\frac{n!}{(n-k)!}\omega_k" -> "n!/(n−k)! ω_k".  Text outside \( \) or $ $ is taken as it is when
 * `mixed`; with mixed = 0 all of it is a formula.  The caller frees the result; never NULL. */
char *tex_to_text(const char *tex, int mixed);
/* The same for put_paragraph (cli/layout.h), which gives a matrix several lines. */
char *tex_to_layout(const char *tex, int mixed);
#endif
