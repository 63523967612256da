/* lab.c -- cagd lab: assignments, and a grader that decides by exact computation. */
#include "cli/lab/lab.h"
#include "cli/commands.h"
#include "cli/layout.h"
#include "cli/output.h"
#include "cli/refuse.h"
#include "cli/report.h"
#include "cli/terminal.h"

#include <errno.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

struct arguments {
    struct asked asked;
    const char *play, *out, *seed, *lab, *svg;
    int watch;
};

/* A lab by its name, or by its folder where the text has a slash. */
static struct lab *lab_called(const char *name, const char *seed)
{
    char folder[LAB_MOST_PATH], path[LAB_MOST_PATH + 300], cause[LAB_CAUSE] = "";
    if (strchr(name, '/') != NULL || access("lab.md", R_OK) == 0)
        snprintf(path, sizeof path, "%s", name);
    else if (lab_folder(folder) == 0)
        snprintf(path, sizeof path, "%s/%s", folder, name);
    else
        path[0] = 0;
    struct lab *lab = lab_read(path, seed, cause);
    char own[LAB_MOST_PATH];
    snprintf(own, sizeof own, "%s/lab.md", name);
    if (lab == NULL && access(path, F_OK) != 0)
        refuse_line(access(own, R_OK) == 0 ? "there is no lab '%s'; the folder of that name is ./%s"
                                           : "there is no lab '%s'; cagd lab lists them",
                    name, name);
    else if (lab == NULL)
        refuse_line("%s: %s; cagd lab lists the labs", name, cause);
    return lab;
}

/* The lab whose file is in the folder. */
static struct lab *lab_of(const char *folder, const char *seed)
{
    static const char *const ends[] = {"c", "py", "txt"};
    json_t *names = lab_names();
    struct lab *lab = NULL;
    size_t k;
    const json_t *name;
    char path[LAB_MOST_PATH + 128];
    json_array_foreach(names, k, name) for (size_t e = 0; lab == NULL && e < sizeof ends / sizeof *ends; e++)
    {
        snprintf(path, sizeof path, "%s/%s.%s", folder, json_string_value(name), ends[e]);
        if (access(path, R_OK) == 0)
            lab = lab_called(json_string_value(name), seed);
    }
    if (lab == NULL)
        refuse_line(access(folder, X_OK) == 0
                        ? "%s: there is no file of a lab, such as de-casteljau.c; --lab names the lab"
                        : "%s: there is no such folder; cagd lab start NAME writes one",
                    folder);
    json_decref(names);
    return lab;
}

/* ---- list ------------------------------------------------------------------------------------------------ */

static int points_of(const struct lab *lab)
{
    int sum = 0;
    size_t k;
    const json_t *block;
    json_array_foreach(lab->blocks, k, block) if (strcmp(json_string_value(json_object_get(block, "kind")),
                                                         "requirement") == 0) sum += lab_points(block);
    return sum;
}

enum { MOST_WIDTH = 100, LIST_INDENT = 6, RUBRIC_INDENT = 33 };

static void print_head(const struct lab *lab)
{
    int used = printf("%s%-22s%s %2d points  ", style(stdout, BOLD), lab->name, style(stdout, PLAIN), points_of(lab)) -
               (int)strlen(style(stdout, BOLD)) - (int)strlen(style(stdout, PLAIN));
    put_behind(stdout, lab_text(lab->head, "title"), used, used, page_width(MOST_WIDTH));
    put_paragraph(stdout, lab_text(lab->head, "zh"), used, page_width(MOST_WIDTH));
    used = printf("%*s%s, chapter %s: ", LIST_INDENT, "", lab->language, lab_text(lab->head, "chapter"));
    put_behind(stdout, lab_text(lab->head, "learn"), used, LIST_INDENT, page_width(MOST_WIDTH));
}

/* What each requirement is worth: a lab gives its points by them, all or none of each. */
static void print_rubric(const struct lab *lab)
{
    size_t k;
    const json_t *block;
    json_array_foreach(lab->blocks, k, block)
    {
        const char *name = json_string_value(json_object_get(block, "name"));
        if (strcmp(json_string_value(json_object_get(block, "kind")), "requirement") != 0)
            continue;
        int used = printf("  %-20s %2d        ", name, lab_points(block));
        put_behind(stdout, lab_text(block, "title"), used, RUBRIC_INDENT, page_width(MOST_WIDTH));
        put_paragraph(stdout, lab_text(block, "zh"), RUBRIC_INDENT, page_width(MOST_WIDTH));
    }
}

