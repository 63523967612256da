/* names.c -- the words of the lists. */
#include "chapters/judge/run.h"

#define SECOND_IN_QUOTES(tag, name, suffix, kernels) #name,
#define SECOND(tag, name)                            name,
#define KEY(tag, key, form)                          key,
#define FORM(tag, key, form)                         form,
const char *const number_type_name[NUMBER_TYPES] = {NUMBER_TYPE_LIST(SECOND_IN_QUOTES)};
const char *const kind_name[KINDS] = {KIND_LIST(SECOND)};
const char *const role_key[ROLES] = {ROLE_LIST(KEY)};
const role_form form_of_role[ROLES] = {ROLE_LIST(FORM)};
const char *const outcome_name[] = {"holds", "fails", "undecided"};
const char *const evidence_name[] = {"none", "measured", "enclosed", "sampled", "argued", "decided", "proved"};
const char *const verdict_name[] = {"holds", "conditional", "fails", "undecided", "open", "definition"};
