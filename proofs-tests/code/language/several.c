/* Several files, and an archive of bitcode, of which what is missed is taken (test_language.py makes it of archived.c). */
double from_another_file(double x);
double from_an_archive(double x);
double never_computed(int k), never_computed_in_a_struct(int k);
static double hidden = 0.5;
/* = F(1, 4) + F(1, 2) */
double m_another_file(void) { return from_another_file(1.0 / 3) + hidden; }
/* = F(1, 9) */
double m_archive(void) { return from_an_archive(1.0 / 3); }
/* = F(2, 3) */
double m_computed(void) { return never_computed(0) + never_computed_in_a_struct(0); }
/* ! was never computed */
double m_never_computed(void) { return never_computed(2); }
/* ! was never computed */
double m_never_computed_in_a_struct(void) { return never_computed_in_a_struct(1); }