static json_t *rubric_json(const struct lab *lab)
{
    json_t *rows = json_array();
    size_t k;
    const json_t *block;
    json_array_foreach(lab->blocks, k,
                       block) if (strcmp(json_string_value(json_object_get(block, "kind")), "requirement") == 0)
        json_array_append_new(rows, json_pack("{s:O, s:s, s:s, s:i}", "name", json_object_get(block, "name"), "title",
                                              lab_text(block, "title"), "zh", lab_text(block, "zh"), "points",
                                              lab_points(block)));
    return rows;
}

/* All labs, or that one with its rubric. */
static int list(const char *only, int as_json)
{
    json_t *names = only != NULL ? json_pack("[s]", only) : lab_names(), *rows = json_array();
    size_t k;
    const json_t *name;
    int code = EXIT_AS_EXPECTED;
    json_array_foreach(names, k, name)
    {
        struct lab *lab = lab_called(json_string_value(name), "0");
        if (lab == NULL) {
            code = only != NULL ? EXIT_USAGE : code;
            continue;
        }
        if (!as_json)
            print_head(lab);
        if (!as_json && only != NULL)
            print_rubric(lab);
        json_array_append_new(rows, json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:i, s:o}", "name", lab->name, "title",
                                              lab_text(lab->head, "title"), "zh", lab_text(lab->head, "zh"), "chapter",
                                              lab_text(lab->head, "chapter"), "learn", lab_text(lab->head, "learn"),
                                              "language", lab->language, "points", points_of(lab), "requirements",
                                              rubric_json(lab)));
        lab_free(lab);
    }
    if (as_json && code == EXIT_AS_EXPECTED)
        print_json(json_pack("{s:s, s:O}", "schema", "cagd-labs-1", "labs", rows));
    json_decref(rows);
    json_decref(names);
    return code;
}

/* ---- check ----------------------------------------------------------------------------------------------- */

/* Both curves of what is wrong; where nothing is, a line says so and nothing is written. */
static int write_picture(const char *path, const json_t *result)
{
    char *text = lab_picture("difference", result);
    if (text == NULL)
        refuse_line("%s: is not written; there is no other result to be drawn", path);
    int status = text != NULL ? write_text_file(path, text) : 0;
    free(text);
    return status;
}

/* The exit code. */
static int check_once(struct lab_bench *bench, const char *folder, const char *svg, int as_json)
{
    char path[LAB_MOST_PATH + 128];
    snprintf(path, sizeof path, "%s/%s", folder, bench->lab->file);
    char *answer = lab_file(path);
    if (answer == NULL) {
        refuse_line("%s: %s; expected the file of an answer", path,
                    errno == ELOOP    ? "is a symbolic link"
                    : errno == EINVAL ? "is no file of text, or too large a one"
                                      : strerror(errno));
        return EXIT_USAGE;
    }
    json_t *result = lab_judge(bench, answer, 0);
    int all = json_equal(json_object_get(result, "points"), json_object_get(result, "of"));
    free(answer);
    if (svg != NULL && write_picture(svg, result) != 0)
        return EXIT_INTERNAL;
    if (as_json) {
        print_json(result);
    } else {
        lab_print(bench->lab, result);
        json_decref(result);
    }
    return all ? EXIT_AS_EXPECTED : EXIT_NOT_AS_EXPECTED;
}

/* Again whenever the file is another one, until interrupted. */
static void watch(struct lab_bench *bench, const struct arguments *a, const char *folder)
{
    char path[LAB_MOST_PATH + 128];
    struct timespec seen = {0};
    snprintf(path, sizeof path, "%s/%s", folder, bench->lab->file);
    for (;;) {
        struct stat is;
        if (stat(path, &is) == 0 && (is.st_mtim.tv_sec != seen.tv_sec || is.st_mtim.tv_nsec != seen.tv_nsec)) {
            seen = is.st_mtim;
            fputs(is_terminal(stdout) ? "\033[2J\033[H" : "\n", stdout);
            check_once(bench, folder, a->svg, 0);
            fflush(stdout);
        }
        nanosleep(&(struct timespec){0, 200000000}, NULL);
    }
}

/* Whether the picture would take the place of the answer; a line says so. */
static int is_answer(const struct lab *lab, const char *folder, const char *svg)
{
    char path[LAB_MOST_PATH + 128];
    struct stat answer, picture;
    snprintf(path, sizeof path, "%s/%s", folder, lab->file);
    if (svg == NULL || stat(path, &answer) != 0 || stat(svg, &picture) != 0 || answer.st_dev != picture.st_dev ||
        answer.st_ino != picture.st_ino)
        return 0;
    refuse_line("--svg %s: is the answer, which is read; choose another name", svg);
    return 1;
}

