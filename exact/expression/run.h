/* run.h -- one run over a statement: what the files share that decide it.
 *
 * check.c decides a statement, find.c for which values of a parameter it holds, certify.c notes it for others.  Each of them goes through all choices
 * of the whole numbers (cases.c); a case is cut into parts where that is needed (part.c); in a part each relation is compared
 * (compare.c), and what fails is refuted by numbers (refute.c). */
#ifndef CAGD_EXPRESSION_RUN_H
#define CAGD_EXPRESSION_RUN_H

#include "exact/expression/finding.h"

enum {
    CAGD_MOST_WHOLE = 8,  /* whole numbers of a statement                             */
    CAGD_FIRST_CASES = 8, /* of a range without end so many are looked at             */
    CAGD_FIELD_ROOM = 32  /* variables of the field with which it is tried first      */
};

/* Takes the texts of one case that was noted as exact/record/trace.h has it; 0 ends it. */
typedef int cagd_take_case(void *data, const char *inputs, const char *nodes, const char *steps);

/* One run over a statement. */
typedef struct cagd_run {
    const cagd_scope *scope;
    const cagd_tree *statement;
    cagd_finding *out;
    double until;
    int quick; /* one case that fails is enough, and few cases are */
    const cagd_tree *premise,
        *claim; /* of the statement the part that is looked at: what is supposed, or NULL, and what is said */
    cagd_take_case
        *take; /* NULL, or where each case goes with what was noted; `unnoted`: it is not the whole evidence */
    void *data;
    int unnoted;
    int undefined;         /* in some part a side was not defined */
    int untied, ties;      /* equalities of higher degree are not used (tie.h); how many were                 */
    int decomposes;        /* where they are, what is not decided is decomposed, too (implied.h)              */
    const char *parameter; /* NULL, or the name of which is asked for which values the statement holds (find.h) */
    struct cagd_collection *into; /* NULL, or where constraints of a parameter are collected and nothing is decided */
    const cagd_variable *whole[CAGD_MOST_WHOLE];
    int wholes;
    cagd_given chosen[CAGD_MOST_WHOLE]; /* values of the whole numbers */
    long skipped, taken;                /* of a range without end so many are left out, and so many are looked at */
} cagd_run;

/* A part of a case: pieces of some variables, and numbers for others. */
typedef struct cagd_part {
    cagd_piece piece[CAGD_MOST_PIECES];
    int pieces;
    cagd_given number[CAGD_MOST_PIECES];
    const cagd_variable *of_number[CAGD_MOST_PIECES]; /* their declarations, or NULL */
    int numbers;
    cagd_cut cut[CAGD_MOST_CUTS_OF_CELL];
    int cuts;
    int apart;   /* so many of the numbers are those of a place that a tie leaves out (tie.h) */
    int tried;   /* how often numbers were chosen for names, only to refute */
    int touches; /* an equality is among them: it is a part of lower dimension */
} cagd_part;

/* The sides of the box of all variables that are known, and of which binding each is; their number. */
int cagd_sides_of_known(const cagd_context *c, cagd_side_of_box side[], int of[]);

/* What both together say. */
cagd_answer cagd_worse(cagd_answer a, cagd_answer b);
void cagd_weaken(cagd_finding *f, cagd_strength s);
/* Notes the first reason: the trouble of the context, or `why`; UNDECIDED. */
cagd_answer cagd_note_undecided(cagd_run *r, const cagd_context *c, const char *why);
#endif
