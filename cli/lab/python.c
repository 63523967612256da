/* python.c -- answers in Python: what is called, what is seen in the source, and the program that runs them, cagd_lab.py; see lab.h. */
#include "cli/lab/lab.h"
#include "exact/number/field.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SECONDS = 20, MOST_TEXT = 1 << 20, MOST_DEPTH = 60, MOST_POWER = 200 };

int lab_is_python(const struct lab *lab, const char *object)
{
    return strcmp(lab->language, "python") == 0 && strcmp(object, "reference.so") != 0;
}

static int write_into(const struct lab_place *place, const char *name, const char *text)
{
    char path[LAB_MOST_PATH + 128];
    snprintf(path, sizeof path, "%s/%s", place->folder, name);
    FILE *out = fopen(path, "w");
    if (out == NULL)
        return -1;
    int status = fputs(text, out) < 0 ? -1 : 0;
    return fclose(out) != 0 ? -1 : status;
}

/* The text of cagd_lab.py, beside the program, installed or built. */
static char *player(void)
{
    static const char *const places[] = {"../share/cagd/python/cagd_lab.py", "../../cli/lab/cagd_lab.py"};
    char self[LAB_MOST_PATH], path[LAB_MOST_PATH + 64], *text = NULL;
    ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    self[length > 0 ? length : 0] = 0;
    char *slash = strrchr(self, '/');
    for (size_t k = 0; slash != NULL && text == NULL && k < sizeof places / sizeof *places; k++) {
        snprintf(path, sizeof path, "%.*s/%s", (int)(slash - self), self, places[k]);
        text = lab_file(path);
    }
    return text;
}

/* "R" or "R[3]" */
static json_t *output_json(const char *text)
{
    size_t length = strcspn(text, "[ ");
    return json_pack("{s:s%, s:i}", "name", text, length, "count",
                     text[length] == '[' ? (int)strtol(text + length + 1, NULL, 10) : 0);
}

/* What cagd_lab.py is told of every case. */
static json_t *cases_json(const struct lab *lab)
{
    json_t *cases = json_array();
    for (int k = 0; k < lab->cases; k++) {
        const struct lab_case *c = &lab->at[k];
        json_t *inputs = json_array(), *outputs = json_array();
        for (int i = 0; i < c->h->inputs; i++)
            json_array_append_new(inputs,
                                  json_pack("{s:s, s:i}", "name", c->h->input[i].name, "count", c->h->input[i].count));
        for (int i = 0; i < c->h->output.count; i++)
            json_array_append_new(outputs, output_json(c->h->output.text[i]));
        json_array_append_new(cases, json_pack("{s:s, s:i, s:o, s:o}", "call", c->python != NULL ? c->python : "",
                                               "earlier", c->earlier, "inputs", inputs, "outputs", outputs));
    }
    return cases;
}

static char *said_to(const struct lab_place *place, const char *option, const char *file, int *code)
{
    char *said = NULL;
    char *const word[] = {(char *)(uintptr_t) "/usr/bin/python3",
                          (char *)(uintptr_t) "-I",
                          (char *)(uintptr_t) "cagd_lab.py",
                          (char *)(uintptr_t)option,
                          (char *)(uintptr_t)file,
                          NULL};
    *code = lab_run(place, word, SECONDS, &said);
    return said;
}

json_t *lab_inspect_python(const struct lab_place *place, const char *file)
{
    int code;
    char *said = said_to(place, "--inspect", file, &code);
    json_t *seen = code == 0 && said != NULL ? json_loads(said, 0, NULL) : NULL;
    free(said);
    return json_is_object(seen) && json_is_array(json_object_get(seen, "notes"))
               ? seen
               : (json_decref(seen), json_pack("{s:[], s:s}", "notes", "refused", "the source cannot be read"));
}

char *lab_build_python(const struct lab *lab, const struct lab_place *place, const char *source, const char *object)
{
    char *program = player();
    json_t *cases = cases_json(lab);
    char *text = json_dumps(cases, JSON_COMPACT), *cause = NULL;
    if (program == NULL || text == NULL || write_into(place, "cagd_lab.py", program) != 0 ||
        write_into(place, "cases.json", text) != 0 || write_into(place, object, source) != 0)
        cause = strdup("cagd_lab.py, which runs it, is not there");
    json_decref(cases);
    free(program);
    free(text);
    if (cause != NULL)
        return cause;
    json_t *seen = lab_inspect_python(place, object);
    const char *error = json_string_value(json_object_get(seen, "compiler"));
    const char *refused = json_string_value(json_object_get(seen, "refused"));
    cause = error != NULL ? strdup(error) : refused != NULL ? strdup(refused) : NULL;
    json_decref(seen);
    return cause;
}
