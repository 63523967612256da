/* words.h -- short words for the names of exact/, for text that is read: chapters, figures, tests and the sources of this library.
 *
 * Programs that are not of this house write the full names (cagd_exact.h) and do not include this file. */
#ifndef CAGD_EXACT_WORDS_H
#define CAGD_EXACT_WORDS_H

/* Values. */
typedef struct cagd_num_q num_q;
typedef struct cagd_num_i num_i;
typedef struct cagd_num_f num_f;
typedef struct cagd_poly poly;
typedef struct cagd_region_mark region_mark;

/* What is computed with them. */
#define add_q                cagd_add_q
#define sub_q                cagd_sub_q
#define mul_q                cagd_mul_q
#define div_q                cagd_div_q
#define neg_q                cagd_neg_q
#define from_int_q           cagd_from_int_q
#define from_ratio_q         cagd_from_ratio_q
#define root_q               cagd_root_q
#define from_mpq_q           cagd_from_mpq_q
#define from_double_q        cagd_from_double_q
#define from_string_q        cagd_from_string_q
#define to_double_q          cagd_to_double_q
#define to_string_q          cagd_to_string_q
#define add_i                cagd_add_i
#define sub_i                cagd_sub_i
#define mul_i                cagd_mul_i
#define div_i                cagd_div_i
#define neg_i                cagd_neg_i
#define from_int_i           cagd_from_int_i
#define from_ratio_i         cagd_from_ratio_i
#define root_i               cagd_root_i
#define from_rational_i      cagd_from_rational_i
#define contains_i           cagd_contains_i
#define contains_zero_i      cagd_contains_zero_i
#define sign_i               cagd_sign_i
#define width_i              cagd_width_i
#define lower_i              cagd_lower_i
#define upper_i              cagd_upper_i
#define add_f                cagd_add_f
#define sub_f                cagd_sub_f
#define mul_f                cagd_mul_f
#define div_f                cagd_div_f
#define neg_f                cagd_neg_f
#define from_int_f           cagd_from_int_f
#define from_ratio_f         cagd_from_ratio_f
#define root_f               cagd_root_f
#define from_rational_f      cagd_from_rational_f
#define variable_f           cagd_variable_f
#define equal_f              cagd_equal_f
#define is_constant_f        cagd_is_constant_f
#define derivative_f         cagd_derivative_f
#define substitute_f         cagd_substitute_f
#define degree_f             cagd_degree_f
#define denominator_degree_f cagd_denominator_degree_f
#define coefficient_f        cagd_coefficient_f
#define coefficients_sign_f  cagd_coefficients_sign_f
#define to_string_f          cagd_to_string_f
#define field_open           cagd_field_open
#define field_close          cagd_field_close
#define field_variables      cagd_field_variables
#define field_variable_f     cagd_field_variable_f
#define poly_from_q          cagd_poly_from_q
#define poly_from_bernstein  cagd_poly_from_bernstein
#define poly_constant        cagd_poly_constant
#define poly_variable        cagd_poly_variable
#define poly_from_field      cagd_poly_from_field
#define poly_coefficient     cagd_poly_coefficient
#define poly_add             cagd_poly_add
#define poly_sub             cagd_poly_sub
#define poly_mul             cagd_poly_mul
#define poly_neg             cagd_poly_neg
#define poly_scale           cagd_poly_scale
#define poly_derivative      cagd_poly_derivative
#define poly_value           cagd_poly_value
#define poly_compose         cagd_poly_compose
#define poly_quotient        cagd_poly_quotient
#define poly_remainder       cagd_poly_remainder
#define poly_gcd             cagd_poly_gcd
#define poly_squarefree      cagd_poly_squarefree
#define poly_to_bernstein    cagd_poly_to_bernstein
#define poly_to_string       cagd_poly_to_string
#define root_bound           cagd_root_bound
#define refine_root          cagd_refine_root
#define sylvester_matrix_q   cagd_sylvester_matrix_q
#define sylvester_matrix_f   cagd_sylvester_matrix_f
#define bezout_matrix_q      cagd_bezout_matrix_q
#define bezout_matrix_f      cagd_bezout_matrix_f
#define region_open          cagd_region_open
#define region_drop          cagd_region_drop
#define region_bytes         cagd_region_bytes
#define region_free_all      cagd_region_free_all
#define region_faults        cagd_region_faults

/* How intervals end, the signs of a polynomial, and what went wrong. */
#define CLOSED              CAGD_CLOSED
#define OPEN                CAGD_OPEN
#define OPEN_LEFT           CAGD_OPEN_LEFT
#define OPEN_RIGHT          CAGD_OPEN_RIGHT
#define SIGN_ZERO           CAGD_SIGN_ZERO
#define SIGN_POSITIVE       CAGD_SIGN_POSITIVE
#define SIGN_NONNEGATIVE    CAGD_SIGN_NONNEGATIVE
#define SIGN_NONPOSITIVE    CAGD_SIGN_NONPOSITIVE
#define SIGN_NEGATIVE       CAGD_SIGN_NEGATIVE
#define SIGN_MIXED          CAGD_SIGN_MIXED
#define FAULT_UNDEFINED     CAGD_FAULT_UNDEFINED
#define FAULT_UNABLE        CAGD_FAULT_UNABLE
#define FAULT_CROWDED       CAGD_FAULT_CROWDED
#define FAULT_MEMORY        CAGD_FAULT_MEMORY
#define FIELD_MAX_VARIABLES CAGD_FIELD_MAX_VARIABLES
#define FIELD_MAX_NAME      CAGD_FIELD_MAX_NAME
#endif
