/* Somebody's Horner scheme, as it stands: at a point, and for all of them. */
#include <cagd_exactly.h>
#include <stdio.h>
int main(int argc, char **argv)
{
    struct cagd_exactly_code code = {.source = argc > 1 ? argv[1] : "",
                                     .declare = "double horner(int n, const double *p, double t);",
                                     .input = "p[3]; t",
                                     .call = "double R = horner(2, p, t);",
                                     .output = "R"};
    char message[400];
    struct cagd_exactly *x = cagd_exactly_load(&code, sizeof message, message);
    if (x == NULL)
        return puts(message), 1;
    cagd_exactly_set(x, "p", 3, (const char *[]){"0", "1", "1/3"});
    cagd_exactly_set(x, "t", 1, (const char *[]){"2/7"});
    if (cagd_exactly_call(x, CAGD_EXACTLY_RATIONAL) == CAGD_EXACTLY_DONE)
        printf("%s ", cagd_exactly_get(x, "R"));
    if (cagd_exactly_call(x, CAGD_EXACTLY_FIELD) == CAGD_EXACTLY_DONE)
        printf("%s\n", cagd_exactly_function(x, "R"));
    return cagd_exactly_free(x), 0;
}
