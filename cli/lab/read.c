/* read.c -- labs as folders of data; see lab.h. */
#include "cli/lab/lab.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- files ---------------------------------------------------------------------------------------------- */

char *lab_file(const char *path)
{
    struct stat is;
    int file = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
        return NULL;
    if (fstat(file, &is) != 0 || !S_ISREG(is.st_mode) || is.st_size > LAB_MOST_BYTES) {
        close(file);
        errno = EINVAL;
        return NULL;
    }
    char *text = malloc((size_t)is.st_size + 1);
    ssize_t size = text != NULL ? read(file, text, (size_t)is.st_size) : -1;
    close(file);
    if (size < 0 || memchr(text, 0, (size_t)size) != NULL) {
        free(text);
        errno = EINVAL;
        return NULL;
    }
    text[size] = 0;
    return text;
}

int lab_folder(char path[LAB_MOST_PATH])
{
    static const char *const places[] = {"../share/cagd/labs", "../../chapters/labs"};
    char self[LAB_MOST_PATH - 64];
    ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    if (length < 0)
        return -1;
    self[length] = 0;
    *(strrchr(self, '/') + 1) = 0;
    for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
        snprintf(path, LAB_MOST_PATH, "%s%s", self, places[k]);
        if (access(path, R_OK) == 0)
            return 0;
    }
    return -1;
}

static int by_name(const void *a, const void *b) { return strcmp(*(char *const *)a, *(char *const *)b); }

json_t *lab_names(void)
{
    char folder[LAB_MOST_PATH], path[LAB_MOST_PATH + 300], *name[256];
    json_t *list = json_array();
    size_t count = 0;
    DIR *d = lab_folder(folder) == 0 ? opendir(folder) : NULL;
    for (const struct dirent *e; d != NULL && (e = readdir(d)) != NULL;) {
        snprintf(path, sizeof path, "%s/%s/lab.md", folder, e->d_name);
        if (*e->d_name != '.' && count < sizeof name / sizeof *name && access(path, R_OK) == 0)
            name[count++] = strdup(e->d_name);
    }
    if (d != NULL)
        closedir(d);
    qsort(name, count, sizeof *name, by_name);
    for (size_t k = 0; k < count; k++) {
        json_array_append_new(list, json_string(name[k]));
        free(name[k]);
    }
    return list;
}

/* ---- blocks --------------------------------------------------------------------------------------------- */

const char *lab_text(const json_t *block, const char *key)
{
    const char *text = json_string_value(json_array_get(json_object_get(block, key), 0));
    return text != NULL ? text : "";
}

int lab_lists(const char *list, const char *name)
{
    size_t length = strlen(name);
    for (const char *at = list; (at = strstr(at, name)) != NULL; at++)
        if ((at == list || at[-1] == ' ') && (at[length] == 0 || at[length] == ' '))
            return 1;
    return 0;
}

int lab_points(const json_t *requirement) { return (int)strtol(lab_text(requirement, "points"), NULL, 10); }

static void add(json_t *block, const char *key, const char *text)
{
    json_t *list = json_object_get(block, key);
    if (list == NULL)
        json_object_set_new(block, key, list = json_array());
    json_array_append_new(list, json_string(text));
}

/* The line goes on in the last text of the key. */
static void go_on(json_t *block, const char *key, const char *line)
{
    json_t *list = json_object_get(block, key);
    size_t last = json_array_size(list) - 1;
    char *whole = NULL;
    if (asprintf(&whole, "%s\n%s", json_string_value(json_array_get(list, last)), line) < 0)
        abort();
    json_array_set_new(list, last, json_string(whole[0] == '\n' ? whole + 1 : whole));
    free(whole);
}

static json_t *open_block(const char *line, int number)
{
    char kind[32], name[64];
    if (sscanf(line, ":::{%31[a-z]} %63s", kind, name) != 2)
        return NULL;
    return json_pack("{s:s, s:s, s:i}", "kind", kind, "name", name, "line", number);
}

/* All blocks of a text. */
static json_t *blocks_of(char *text, char cause[LAB_CAUSE])
{
    json_t *all = json_array(), *block = NULL;
    char key[32] = "", *rest = text;
    int number = 0;
    for (char *line; (line = strsep(&rest, "\n")) != NULL;) {
        number++;
        if (block == NULL) {
            if (strncmp(line, ":::{", 4) == 0 && (block = open_block(line, number)) == NULL)
                goto wrong;
            key[0] = 0;
        } else if (strcmp(line, ":::") == 0) {
            json_array_append_new(all, block);
            block = NULL;
        } else if (line[0] == ':' && sscanf(line, ":%31[a-z]:", key) == 1) {
            const char *value = line + strlen(key) + 2;
            add(block, key, value + (*value == ' '));
        } else if (key[0] != 0 && (isspace((unsigned char)*line) || *line == 0 || strcmp(key, "replace") == 0 ||
                                   strcmp(key, "by") == 0)) { /* code begins anywhere */
            go_on(block, key, line);
        } else {
            goto wrong;
        }
    }
    if (block == NULL)
        return all;
wrong:
    snprintf(cause, LAB_CAUSE,
             "line %d: \":::{kind} name\", \":key: text\", a line that begins with a blank, or \":::\" "
             "was expected",
             number);
    json_decref(block);
    json_decref(all);
    return NULL;
}