static int check(const struct arguments *a, const char *folder)
{
    char cause[LAB_CAUSE];
    struct lab *lab = a->lab != NULL ? lab_called(a->lab, a->seed) : lab_of(folder, a->seed);
    struct lab_bench *bench = calloc(1, sizeof *bench);
    if (lab == NULL || bench == NULL || is_answer(lab, folder, a->svg)) {
        free(bench);
        lab_free(lab);
        return EXIT_USAGE;
    }
    int code = EXIT_USAGE;
    if (lab_bench_open(bench, lab, 1, cause) != 0) {
        refuse_line("%s: %s", lab->name, cause);
    } else {
        bench->draws = a->svg != NULL;
        if (a->watch)
            watch(bench, a, folder);
        code = check_once(bench, folder, a->svg, a->asked.json);
        lab_bench_close(bench);
    }
    free(bench);
    lab_free(lab);
    return code;
}

static int start(const struct arguments *a, const char *name, const char *folder)
{
    struct lab *lab = lab_called(name, a->seed);
    int code = lab != NULL ? lab_begin(lab, folder != NULL ? folder : lab->name) : EXIT_USAGE;
    lab_free(lab);
    return code;
}

static int grade(const struct arguments *a, const char *submissions)
{
    const char *why = lab_cannot_shut();
    struct lab *lab = NULL;
    if (a->out == NULL || a->lab == NULL)
        refuse_line("lab grade: expected 'cagd lab grade SUBMISSIONS --lab NAME --out DIR'");
    else if (why != NULL)
        refuse_line("submissions are graded in a sandbox only, and there is none: %s", why);
    else
        lab = lab_called(a->lab, a->seed);
    int code = lab != NULL ? lab_grade(lab, submissions, a->out, a->asked.jobs, a->seed) : EXIT_USAGE;
    lab_free(lab);
    return code;
}

/* ---- the words -------------------------------------------------------------------------------------------- */

static int run_list(const struct arguments *a, const char *name, const char *none)
{
    (void)none;
    return list(name, a->asked.json);
}

static int run_check(const struct arguments *a, const char *folder, const char *none)
{
    (void)none;
    return check(a, folder);
}

static int run_grade(const struct arguments *a, const char *submissions, const char *none)
{
    (void)none;
    return grade(a, submissions);
}

static int run_new(const struct arguments *a, const char *name, const char *none)
{
    (void)a, (void)none;
    return lab_new(name);
}

static int run_test(const struct arguments *a, const char *folder, const char *none)
{
    (void)none;
    return lab_test(folder, a->asked.json);
}

enum { LAB = 1, OUT = 2, SEED = 4, WATCH = 8, JSON = 16, SVG = 32 };

/* What each word takes: so many words with itself, and these options. */
static const struct form {
    const char *verb, *usage;
    int fewest, most, options;
    int (*run)(const struct arguments *a, const char *first, const char *second);
} forms[] = {{"list", "list [NAME]", 0, 2, JSON, run_list},
             {"start", "start NAME [DIR]", 2, 3, 0, start},
             {"check", "check DIR", 2, 2, LAB | SEED | WATCH | JSON | SVG, run_check},
             {"grade", "grade SUBMISSIONS", 2, 2, LAB | OUT | SEED, run_grade},
             {"new", "new NAME", 2, 2, 0, run_new},
             {"test", "test DIR", 2, 2, JSON, run_test}};

/* The form that the first word names, list without words; NULL and a line on stderr when there is none. */
static const struct form *form_of(const struct arguments *a)
{
    const char *verb = a->asked.patterns.count > 0 ? a->asked.patterns.at[0] : "list";
    for (size_t k = 0; k < sizeof forms / sizeof *forms; k++)
        if (strcmp(verb, forms[k].verb) == 0)
            return &forms[k];
    refuse_line("lab: there is no '%s'; expected list, start, check, grade, new or test", verb);
    return NULL;
}

/* Whether the path, of which the last parts may be missing, is the folder or in it. */
static int is_inside(const char *folder, const char *path)
{
    char whole[PATH_MAX], there[PATH_MAX], part[PATH_MAX];
    if (realpath(folder, whole) == NULL)
        return 0;
    snprintf(part, sizeof part, "%s", path);
    while (realpath(part, there) == NULL) {
        char *end = strrchr(part, '/');
        snprintf(end != NULL ? end + (end == part) : part, 2, end == NULL ? "." : "");
        if (end == part)
            break;
    }
    size_t length = strlen(whole);
    return strncmp(whole, there, length) == 0 && (there[length] == '/' || there[length] == '\0');
}

