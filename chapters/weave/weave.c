/* weave.c -- collects the claims and statements from the comments of the chapter files.
 *
 *     weave REGISTER.c REGISTER.json TYPES CHAPTER_FOLDER...
 *
 * A chapter folder has an index.md whose toctree lists its sections in reading order; section S is
 * the file S.claims.h and, where it is drawn, S.figure.c.  The chapters are read in the order of the numbers that stand under
 * `order` among their letters; those without one come last, as they are named.  In the comments of a section stand blocks
 *
 *     :::{statement} wang-ch3:3.2.8          :::{claim} elevation_keeps_rational_curve
 *     :title: ...                            :title: ...
 *     :holds-by: elevation_keeps_...         :control: ...
 *                                            :::
 *     A paragraph on it.                     CLAIM(elevation_keeps_rational_curve) { ... }
 *     :::
 *
 * An option goes on to the next line that begins with ':' or is blank; the rest of a block is its
 * note.  A folder without sections, chapters/sources, has blocks of sources in its index.md.  The register of what was
 * found is written to REGISTER.c, as C tables, and to REGISTER.json.  A missing field, an unknown word, a claim without a
 * block or a body, a link to nothing or to a claim of the wrong kind, a section that the index does not list: each is an
 * error that names file and line, and stops the build.  TYPES are the number types that are compiled, such as
 * "field rational interval double"; a claim that has none of them is left out. */
#include "chapters/weave/book.h"

#include <stdio.h>

/* Puts the folders in reading order; those of one place stay as they are. */
static void sort_chapters(int count, char *folder[])
{
    for (int k = 1; k < count; k++)
        for (int j = k; j > 0 && place_of_chapter(folder[j]) < place_of_chapter(folder[j - 1]); j--) {
            char *later = folder[j - 1];
            folder[j - 1] = folder[j];
            folder[j] = later;
        }
}

int main(int argc, char **argv)
{
    if (argc < 5) {
        fputs("usage: weave REGISTER.c REGISTER.json TYPES CHAPTER_FOLDER...\n", stderr);
        return 2;
    }
    struct book book = {.types = argv[3]};
    sort_chapters(argc - 4, argv + 4);
    for (int k = 4; k < argc; k++)
        read_chapter(&book, argv[k]);
    check_book(&book);
    if (complaints > 0) { /* nothing is built from an older register */
        remove(argv[1]);
        remove(argv[2]);
        return 1;
    }
    return write_register_c(&book, argv[1]) != 0 || write_register_json(&book, argv[2]) != 0 ? 3 : 0;
}