/* ---- whole numbers in texts ------------------------------------------------------------------------------- */

static long whole_sum(const char **at, const struct lab_letters *l, int *wrong);

static long whole_atom(const char **at, const struct lab_letters *l, int *wrong)
{
    *at += strspn(*at, " ");
    if (**at == '(') {
        ++*at;
        long value = whole_sum(at, l, wrong);
        *at += strspn(*at, " ");
        *wrong |= **at != ')';
        *at += **at == ')';
        return value;
    }
    for (int k = 0; k < l->count; k++)
        if (**at == l->name[k]) {
            ++*at;
            return l->value[k];
        }
    char *end;
    long value = strtol(*at, &end, 10);
    *wrong |= end == *at;
    *at = end;
    return value;
}

static long whole_product(const char **at, const struct lab_letters *l, int *wrong)
{
    long value = whole_atom(at, l, wrong);
    for (*at += strspn(*at, " "); !*wrong && (**at == '*' || **at == '/'); *at += strspn(*at, " ")) {
        int times = *(*at)++ == '*';
        long next = whole_atom(at, l, wrong);
        *wrong |= !times && next == 0;
        value = *wrong ? 0 : times ? value * next : value / next;
    }
    return value;
}

static long whole_sum(const char **at, const struct lab_letters *l, int *wrong)
{
    long value = whole_product(at, l, wrong);
    for (*at += strspn(*at, " "); !*wrong && (**at == '+' || **at == '-'); *at += strspn(*at, " "))
        value += *(*at)++ == '+' ? whole_product(at, l, wrong) : -whole_product(at, l, wrong);
    return value;
}

char *lab_put_numbers(const char *text, const struct lab_letters *l)
{
    char *made = NULL;
    size_t size;
    int wrong = 0;
    FILE *out = open_memstream(&made, &size);
    while (*text != 0)
        if (*text == '$') {
            text++;
            fprintf(out, "%ld", whole_atom(&text, l, &wrong));
        } else {
            fputc(*text++, out);
        }
    fclose(out);
    if (!wrong)
        return made;
    free(made);
    return NULL;
}

int lab_each(const char *ranges, struct lab_letters *l, int (*visit)(void *what, const struct lab_letters *l),
             void *what)
{
    ranges += strspn(ranges, " ,");
    if (*ranges == 0)
        return visit(what, l);
    int wrong = l->count == LAB_MOST_LETTERS || !isalpha((unsigned char)*ranges), index = l->count, status = 0;
    char name = *ranges;
    const char *at = wrong ? ranges : ranges + 1 + strspn(ranges + 1, " ");
    wrong |= *at != '=' || memchr(l->name, name, (size_t)index) != NULL;
    at += !wrong;
    long low = wrong ? 0 : whole_sum(&at, l, &wrong), high = low;
    if (strncmp(at, "..", 2) == 0) {
        at += 2;
        high = whole_sum(&at, l, &wrong);
    }
    if (wrong || (*at != 0 && *at != ','))
        return -1;
    for (long value = low; status == 0 && value <= high; value++) {
        l->count = index + 1;
        l->name[index] = name;
        l->value[index] = value;
        status = lab_each(at, l, visit, what);
    }
    l->count = index;
    return status;
}

/* ---- cases ---------------------------------------------------------------------------------------------- */

