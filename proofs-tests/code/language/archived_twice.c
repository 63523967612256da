/* Never missed; taken, it would be defined twice. */
double from_another_file(double x);
double from_another_file(double x) { return -x; }
