/* token.h -- formulas of TeX as a sequence of tokens.
 *
 * Blanks, spacing commands, \left, \right and sizes of brackets are between tokens; comments go to the end of the line.  What
 * can be written in several ways has one word: "≤", "\leq" and "\le" are all "\le", "β" is "\beta", "\ldots" and ".." are
 * "\dots". */
#ifndef CAGD_TOKEN_H
#define CAGD_TOKEN_H

#include "exact/expression/reading.h"

typedef enum cagd_token_kind {
    CAGD_TOKEN_END,
    CAGD_TOKEN_NUMBER, /* digits, with a point between them                              */
    CAGD_TOKEN_LETTER, /* "t", "\lambda": what can be the letter of a name               */
    CAGD_TOKEN_WORD,   /* "\frac": any other command                                     */
    CAGD_TOKEN_SIGN,   /* "+", "(", "\\": one character, or the break of a line          */
    CAGD_TOKEN_ROW     /* the comma "," between two rows of formulas (read_rows.c)      */
} cagd_token_kind;

typedef struct cagd_token {
    cagd_token_kind kind;
    const char *word;
    int from, to; /* bytes of the text */
} cagd_token;

/* The tokens of text[from..to), with an END behind them; in the region.  NULL and the error where there is no token, or where
 * there are more than CAGD_MOST_TOKENS. */
enum { CAGD_MOST_TOKENS = 20000 };
/* So many ends stand behind the last one, so that a reader may look some tokens ahead. */
enum { CAGD_TOKENS_AHEAD = 5 };
/* Whether a command is a Greek letter: "\lambda". */
int cagd_is_greek(const char *command);
cagd_token *cagd_tokens(const char *text, int from, int to, cagd_reading_error *error);
#endif
