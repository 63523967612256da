/* grade.c -- a folder of submissions, several at a time, each in a sandbox; see lab.h.
 *
 * A submission is SUBMISSIONS/NAME/FILE or SUBMISSIONS/NAME.c.  For each a folder OUT/NAME has results.json, as Gradescope reads
 * it, result.json, all that is known, and page.html; OUT has results.csv, results.json and junit.xml. */
#include "cli/commands.h"
#include "cli/junit.h"
#include "cli/lab/lab.h"
#include "cli/output.h"
#include "cli/refuse.h"
#include "cli/xml.h"

#include <dirent.h>
#include <errno.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST = 10000 };

struct class
{
    const struct lab *lab;
    const char *submissions, *out;
    char *name[MOST];
    int count;
};

/* What the processes have in common.  Only one of them writes at a time, and none after a result could not be written. */
struct board {
    atomic_int next, stopped;
    char graded[MOST];
};

static const char *member(const json_t *row, const char *key)
{
    const char *text = json_string_value(json_object_get(row, key));
    return text != NULL ? text : "";
}

/* ---- writing ---------------------------------------------------------------------------------------------- */

static void put_cell(FILE *out, const char *text)
{
    fputc('"', out);
    if (strchr("=+-@\t\r", *text) != NULL && *text != 0) /* no formula for a spreadsheet */
        fputc('\'', out);
    for (; *text != 0; text++)
        fprintf(out, *text == '"' ? "\"\"" : "%c", *text);
    fputc('"', out);
}

static int put_json(const char *path, const json_t *document)
{
    char *text = json_dumps(document, JSON_INDENT(2));
    int status = text != NULL ? write_text_file(path, text) : -1;
    free(text);
    return status;
}

/* What is told of a requirement, in lines. */
static char *story_of(const json_t *row)
{
    char *text = NULL;
    size_t size, k;
    const char *name;
    const json_t *values, *value, *one;
    FILE *out = open_memstream(&text, &size);
    fprintf(out, "%s", member(row, "text"));
    if (*member(row, "because") != 0)
        fprintf(out, "\nbecause: %s", member(row, "because"));
    if (*member(row, "case") != 0)
        fprintf(out, "\nfor %s", member(row, "case"));
    json_object_foreach((json_t *)(uintptr_t)json_object_get(row, "inputs"), name, values)
    {
        fprintf(out, "\n%s =", name);
        json_array_foreach(values, k, value) fprintf(out, "%s %s", k > 0 ? "," : "", json_string_value(value));
    }
    json_array_foreach(json_object_get(row, "differences"), k, one)
        fprintf(out, "\n%s is %s; expected %s", member(one, "name"), member(one, "got"), member(one, "expected"));
    if (*member(row, "levels") != 0)
        fprintf(out, "\nlevels: %s", member(row, "levels"));
    if (json_object_get(row, "hint") != NULL)
        fprintf(out, "\nhint: %s\n%s", member(json_object_get(row, "hint"), "text"),
                member(json_object_get(row, "hint"), "zh"));
    fclose(out);
    return text;
}

/* In a box, unless it is nothing. */
static void put_told(FILE *out, const char *text)
{
    if (*text == 0)
        return;
    fputs("<pre>", out);
    put_xml(out, text);
    fputs("</pre>", out);
}

