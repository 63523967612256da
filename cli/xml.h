/* xml.h -- text inside XML and HTML. */
#ifndef CAGD_XML_H
#define CAGD_XML_H

#include <stdio.h>

/* Writes the text with <, >, & and " replaced by their names, and by ? what XML 1.0 calls no character: the controls below the
 * blank other than the tabulator and the end of a line. */
void put_xml(FILE *out, const char *text);
#endif