/* Whether the words and the options that were given are those of the form; otherwise a line on stderr. */
static int takes(const struct form *f, const struct arguments *a)
{
    int words = a->asked.patterns.count;
    const struct {
        const char *name;
        int option, given;
    } options[] = {
        {"lab", LAB, a->lab != NULL}, {"out", OUT, a->out != NULL}, {"seed", SEED, strcmp(a->seed, "0") != 0},
        {"watch", WATCH, a->watch},   {"svg", SVG, a->svg != NULL}, {"json", JSON, a->asked.json}};
    if (words < f->fewest || words > f->most) {
        refuse_line("lab: expected 'cagd lab %s'; cagd help lab has examples", f->usage);
        return 0;
    }
    for (size_t k = 0; k < sizeof options / sizeof *options; k++)
        if (options[k].given && !(f->options & options[k].option)) {
            refuse_line("lab %s: does nothing with --%s; leave it out", f->verb, options[k].name);
            return 0;
        }
    if (a->watch && a->asked.json) {
        refuse_line("lab check: --watch shows pages, not --json; leave one of them out");
        return 0;
    }
    if (f->run == run_grade && a->out != NULL && is_inside(a->asked.patterns.at[1], a->out)) {
        refuse_line("--out %s: is in '%s', which is read; choose another folder", a->out, a->asked.patterns.at[1]);
        return 0;
    }
    return 1;
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    const struct form *f;
    switch (key) {
    case 'P':
        a->play = arg;
        return 0;
    case 'o':
        a->out = arg;
        return 0;
    case 's':
        a->seed = arg;
        return 0;
    case 'l':
        a->lab = arg;
        return 0;
    case 'g':
        a->svg = arg;
        return 0;
    case 'w':
        a->watch = 1;
        return 0;
    case ARGP_KEY_END: /* before folders are made */
        f = form_of(a);
        if (a->play == NULL && (f == NULL || !takes(f, a)))
            exit(EXIT_USAGE);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static int run(const struct call *call)
{
    struct arguments a = {.seed = "0"};
    parse_arguments(call, &a.asked);
    signal(SIGPIPE, SIG_IGN);
    if (a.play != NULL)
        return lab_play(a.play);
    char **word = a.asked.patterns.at;
    int words = a.asked.patterns.count;
    return form_of(&a)->run(&a, words > 1 ? word[1] : NULL, words > 2 ? word[2] : NULL);
}

static const struct argp_option options[] = {
    {"lab", 'l', "NAME", 0, "The lab, or a folder with a slash in its name (default: by the file that is in DIR)", 0},
    {"out", 'o', "DIR", 0, "Where grade writes its results", 0},
    {"seed", 's', "TEXT", 0, "What the numbers that decide are drawn from (0)", 0},
    {"svg", 'g', "FILE", 0, "Draw what is wrong: the results of check over what is expected", 0},
    {"watch", 'w', 0, 0, "Check again whenever the file is saved", 0},
    {"play", 'P', "OBJECT", OPTION_HIDDEN, "Run the code of a submission for the grader", 0},
    {0}};

const struct command command_lab = {
    .name = "lab",
    .summary = "assignments in ordinary C or Python, and a grader that decides them by exact computation",
    .example = "  cagd lab start de-casteljau      an assignment, which cagd lab check judges\n",
    .usage = "[list [NAME] | start NAME [DIR] | check DIR | grade SUBMISSIONS | new NAME | test DIR]",
    .text =
        "Labs are assignments about the chapters. A solution is an ordinary function in C or Python, or a file of "
        "numbers and formulas; it is run in exact arithmetic and on rational functions of its inputs, so a requirement "
        "is right for all inputs of a shape, or there are small numbers for which it is wrong.\n\n"
        "Without words, or with list: the labs; with the name of one also what each requirement is worth. start writes "
        "an assignment into a folder, by default of its name, with a file to begin with: NAME.c, NAME.py or NAME.txt; "
        "check judges that file in DIR; grade judges a folder of them, each in a sandbox; new and test make labs of "
        "one's own.\n\n"
        "Examples:\n"
        "  cagd lab\n"
        "  cagd lab list de-casteljau\n"
        "  cagd lab start de-casteljau\n"
        "  cagd lab check de-casteljau --watch\n"
        "  cagd lab check de-casteljau --svg difference.svg\n"
        "  cagd lab start de-casteljau-python\n"
        "  cagd lab grade submissions --lab de-casteljau --out results --seed 2026\n",
    .arguments = WORDS,
    .shared = TAKES_JSON | TAKES_JOBS,
    .options = options,
    .parse = parse,
    .run = run,
};
