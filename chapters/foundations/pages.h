/* pages.h -- the page numbers of the table of contents, for its claims and its drawing. */
#ifndef CAGD_FOUNDATIONS_PAGES_H
#define CAGD_FOUNDATIONS_PAGES_H

enum { CHAPTERS = 9, MOST = 11 };

/* The pages of the sections as printed, chapter by chapter; 0 ends the list. */
static const int section_page[CHAPTERS][MOST + 1] = {
    {1, 2, 4, 6, 9, 12, 18, 20, 22},
    {25, 26, 27, 29, 32, 34, 38, 40, 47, 51},
    {57, 58, 62, 67, 69, 76},
    {82, 84, 87, 91, 93, 99, 103, 106, 110},
    {115, 119, 122, 128, 135, 142, 145},
    {147, 154, 160, 164, 167, 171, 174, 177, 179, 182, 184},
    {187, 190, 193},
    {198, 202, 204, 206, 209, 214, 218, 220},
    {225, 237, 234, 237, 242, 244, 248},
};

/* The page of each chapter, as printed. */
static const int chapter_page[CHAPTERS] = {1, 23, 57, 82, 115, 147, 187, 198, 225};
#endif
