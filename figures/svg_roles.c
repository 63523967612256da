/* svg_roles.c -- what a role looks like: on light, on dark and on paper.
 *
 * The colours of curves differ in lightness as well as in hue (blue, orange, magenta, green: the
 * distinctions that survive every common colour blindness), and each line has its own dashes. */
#include "figures/svg_parts.h"

enum theme { LIGHT, DARK, PRINT, THEMES };

static const struct role {
    const char *name, *colour[THEMES], *line;
    enum svg_shape shape;
} roles[SVG_ROLES] = {
    [SVG_CURVE] = {"curve", {"#0b5cad", "#6db3f8", "#000"}, "stroke-width:2.2", SVG_DISC},
    [SVG_CURVE_2] = {"curve-2",
                     {"#c2570c", "#f0a35e", "#333"},
                     "stroke-width:2;stroke-dasharray:9 4;stroke-linecap:butt",
                     SVG_SQUARE},
    [SVG_POLYGON] = {"polygon", {"#64708a", "#98a4b8", "#555"}, "stroke-width:1.1", SVG_RING},
    [SVG_FAMILY] = {"family", {"#7299c2", "#5f8cba", "#888"}, "stroke-width:.95", SVG_DISC},
    [SVG_POINT] = {"point", {"#1d2433", "#e7eaf0", "#000"}, "stroke-width:1.3", SVG_DISC},
    [SVG_WRONG] = {"wrong",
                   {"#b3186d", "#f27fb2", "#333"},
                   "stroke-width:2;stroke-dasharray:5 3.5;stroke-linecap:butt",
                   SVG_CROSS},
    [SVG_RIGHT] = {"right", {"#00735c", "#4fd0ae", "#000"}, "stroke-width:2.2", SVG_DIAMOND},
    [SVG_MUTED] = {"muted",
                   {"#6d7787", "#8590a3", "#777"},
                   "stroke-width:1;stroke-dasharray:1.2 3;stroke-linecap:butt",
                   SVG_RING},
    [SVG_AXIS] = {"axis", {"#5b6576", "#97a1b2", "#444"}, "stroke-width:.9", SVG_DISC},
    [SVG_FILL] = {"fill", {"#0b5cad", "#6db3f8", "#666"}, "stroke-width:1", SVG_DISC},
};

/* The colours of what is no role. */
enum { PAPER, GRID, GROUNDS };
static const struct {
    const char *name, *colour[THEMES];
} ground[GROUNDS] = {
    [PAPER] = {"paper", {"#fff", "#14181f", "#fff"}},
    [GRID] = {"grid", {"#e6e9ef", "#272e39", "#ddd"}},
};

const char *role_class(svg *s, enum svg_role role)
{
    s->used[role] = true;
    return roles[role].name;
}

void put_area_class(svg *s, struct string *out, enum svg_role role)
{
    if (role == SVG_WRONG) {
        s->hatched = true;
        put(out, "class=\"%s\" fill=\"url(#%s-hatch)\"", role_class(s, role), s->name);
    } else {
        put(out, "class=\"a %s\"", role_class(s, role));
    }
}

void put_mark(svg *s, struct string *out, long x, long y, enum svg_role role, enum svg_shape shape)
{
    const char *class = role_class(s, role);
    /* Points are of one scale: shapes of the same weight to the eye, for a disc of radius 3.3. */
    enum { DISC = 330, SQUARE = 297, DIAMOND = 420, CROSS = 360 };
    switch (shape == SVG_USUAL ? roles[role].shape : shape) {
    case SVG_RING:
        put(out, "<circle class=\"o %s\" cx=\"%h\" cy=\"%h\" r=\"%h\"/>\n", class, x, y, (long)DISC);
        break;
    case SVG_SQUARE:
        put(out, "<path class=\"m %s\" d=\"M%h %hH%hV%hH%hZ\"/>\n", class, x - SQUARE, y - SQUARE, x + SQUARE,
            y + SQUARE, x - SQUARE);
        break;
    case SVG_DIAMOND:
        put(out, "<path class=\"m %s\" d=\"M%h %hL%h %hL%h %hL%h %hZ\"/>\n", class, x - DIAMOND, y, x, y - DIAMOND,
            x + DIAMOND, y, x, y + DIAMOND);
        break;
    case SVG_CROSS: /* on a disc of paper, which parts it from a line through the point */
        put(out, "<circle class=\"paper\" cx=\"%h\" cy=\"%h\" r=\"%h\"/>\n", x, y, (long)(CROSS * 4 / 3));
        put(out, "<path class=\"x %s\" d=\"M%h %hL%h %hM%h %hL%h %h\"/>\n", class, x - CROSS, y - CROSS, x + CROSS,
            y + CROSS, x - CROSS, y + CROSS, x + CROSS, y - CROSS);
        break;
    default:
        put(out, "<circle class=\"m %s\" cx=\"%h\" cy=\"%h\" r=\"%h\"/>\n", class, x, y, (long)DISC);
    }
}

