/* Several files, and an archive of bitcode, of which what is missed is taken (test_language.py makes it of archived.c). */
double from_another_file(double x);
double from_an_archive(double x);
double from_an_alias(double x);
extern double from_a_number[2];
double never_computed(int k), never_computed_in_a_struct(int k);
static double hidden = 0.5;
/* = F(1, 4) + F(1, 2) */
double m_another_file(void) { return from_another_file(1.0 / 3) + hidden; }
/* = F(1, 9) */
double m_archive(void) { return from_an_archive(1.0 / 3); }
/* = F(1, 27) */
double m_archived_alias(void) { return from_an_alias(1.0 / 3); }
/* = F(13, 4) */
double m_archived_number(void) { return from_a_number[0] + from_a_number[1]; }
/* = F(2, 3) */
double m_computed(void) { return never_computed(0) + never_computed_in_a_struct(0); }
/* ! was never computed */
double m_never_computed(void) { return never_computed(2); }
/* ! was never computed */
double m_never_computed_in_a_struct(void) { return never_computed_in_a_struct(1); }
