/* What others miss of it is no function. */
extern double from_a_number[2];
double from_a_number[2] = {0.25, 3};