static void put_variables(const svg *s, struct string *out, enum theme theme)
{
    put(out, ".cagd{");
    for (int k = 0; k < GROUNDS; k++)
        put(out, "--%s:%s;", ground[k].name, ground[k].colour[theme]);
    for (int k = 0; k < SVG_ROLES; k++)
        if (s->used[k])
            put(out, "--%s:%s;", roles[k].name, roles[k].colour[theme]);
    put(out, "}");
}

/* Viewers without CSS variables drop the second declaration of a colour and keep the first. */
static void put_colour(struct string *out, const char *property, const char *light, const char *name)
{
    put(out, "%s:%s;%s:var(--%s)", property, light, property, name);
}

static void put_ground(struct string *out, const char *selector, const char *property, int k, const char *rest)
{
    put(out, ".cagd %s{", selector);
    put_colour(out, property, ground[k].colour[LIGHT], ground[k].name);
    put(out, "%s}\n", rest);
}

void put_style(svg *s, struct string *out)
{
    if (s->hatched)
        put(out,
            "<defs>\n<pattern id=\"%s-hatch\" class=\"%s\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\" "
            "patternTransform=\"rotate(45)\">\n<path class=\"h\" d=\"M0 2.5H5\"/>\n</pattern>\n</defs>\n",
            s->name, role_class(s, SVG_WRONG));
    put(out, "<style>\n");
    put_variables(s, out, LIGHT);
    put(out, "\n@media (prefers-color-scheme:dark){");
    put_variables(s, out, DARK);
    put(out, "}\n@media print{");
    put_variables(s, out, PRINT);
    put(out, "}\n.cagd{max-width:100%%;height:auto}\n");
    put_ground(out, ".paper", "fill", PAPER, "");
    put_ground(out, ".grid", "stroke", GRID, ";fill:none;stroke-width:1");
    for (int k = 0; k < SVG_ROLES; k++)
        if (s->used[k]) {
            put(out, ".cagd .%s{", roles[k].name);
            put_colour(out, "color", roles[k].colour[LIGHT], roles[k].name);
            put(out, "}\n.cagd .l.%s{%s}\n", roles[k].name, roles[k].line);
        }
    put(out, ".cagd .l{fill:none;stroke:currentColor;stroke-linejoin:round}\n"
             ".cagd .a{fill:currentColor;fill-opacity:.13}\n"
             ".cagd .c{fill:currentColor}\n"
             ".cagd .h{stroke:currentColor;stroke-width:.8;stroke-opacity:.6}\n");
    if (s->clouded)
        put(out, ".cagd .p{fill:none;stroke:currentColor;stroke-linecap:round;stroke-opacity:.5}\n");
    put_ground(out, ".m", "stroke", PAPER, ";fill:currentColor;stroke-width:1.1");
    put_ground(out, ".o", "fill", PAPER, ";stroke:currentColor;stroke-width:1.4");
    put(out, ".cagd .x{fill:none;stroke:currentColor;stroke-width:2}\n");
    put(out, ".cagd text{font-family:\"Source Sans 3\",\"Helvetica Neue\",Helvetica,Arial,sans-serif;"
             "fill:currentColor;font-size:14.5px}\n"
             ".cagd text.n{font-size:12.5px}\n"
             ".cagd text.k{font-size:11.5px}\n"
             ".cagd text.d{font-size:13.5px;font-weight:600}\n"
             ".cagd text.t{font-size:16px;font-weight:600}\n"
             ".cagd .i,.cagd .u{font-family:\"STIX Two Text\",\"Times New Roman\",Times,serif;font-size:1.12em}\n"
             ".cagd .i{font-style:italic}\n"
             ".cagd .s{font-size:.8em}\n");
    put_ground(out, ".halo", "stroke", PAPER, ";paint-order:stroke;stroke-width:3.4;stroke-linejoin:round");
    put(out, "</style>\n");
}
