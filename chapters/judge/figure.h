/* figure.h -- how a chapter's figures are declared: FIGURE(name) { ... return a canvas; }. */
#ifndef CAGD_FIGURE_H
#define CAGD_FIGURE_H

struct svg;

#define FIGURE(name) struct svg *figure_##name(void)

typedef struct figure {
    const char *name;
    struct svg *(*draw)(void); /* the caller frees the canvas */
} figure;
#endif
