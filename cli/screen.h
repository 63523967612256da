/* screen.h -- what is printed on a terminal: no line is wider than it, and what is longer comes by pages. */
#ifndef CAGD_SCREEN_H
#define CAGD_SCREEN_H

/* From here to the end of the program what goes to standard output is kept, where that is a terminal, and then printed: long
 * lines are broken, and more lines than the terminal has are given to $PAGER, or less where that is not set.  Also sees
 * at the end, terminal or not, that everything was written, and exits with EXIT_INTERNAL and a line on stderr if not. */
void screen_begin(void);
/* Lines are printed as they are: for what other programs read. */
void screen_leaves_lines(void);
/* The descriptor of the terminal while output is kept; otherwise that of standard output. */
int screen_descriptor(void);
#endif
