#include "cli/fit/tags.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Behind the next `what`, or the end of the text. */
static const char *behind(const char *s, const char *what)
{
    const char *found = strstr(s, what);
    return found != NULL ? found + strlen(what) : s + strlen(s);
}

/* The '>' of a tag: one in quotes is none. */
static const char *end_of_tag(const char *s)
{
    char quote = '\0';
    for (; *s != '\0' && (quote != '\0' || *s != '>'); s++)
        if (quote != '\0' ? *s == quote : *s == '"' || *s == '\'')
            quote = quote != '\0' ? '\0' : *s;
    return s;
}

int next_tag(struct reader *r, struct tag *t)
{
    const char *s = r->next;
    while ((s = strchr(s, '<')) != NULL) {
        if (strncmp(s, "<!--", 4) == 0)
            s = behind(s, "-->");
        else if (strncmp(s, "<![CDATA[", 9) == 0)
            s = behind(s, "]]>");
        else if (s[1] == '!' || s[1] == '?')
            s = behind(s, ">");
        else
            break;
    }
    if (s == NULL || *s == '\0')
        return 0;
    go_to(r, s);
    s++;
    t->closes = *s == '/';
    s += t->closes;
    t->name = s;
    t->length = strcspn(s, " \t\r\n/>");
    t->attributes = s + t->length;
    t->end = end_of_tag(t->attributes);
    r->next = (char *)t->end + (*t->end == '>');
    return 1;
}

int is_tag(const struct tag *t, const char *name)
{
    const char *colon = memchr(t->name, ':', t->length), *own = colon != NULL ? colon + 1 : t->name;
    size_t length = t->length - (size_t)(own - t->name);
    return strlen(name) == length && strncasecmp(own, name, length) == 0;
}

const char *tag_attribute(const struct tag *t, const char *name, const char **value)
{
    for (const char *s = t->attributes; s < t->end;) {
        s += strspn(s, " \t\r\n/");
        size_t length = strcspn(s, "= \t\r\n>");
        const char *own = s, *is = s + length + strspn(s + length, " \t\r\n");
        if (*is != '=' || is >= t->end)
            return NULL;
        is += 1 + strspn(is + 1, " \t\r\n");
        if (*is != '"' && *is != '\'')
            return NULL;
        const char *stop = strchr(is + 1, *is);
        if (stop == NULL || stop > t->end)
            return NULL;
        if (strlen(name) == length && strncmp(own, name, length) == 0) {
            *value = is + 1;
            return stop;
        }
        s = stop + 1;
    }
    return NULL;
}

int read_number(const char **s, const char *end, double *x)
{
    char *stop;
    const char *at = *s + (**s == '-' || **s == '+');
    if (*s >= end || (strspn(at, "0123456789") == 0 && !(*at == '.' && strspn(at + 1, "0123456789") > 0)) ||
        (at[0] == '0' && (at[1] == 'x' || at[1] == 'X')))
        return 0;
    *x = strtod(*s, &stop);
    if (stop > end || !isfinite(*x))
        return 0;
    *s = stop;
    return 1;
}