static int write_page(const char *path, const char *student, const json_t *result)
{
    struct output *o = output_open(path);
    size_t k;
    const json_t *row;
    if (o == NULL)
        return -1;
    FILE *out = output_stream(o);
    fputs("<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>", out);
    put_xml(out, student);
    fputs(
        "</title><style>body{font:16px/1.5 sans-serif;max-width:52em;margin:2em auto;padding:0 1em}"
        "pre{background:#8881;padding:.6em;white-space:pre-wrap;margin:.4em 0}h2{font-size:1.05em;margin:1.4em 0 .2em}"
        ".zh{margin:0;color:#666}.mark{float:right;font-weight:normal}.full{color:#17692c}.none{color:#a3261b}"
        "svg{max-width:100%;height:auto}</style><h1>",
        out);
    put_xml(out, student);
    fputs("</h1><p>", out);
    put_xml(out, member(result, "title"));
    fprintf(out, ": <strong>%lld of %lld points</strong></p>",
            (long long)json_integer_value(json_object_get(result, "points")),
            (long long)json_integer_value(json_object_get(result, "of")));
    const char *whole = *member(result, "compiler") != 0 ? member(result, "compiler") : member(result, "refused");
    put_told(out, whole);
    json_array_foreach(json_object_get(result, "requirements"), k, row)
    {
        char *story = story_of(row);
        int full = json_equal(json_object_get(row, "points"), json_object_get(row, "of"));
        fprintf(out, "<h2><span class=\"mark %s\">%lld of %lld</span>", full ? "full" : "none",
                (long long)json_integer_value(json_object_get(row, "points")),
                (long long)json_integer_value(json_object_get(row, "of")));
        put_xml(out, member(row, "title"));
        fputs("</h2><p class=\"zh\">", out);
        put_xml(out, member(row, "zh"));
        fputs("</p>", out);
        if (strcmp(story, whole) != 0) /* which was told above */
            put_told(out, story);
        free(story);
    }
    char *picture = lab_picture("difference", result);
    if (picture != NULL)
        fputs(strstr(picture, "<svg"), out);
    free(picture);
    json_array_foreach(json_object_get(result, "notes"), k, row)
    {
        fprintf(out, "<p>line %lld: ", (long long)json_integer_value(json_object_get(row, "line")));
        put_xml(out, member(row, "text"));
        fputs("</p>", out);
    }
    fputs("</html>\n", out);
    return output_close(o);
}

static json_t *gradescope(const json_t *result)
{
    json_t *tests = json_array();
    size_t k;
    const json_t *row;
    json_array_foreach(json_object_get(result, "requirements"), k, row)
    {
        char *story = story_of(row);
        json_array_append_new(tests, json_pack("{s:s, s:O, s:O, s:s, s:s}", "name", member(row, "title"), "score",
                                               json_object_get(row, "points"), "max_score", json_object_get(row, "of"),
                                               "output", story, "visibility", "visible"));
        free(story);
    }
    const char *whole = *member(result, "compiler") != 0 ? member(result, "compiler") : member(result, "refused");
    return json_pack("{s:O, s:s, s:o}", "score", json_object_get(result, "points"), "output", whole, "tests", tests);
}

/* ---- a submission ------------------------------------------------------------------------------------------- */

static char *answer_of(const struct class *c, const char *name)
{
    char path[LAB_MOST_PATH + 600];
    struct stat is;
    snprintf(path, sizeof path, "%s/%s", c->submissions, name);
    if (lstat(path, &is) == 0 && S_ISDIR(is.st_mode))
        snprintf(path, sizeof path, "%s/%s/%s", c->submissions, name, c->lab->file);
    return lab_file(path);
}

static int by_name(const void *a, const void *b) { return strcmp(*(char *const *)a, *(char *const *)b); }

static int is_submitted(const struct class *c, const char *name)
{
    return bsearch(&name, c->name, (size_t)c->count, sizeof *c->name, by_name) != NULL;
}

/* The name of a file without its ending, unless that is the name of another submission; and none of the tables'. */
static void student_of(const struct class *c, const char *name, char student[300])
{
    static const char *const tables[] = {"results.csv", "results.json", "junit.xml"};
    const char *end = strrchr(c->lab->file, '.');
    size_t length = strlen(name), ending = strlen(end);
    char path[LAB_MOST_PATH + 300];
    struct stat is;
    snprintf(path, sizeof path, "%s/%s", c->submissions, name);
    int is_file = lstat(path, &is) == 0 && !S_ISDIR(is.st_mode);
    if (is_file && length > ending && strcmp(name + length - ending, end) == 0)
        length -= ending;
    snprintf(student, 300, "%.*s", (int)length, name);
    if (length < strlen(name) && is_submitted(c, student))
        snprintf(student, 300, "%s", name);
    for (size_t k = 0; k < sizeof tables / sizeof *tables; k++)
        if (strcmp(student, tables[k]) == 0) {
            do
                strcat(student, "-");
            while (is_submitted(c, student) && strlen(student) < 290);
        }
}

/* The name as a text: where it is no UTF-8, its bytes beyond ASCII as %FF. */
static const char *shown_name(const char *student, char shown[1000])
{
    json_t *text = json_string(student);
    size_t size = 0;
    for (const char *at = student; *at != 0 && size < 990; at++)
        size += (size_t)snprintf(shown + size, 1000 - size,
                                 text == NULL && (unsigned char)*at >= 0x80 ? "%%%02X" : "%c", (unsigned char)*at);
    shown[size] = 0;
    json_decref(text);
    return shown;
}