/* The harness of the requirement, for these numbers. */
static int add_case(struct lab *lab, const json_t *requirement, const struct lab_letters *l, const char *seed,
                    char *cause)
{
    static const char *const keys[] = {"input", "where", "call", "output"};
    const char *name = json_string_value(json_object_get(requirement, "name"));
    char *text = NULL;
    size_t size, k;
    const json_t *value;
    if (lab->cases == LAB_MOST_CASES) {
        snprintf(cause, LAB_CAUSE, "%s: more than %d cases", name, LAB_MOST_CASES);
        return -1;
    }
    struct lab_case *c = &lab->at[lab->cases];
    for (int j = 0; j < l->count; j++)
        snprintf(c->label + strlen(c->label), sizeof c->label - strlen(c->label), "%s%c = %ld", j > 0 ? ", " : "",
                 l->name[j], l->value[j]);
    FILE *out = open_memstream(&text, &size);
    fprintf(out, ":::{exactly} %s/%s/%s\n", seed, name, c->label);
    json_array_foreach(json_object_get(lab->head, "declare"), k, value)
        fprintf(out, ":declare: %s\n", json_string_value(value));
    for (size_t j = 0; j < sizeof keys / sizeof *keys; j++)
        json_array_foreach(json_object_get(requirement, keys[j]), k, value)
            fprintf(out, ":%s: %s\n", keys[j], json_string_value(value));
    fputs(":::\n", out);
    fclose(out);
    char *whole = lab_put_numbers(text, l);
    struct cagd_code_harness_error error = {0, "a number behind $ was expected"};
    c->h = whole != NULL ? cagd_code_read_harness(whole, &error) : NULL;
    free(text);
    free(whole);
    if (c->h == NULL) {
        snprintf(cause, LAB_CAUSE, "%s: %s", name, error.cause);
        return -1;
    }
    if (*lab_text(requirement, "python") != 0 &&
        (c->python = lab_put_numbers(lab_text(requirement, "python"), l)) == NULL) {
        snprintf(cause, LAB_CAUSE, "%s: a number behind $ was expected in :python:", name);
        return -1;
    }
    c->requirement = requirement;
    if (lab_read_formula(c, l, cause) != 0 || lab_read_levels(lab, c, l, cause) != 0)
        return -1;
    c->number = lab->cases++;
    c->earlier = c->number > 0 && c[-1].requirement == requirement ? c->number - 1 : c->number;
    return 0;
}

struct cases {
    struct lab *lab;
    const json_t *requirement;
    const char *seed;
    char *cause;
};

static int visit_case(void *what, const struct lab_letters *l)
{
    const struct cases *c = what;
    return add_case(c->lab, c->requirement, l, c->seed, c->cause);
}

static int add_cases(struct lab *lab, const json_t *requirement, const char *seed, char *cause)
{
    struct lab_letters l = {0};
    struct cases c = {lab, requirement, seed, cause};
    const char *ranges = lab_text(requirement, "for");
    cause[0] = 0;
    int status = lab_each(ranges, &l, visit_case, &c);
    if (status != 0 && cause[0] == 0)
        snprintf(cause, LAB_CAUSE, "%s: \"n = 1..6, k = 0..n\" was expected, not \"%s\"",
                 json_string_value(json_object_get(requirement, "name")), ranges);
    return status;
}

static int understand(struct lab *lab, const char *seed, char cause[LAB_CAUSE])
{
    size_t k;
    const json_t *block;
    int requirements = 0;
    json_array_foreach(lab->blocks, k, block) if (strcmp(json_string_value(json_object_get(block, "kind")), "lab") == 0)
        lab->head = block;
    if (lab->head == NULL) {
        snprintf(cause, LAB_CAUSE, "there is no block :::{lab} NAME");
        return -1;
    }
    snprintf(lab->name, sizeof lab->name, "%s", json_string_value(json_object_get(lab->head, "name")));
    lab->language = *lab_text(lab->head, "language") != 0 ? lab_text(lab->head, "language") : "c";
    snprintf(lab->file, sizeof lab->file, "%s.%s", lab->name,
             strcmp(lab->language, "c") == 0        ? "c"
             : strcmp(lab->language, "python") == 0 ? "py"
                                                    : "txt");
    json_array_foreach(lab->blocks, k,
                       block) if (strcmp(json_string_value(json_object_get(block, "kind")), "requirement") == 0)
    {
        requirements++;
        /* one without a call is about how the code behaves, whatever is called */
        if (json_object_get(block, "call") != NULL && add_cases(lab, block, seed, cause) != 0)
            return -1;
    }
    if (requirements == 0)
        snprintf(cause, LAB_CAUSE, "there is no block :::{requirement} NAME");
    return requirements > 0 ? 0 : -1;
}

struct lab *lab_read(const char *folder, const char *seed, char cause[LAB_CAUSE])
{
    char path[LAB_MOST_PATH + 16];
    struct lab *lab = calloc(1, sizeof *lab);
    if (lab == NULL)
        abort();
    snprintf(lab->folder, sizeof lab->folder, "%s", folder);
    snprintf(path, sizeof path, "%s/lab.md", folder);
    char *text = lab_file(path);
    if (text == NULL)
        snprintf(cause, LAB_CAUSE, "lab.md cannot be read: %s", strerror(errno));
    lab->blocks = text != NULL ? blocks_of(text, cause) : NULL;
    free(text);
    if (lab->blocks == NULL || understand(lab, seed, cause) != 0) {
        lab_free(lab);
        return NULL;
    }
    return lab;
}

void lab_free(struct lab *lab)
{
    if (lab == NULL)
        return;
    for (int k = 0; k < lab->cases; k++) {
        cagd_code_harness_free(lab->at[k].h);
        json_decref(lab->at[k].points);
        free(lab->at[k].python);
        free(lab->at[k].formula);
    }
    json_decref(lab->blocks);
    free(lab);
}
