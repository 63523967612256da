/* certify.h -- what `cagd exactly` and `cagd check` find, as certificates that recheck.py takes. */
#ifndef CLI_CERTIFY_H
#define CLI_CERTIFY_H

#include "exact/code/decide.h"

#include <jansson.h>

/* The statements and claims of a folder, while they are written. */
struct certifying {
    const char *folder, *part; /* the subfolder of the statements, which their names begin with */
    json_t *claims, *statements;
};

/* A statement with the one claim that decides it, and the cases of that claim. */
struct certified {
    const char *name, *printed;
    const char *kind, *outcome, *evidence; /* of the claim, as recheck_format.py has them                 */
    json_t *cases, *listed;                /* what certified_case made of each; they are given away              */
    json_int_t compared, number;           /* comparisons; cases, also where none could be noted           */
    const char *type;                      /* "field" or "rational" */
};

/* The folder is made, with the subfolder of the statements.  0, or -1 and a line on stderr; so everywhere here. */
int certify_begin(struct certifying *c, const char *folder, const char *part);

/* The name as that of a file, another than those of the claims before it. */
enum { CERTIFIED_NAME = 224 };
void certified_name(const struct certifying *c, const char *name, char text[CERTIFIED_NAME]);

/* The texts of a trace (exact/record/trace.h) as a case of that number, and in *listed what the manifest says of it. */
json_t *certified_case(const char *type, int number, const char *const trace[3], json_t **listed);

/* claims/NAME.json and PART/NAME.json. */
int certify_statement(struct certifying *c, const struct certified *s);

/* A proved block: claims/NAME.json has a case for each way through the code, the straight-line program that the way is, with what it
 * compared, at its point; exactly/NAME.json says that the claim decides it.  Others are left out. */
int certify_block(struct certifying *c, const struct cagd_code_program *p, const struct cagd_code_harness *h,
                  const struct cagd_code_verdict *v);

/* manifest.json, and the end. */
int certify_end(struct certifying *c);
#endif
