/* points.h -- measured points from a text file, as people have them.
 *
 * One point a line; blank lines and lines that begin with # are passed over; lines end with LF, CRLF or CR, the last
 * one perhaps with nothing.  A mark of UTF-8 at the beginning is passed over.
 *
 * Fields are separated by semicolons, tabs, commas or blanks: by the first of these that the first line with a number
 * in it has outside quotes, where a blank beside a comma belongs to the comma, and where blanks that part numbers come
 * before commas, which are then decimal commas.  Runs of tabs and of blanks are one separator; a separator at the end
 * of a line is passed over.  A field may stand in double quotes.
 *
 * Numbers are decimal or hexadecimal, read to the nearest binary64 whatever the locale is.  A comma in a number is the
 * decimal comma; it is possible where commas do not separate fields, and in quotes.  Decimal commas and decimal points
 * do not stand in one file.  A unit of length or angle may stand behind numbers, the same in all of them.
 *
 * Lines before the first row.  Such a line has no number in it; or it begins with a letter, or is one number alone, and
 * the next line is a row of numbers.  The last one that has as many fields as the rows names the columns; the others, titles
 * and counts, are passed over, which is noted.  In a table of blanks the names may also be parted otherwise, and a unit in
 * brackets belongs to the name before it.
 *
 * Airfoils in Lednicer's order, two counts and then both sides from the nose, become one line.
 *
 * Other formats are told by how they begin: JSON (an array of points, points with x and y, arrays x and y, or GeoJSON), GPX, SVG, DXF.  Of
 * these a file holds one line of points; of several nothing is chosen.
 *
 * Columns.  Of the names, whatever follows the first blank,
 * slash or bracket is a unit.  x, y, and perhaps z are the coordinates, or a pair of names that maps and surveyors use, such as
 * easting northing, Rechtswert Hochwert, 横坐标 纵坐标, and with three coordinates asked for a height beside it; sigma, s, sd, std,
 * stddev or σ is the standard deviation of every coordinate of the point.  Without such names a column that is called
 * a number or a name of the points (Nr., id, Punkt, 序号) is none of a coordinate, and if then two columns are left beside a standard
 * deviation, they are x and y.  Columns that are not used are told.  Other names, and no names: two columns are x y, four are
 * x y z sigma, and three are x y z or x y sigma as --dim or --sigma-column say; nothing is guessed. */
#ifndef CAGD_POINTS_H
#define CAGD_POINTS_H

#include "cli/input.h"

/* What the user says about the columns. */
struct columns {
    int dim;           /* 2 or 3; 0: not said                                                          */
    const char *sigma; /* name or number, from 1, of the column of standard deviations; NULL: not said */
};

enum { MOST_NOTES = 8 };

struct points {
    int count, dim, has_sigma;
    int room;           /* for so many points                                                           */
    double *at;         /* coordinate c of point i is at[i*dim + c]                                     */
    double *sigma;      /* one a point; NULL where the file gives none                                  */
    int *line;          /* of the file, from 1                                                          */
    const char *format; /* "table", "JSON", "GeoJSON", "GPX", "SVG", "DXF"                              */
    int notes;          /* what was read otherwise than as it stands there: sentences without full stop */
    char *note[MOST_NOTES];
};

/* 0 on success.  Otherwise -1, nothing to free, and *error with line and column, counted in characters from 1; "-" is standard
 * input.  A file of no point is refused; whether there are enough is for the fit to say. */
int read_points(const char *path, const struct columns *columns, struct points *points, struct input_error *error);
void free_points(struct points *points);
#endif
