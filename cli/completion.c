/* completion.c -- what bash, zsh and fish complete, made from the commands and their options.
 *
 * A shell completes the names of the commands, of the options of a command, the words that an option takes, and
 * arguments: names that `cagd list --names` and `cagd figures --list` print, or files. */
#include "cli/commands.h"
#include "cli/output.h"

#include <stdio.h>
#include <string.h>

/* Between single quotes, each of which is closed, escaped and opened again; a backslash before each of `special`. */
static void put_quoted(FILE *out, const char *text, const char *special)
{
    for (; *text != '\0'; text++)
        if (*text == '\'')
            fputs("'\\''", out);
        else
            fprintf(out, "%s%c", strchr(special, *text) != NULL ? "\\" : "", *text);
}

/* The words that the option takes, or NULL. */
static const char *words_of(const struct command *c, const char *option)
{
    for (const struct option_words *w = c->words; w != NULL && w->option != NULL; w++)
        if (strcmp(w->option, option) == 0)
            return w->words;
    return NULL;
}

static int takes_file(const struct argp_option *row)
{
    return is_written_file(row) || is_written_folder(row) || is_read_file(row);
}

struct page {
    FILE *out;
    const struct command *command;
};

/* ---- bash -------------------------------------------------------------------------------------------- */

static void put_bash_name(void *context, const struct argp_option *row)
{
    const struct page *p = context;
    fprintf(p->out, "--%s ", row->name);
}

static void put_bash_value(void *context, const struct argp_option *row)
{
    const struct page *p = context;
    const char *words = words_of(p->command, row->name);
    if (row->arg == NULL)
        return;
    fprintf(p->out, "    '%s --%s') ", p->command->name, row->name);
    if (words != NULL)
        fprintf(p->out, "COMPREPLY=($(compgen -W '%s' -- \"$word\")) ;;\n", words);
    else
        fputs(takes_file(row) ? "COMPREPLY=($(compgen -f -- \"$word\")) ;;\n" : "COMPREPLY=() ;;\n", p->out);
}

static void put_bash(FILE *out)
{
    static const char *const arguments[] = {[NO_ARGUMENTS] = "-W ''",
                                            [CLAIM_NAMES] = "-W \"$(cagd list --names 2>/dev/null)\"",
                                            [FIGURE_NAMES] = "-W \"$(cagd figures --list 2>/dev/null)\"",
                                            [FILE_NAME] = "-f",
                                            [WORDS] = "-f"};
    fputs(
        "# bash completion for cagd\n"
        "_cagd() {\n"
        "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]} "
        "known=\n"
        "    # Bash breaks words at a colon, and an id has one: it is put together again, and what is before the last\n"
        "    # colon, which stands there already, is taken from the answers.\n"
        "    local line=${COMP_LINE:0:COMP_POINT}\n"
        "    line=${line##*[[:blank:]]}\n"
        "    if [[ $line == *\"$word\" && $line == *:* && ( $word == : || $word != *:* ) ]]; then\n"
        "        known=${line%:*}: word=$line\n"
        "        local k=$COMP_CWORD\n"
        "        while ((k > 1)) && [[ ${COMP_WORDS[k]} == : || ${COMP_WORDS[k - 1]} == : ]]; do ((k--)); done\n"
        "        before=${COMP_WORDS[k - 1]}\n"
        "    fi\n"
        "    _cagd_answers\n"
        "    COMPREPLY=(\"${COMPREPLY[@]#\"$known\"}\")\n"
        "}\n"
        "_cagd_answers() {\n"
        "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
        "        COMPREPLY=($(compgen -W '",
        out);
    for (int k = 0; commands[k] != NULL; k++)
        fprintf(out, "%s ", commands[k]->name);
    fputs("--help --version' -- \"$word\"))\n"
          "        return\n"
          "    fi\n"
          "    case \"$command $before\" in\n",
          out);
    for (int k = 0; commands[k] != NULL; k++)
        visit_options(commands[k], put_bash_value, &(struct page){out, commands[k]});
    fputs("    *)\n"
          "        case \"$command $word\" in\n",
          out);
    for (int k = 0; commands[k] != NULL; k++) {
        fprintf(out, "        '%s -'*) COMPREPLY=($(compgen -W '", commands[k]->name);
        visit_options(commands[k], put_bash_name, &(struct page){out, commands[k]});
        fprintf(out, "--help' -- \"$word\")) ;;\n        '%s '*) COMPREPLY=($(compgen %s -- \"$word\")) ;;\n",
                commands[k]->name, arguments[commands[k]->arguments]);
    }
    fputs("        esac ;;\n"
          "    esac\n"
          "}\n"
          "complete -F _cagd cagd\n",
          out);
}