static json_t *nothing(const struct class *c, const char *why)
{
    json_t *rows = json_array();
    json_int_t of = 0;
    size_t k;
    const json_t *block;
    json_array_foreach(c->lab->blocks, k, block) if (strcmp(member(block, "kind"), "requirement") == 0)
    {
        of += lab_points(block);
        json_array_append_new(rows, json_pack("{s:s, s:s, s:s, s:s, s:s, s:i, s:i}", "name", member(block, "name"),
                                              "title", lab_text(block, "title"), "zh", lab_text(block, "zh"), "verdict",
                                              "refused", "text", why, "points", 0, "of", lab_points(block)));
    }
    return json_pack("{s:s, s:s, s:s, s:o, s:s, s:i, s:I, s:[]}", "schema", "cagd-lab-1", "lab", c->lab->name, "title",
                     lab_text(c->lab->head, "title"), "requirements", rows, "refused", why, "points", 0, "of", of,
                     "notes");
}

/* Up to the first file that cannot be written. */
static int write_result(const struct class *c, const char *student, const json_t *result)
{
    char path[LAB_MOST_PATH + 400], shown[1000];
    json_t *scores = gradescope(result);
    snprintf(path, sizeof path, "%s/%s", c->out, student);
    int status = make_folder(path);
    snprintf(path, sizeof path, "%s/%s/result.json", c->out, student);
    status = status != 0 ? status : put_json(path, result);
    snprintf(path, sizeof path, "%s/%s/results.json", c->out, student);
    status = status != 0 ? status : put_json(path, scores);
    snprintf(path, sizeof path, "%s/%s/page.html", c->out, student);
    json_decref(scores);
    return status != 0 ? status : write_page(path, shown_name(student, shown), result);
}

/* One of the processes: takes submissions until there are none. */
static int work(const struct class *c, struct board *board, int lock)
{
    char cause[LAB_CAUSE], student[300];
    struct lab_bench *bench = calloc(1, sizeof *bench);
    if (bench == NULL || lab_bench_open(bench, c->lab, 0, cause) != 0)
        return 1;
    bench->draws = 1;
    for (int k; !board->stopped && (k = atomic_fetch_add(&board->next, 1)) < c->count;) {
        char *answer = answer_of(c, c->name[k]);
        json_t *result = answer != NULL ? lab_judge(bench, answer, 1) : nothing(c, "there is no file that can be read");
        student_of(c, c->name[k], student);
        if (lockf(lock, F_LOCK, 0) != 0) /* it ends with the process that has it */
            abort();
        if (!board->stopped && write_result(c, student, result) != 0)
            board->stopped = 1;
        board->graded[k] = !board->stopped;
        if (lockf(lock, F_ULOCK, 0) != 0)
            abort();
        json_decref(result);
        free(answer);
    }
    lab_bench_close(bench);
    free(bench);
    return 0;
}

/* ---- all of them ---------------------------------------------------------------------------------------------- */

static int find(struct class *c)
{
    DIR *d = opendir(c->submissions);
    if (d == NULL) {
        refuse_line("%s: %s; expected the folder of the submissions", c->submissions, strerror(errno));
        return -1;
    }
    int found = 0;
    for (const struct dirent *e; (e = readdir(d)) != NULL;)
        if (*e->d_name != '.' && ++found <= MOST && (c->name[c->count++] = strdup(e->d_name)) == NULL)
            abort();
    closedir(d);
    if (found > MOST) {
        refuse_line("%s: %d submissions; expected at most %d in one run", c->submissions, found, MOST);
        return -1;
    }
    qsort(c->name, (size_t)c->count, sizeof *c->name, by_name);
    return 0;
}

/* Whether what is at the path is where the submissions are. */
static int holds_submissions(const struct class *c, const char *path)
{
    struct stat here, there;
    return stat(c->submissions, &here) == 0 && stat(path, &there) == 0 && here.st_dev == there.st_dev &&
           here.st_ino == there.st_ino;
}

