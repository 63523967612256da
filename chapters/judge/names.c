/* names.c -- the words of the lists. */
#include "chapters/judge/run.h"

#define SECOND_IN_QUOTES(tag, name, suffix, kernels) #name,
#define SECOND(tag, name)                            name,
#define KEY(tag, key, has_text)                      key,
const char *const number_type_name[NUMBER_TYPES] = {NUMBER_TYPE_LIST(SECOND_IN_QUOTES)};
const char *const kind_name[KINDS] = {KIND_LIST(SECOND)};
const char *const role_key[ROLES] = {ROLE_LIST(KEY)};
const char *const outcome_name[] = {"holds", "fails", "undecided"};
const char *const evidence_name[] = {"none", "measured", "enclosed", "sampled", "decided", "proved"};
const char *const verdict_name[] = {"holds", "conditional", "fails", "undecided", "open", "definition"};
