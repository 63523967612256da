#include "cli/command.h"

#include <stdlib.h>

void parse_arguments(const struct argp *argp, int argc, char **argv, void *input)
{
    argp_err_exit_status = EXIT_USAGE;
    if (argp_parse(argp, argc, argv, 0, NULL, input) != 0)
        exit(EXIT_USAGE);
}

int whole_number(struct argp_state *state, const char *option, const char *text, int low, int high)
{
    char *end;
    long value = strtol(text, &end, 10);
    if (*text == '\0' || *end != '\0' || value < low || value > high)
        argp_error(state, "%s takes a whole number from %d to %d, not '%s'", option, low, high, text);
    return (int)value;
}