/* No student's results go where the submissions are read. */
static int check_students(const struct class *c)
{
    char student[300], path[LAB_MOST_PATH + 400];
    for (int k = 0; k < c->count; k++) {
        student_of(c, c->name[k], student);
        snprintf(path, sizeof path, "%s/%s", c->out, student);
        if (holds_submissions(c, path)) {
            refuse_line("--out %s: the results of '%s' would go to the submissions; choose another folder", c->out,
                        student);
            return -1;
        }
    }
    return 0;
}

static int write_tables(const struct class *c, json_t *all)
{
    char path[LAB_MOST_PATH + 64];
    size_t k, r;
    const json_t *result, *row;
    snprintf(path, sizeof path, "%s/results.json", c->out);
    if (put_json(path, all) != 0)
        return -1;
    snprintf(path, sizeof path, "%s/results.csv", c->out);
    struct output *csv = output_open(path);
    if (csv == NULL)
        return -1;
    FILE *table = output_stream(csv);
    struct junit *cases = junit_new();
    fputs("student,points,of", table);
    json_array_foreach(json_object_get(json_array_get(all, 0), "requirements"), r, row)
        fprintf(table, ",%s", member(row, "name"));
    fputc('\n', table);
    json_array_foreach(all, k, result)
    {
        put_cell(table, member(result, "student"));
        fprintf(table, ",%lld,%lld", (long long)json_integer_value(json_object_get(result, "points")),
                (long long)json_integer_value(json_object_get(result, "of")));
        json_array_foreach(json_object_get(result, "requirements"), r, row)
        {
            int right = json_equal(json_object_get(row, "points"), json_object_get(row, "of"));
            char *story = right ? NULL : story_of(row);
            fprintf(table, ",%lld", (long long)json_integer_value(json_object_get(row, "points")));
            junit_add(cases, member(result, "student"), member(row, "name"), 0, right ? NULL : "not right", story);
            free(story);
        }
        fputc('\n', table);
    }
    snprintf(path, sizeof path, "%s/junit.xml", c->out);
    int unwritten = output_close(csv);
    return unwritten != 0 ? unwritten : junit_write(cases, c->lab->name, path);
}

/* The results that were written, and of what has none, that it was not graded; NULL where that cannot be written. */
static json_t *gather(const struct class *c, const struct board *board, int *missing)
{
    json_t *all = json_array();
    char path[LAB_MOST_PATH + 400], student[300], shown[1000];
    for (int k = 0; k < c->count; k++) {
        student_of(c, c->name[k], student);
        snprintf(path, sizeof path, "%s/%s/result.json", c->out, student);
        json_t *result = board->graded[k] ? json_load_file(path, 0, NULL) : NULL;
        if (result == NULL) {
            result = nothing(c, "it was not graded: the grader ended");
            ++*missing;
            if (write_result(c, student, result) != 0) {
                json_decref(result);
                json_decref(all);
                return NULL;
            }
        }
        json_object_set_new(result, "student", json_string(shown_name(student, shown)));
        json_array_append_new(all, result);
    }
    return all;
}

int lab_grade(const struct lab *lab, const char *submissions, const char *out, int jobs, const char *seed)
{
    struct class *c = calloc(1, sizeof *c);
    struct board *board = mmap(NULL, sizeof *board, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    int lock = memfd_create("cagd", MFD_CLOEXEC);
    if (c == NULL || board == MAP_FAILED || lock < 0)
        abort();
    *c = (struct class){.lab = lab, .submissions = submissions, .out = out};
    int missing = 0, code = EXIT_USAGE;
    if (find(c) == 0 && check_students(c) == 0 && make_folder(out) == 0) {
        fflush(NULL);
        for (int k = 0; k < jobs && k < c->count; k++)
            if (fork() == 0)
                _exit(work(c, board, lock));
        while (wait(NULL) > 0 || errno == EINTR)
            ;
        json_t *all = board->stopped ? NULL : gather(c, board, &missing);
        code = all != NULL && write_tables(c, all) == 0 && missing == 0 ? EXIT_AS_EXPECTED : EXIT_INTERNAL;
        if (all != NULL)
            printf("%d submissions of %s, seed %s: %s/results.csv; %d not graded\n", c->count, lab->name, seed, out,
                   missing);
        json_decref(all);
    }
    close(lock);
    for (int k = 0; k < c->count; k++)
        free(c->name[k]);
    free(c);
    munmap(board, sizeof *board);
    return code;
}