/* ---- zsh --------------------------------------------------------------------------------------------- */

static void put_zsh_option(void *context, const struct argp_option *row)
{
    const struct page *p = context;
    const char *words = words_of(p->command, row->name);
    fprintf(p->out, "            '*--%s%s[", row->name, row->arg != NULL ? "=" : "");
    put_quoted(p->out, row->doc, "[]:\\");
    fputc(']', p->out);
    if (row->arg != NULL) {
        fputc(':', p->out);
        put_quoted(p->out, row->arg, ":\\");
        fputc(':', p->out);
    }
    if (words != NULL)
        fprintf(p->out, "(%s)", words);
    else if (takes_file(row))
        fputs("_files", p->out);
    fputs("' \\\n", p->out);
}

static void put_zsh(FILE *out)
{
    static const char *const arguments[] = {[NO_ARGUMENTS] = ":: :",
                                            [CLAIM_NAMES] = "*:name:{compadd -- $(cagd list --names 2>/dev/null)}",
                                            [FIGURE_NAMES] = "*:figure:{compadd -- $(cagd figures --list 2>/dev/null)}",
                                            [FILE_NAME] = ":file:_files",
                                            [WORDS] = "*:file:_files"};
    fputs("#compdef cagd\n"
          "# zsh completion for cagd\n"
          "if (( CURRENT == 2 )); then\n"
          "    local -a commands=(\n",
          out);
    for (int k = 0; commands[k] != NULL; k++) {
        fprintf(out, "        '%s:", commands[k]->name);
        put_quoted(out, commands[k]->summary, "\\");
        fputs("'\n", out);
    }
    fputs("    )\n"
          "    _describe command commands\n"
          "else\n"
          "    local command=$words[2]\n"
          "    shift words\n"
          "    (( CURRENT-- ))\n"
          "    case $command in\n",
          out);
    for (int k = 0; commands[k] != NULL; k++) {
        fprintf(out, "    %s)\n        _arguments \\\n", commands[k]->name);
        visit_options(commands[k], put_zsh_option, &(struct page){out, commands[k]});
        fprintf(out, "            '--help[Explain the command]' \\\n            '%s' ;;\n",
                arguments[commands[k]->arguments]);
    }
    fputs("    esac\n"
          "fi\n",
          out);
}

/* ---- fish -------------------------------------------------------------------------------------------- */

static void put_fish_option(void *context, const struct argp_option *row)
{
    const struct page *p = context;
    const char *words = words_of(p->command, row->name);
    fprintf(p->out, "complete -c cagd -n '__fish_seen_subcommand_from %s' -l %s", p->command->name, row->name);
    if (row->arg != NULL)
        fputs(takes_file(row) ? " -r -F" : " -x", p->out);
    if (words != NULL)
        fprintf(p->out, " -a '%s'", words);
    fputs(" -d '", p->out);
    put_quoted(p->out, row->doc, "\\");
    fputs("'\n", p->out);
}

static void put_fish(FILE *out)
{
    static const char *const arguments[] = {[NO_ARGUMENTS] = "-f",
                                            [CLAIM_NAMES] = "-f -a '(cagd list --names 2>/dev/null)'",
                                            [FIGURE_NAMES] = "-f -a '(cagd figures --list 2>/dev/null)'",
                                            [FILE_NAME] = "-F",
                                            [WORDS] = "-F"};
    fputs("# fish completion for cagd\n", out);
    for (int k = 0; commands[k] != NULL; k++) {
        fprintf(out, "complete -c cagd -n __fish_use_subcommand -f -a %s -d '", commands[k]->name);
        put_quoted(out, commands[k]->summary, "\\");
        fputs("'\n", out);
    }
    fputs("complete -c cagd -l help -d 'Explain'\n", out);
    for (int k = 0; commands[k] != NULL; k++) {
        fprintf(out, "complete -c cagd -n '__fish_seen_subcommand_from %s' %s\n", commands[k]->name,
                arguments[commands[k]->arguments]);
        visit_options(commands[k], put_fish_option, &(struct page){out, commands[k]});
    }
}

int write_completions(const char *folder)
{
    static const struct {
        const char *name;
        void (*put)(FILE *out);
    } shells[] = {{"cagd.bash", put_bash}, {"_cagd", put_zsh}, {"cagd.fish", put_fish}};
    for (int k = 0; k < 3; k++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s", folder, shells[k].name);
        struct output *o = output_open(path);
        if (o == NULL)
            return -1;
        shells[k].put(output_stream(o));
        if (output_close(o) != 0)
            return -1;
    }
    return 0;
}
