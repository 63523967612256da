/* printed-table.h -- the worked table of the slides as it is printed, and the points of its curve. */
#ifndef CAGD_BEZIER_PRINTED_TABLE_H
#define CAGD_BEZIER_PRINTED_TABLE_H

/* The parameter, the four functions, the point. */
static const struct printed_row {
    const char *t, *basis[4], *point[2];
} printed_table[7] = {
    {"0", {"1", "0", "0", "0"}, {"1", "1"}},
    {"0.15", {"0.614", "0.325", "0.0574", "0.0034"}, {"1.5058", "1.765"}},
    {"0.35", {"0.275", "0.444", "0.239", "0.043"}, {"2.248", "2.376"}},
    {"0.5", {"0.125", "0.375", "0.375", "0.125"}, {"2.75", "2.5"}},
    {"0.65", {"0.043", "0.239", "0.444", "0.275"}, {"3.122", "2.36"}},
    {"0.85", {"0.0034", "0.0574", "0.325", "0.614"}, {"3.248", "1.75"}},
    {"1", {"0", "0", "0", "1"}, {"3", "1"}},
};
static const int printed_points[8] = {1, 1, 2, 3, 4, 3, 3, 1};
#endif
