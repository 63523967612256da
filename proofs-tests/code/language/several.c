/* Several files, and an archive of bitcode, of which what is missed is taken (test_language.py makes it of archived.c). */
double from_another_file(double x);
double from_an_archive(double x);
static double hidden = 0.5;
/* = F(1, 4) + F(1, 2) */
double m_another_file(void) { return from_another_file(1.0 / 3) + hidden; }
/* = F(1, 9) */
double m_archive(void) { return from_an_archive(1.0 / 3); }
