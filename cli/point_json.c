/* point_json.c -- the inputs of code that is run exactly, as JSON. */
#include "cli/point_json.h"

json_t *point_json(const struct cagd_code_point *p)
{
    json_t *object = json_object();
    for (int i = 0; i < p->inputs; i++) {
        json_t *values = json_array();
        for (int j = 0; j < (p->input[i].count > 0 ? p->input[i].count : 1); j++)
            json_array_append_new(values, json_string(p->input[i].value[j]));
        json_object_set_new(object, p->input[i].name, values);
    }
    return object;
}
