/* prose.h -- the words of a page on standard output, filled to its width. */
#ifndef CAGD_PROSE_H
#define CAGD_PROSE_H

enum { WIDEST = 92, INDENT = 4 };

void heading(const char *text);
/* Text in which TeX was replaced already. */
void paragraph(const char *text, int indent);
/* Text with formulas between dollar signs; blank lines separate paragraphs. */
void prose(const char *text, int indent);
/* A formula in TeX; or a sentence, which has its formulas between dollar signs, or none of the signs of TeX. */
void formula(const char *tex, int indent);
/* "label  text", nothing where there is no text. */
void labelled(const char *label, const char *text, int indent);
/* The same with the further lines of the text below its first one, behind `columns` of the label. */
void hanging(const char *label, const char *text, int columns, int indent);
/* "Proved for n = 1 to 6.": a clause with a capital and a full stop. */
void clause(const char *words, int indent);
#endif
