/*
# The book at a glance (目录)

The source has nine chapters.  This page goes through its table of contents and says, for every section, by which claims
of ours its subject is covered, and what of it is open.  A claim is about the subject, not about the text of the section,
unless the ledger has an entry of it.  The text is at hand up to a part of § 1-5; of the other sections it is always open
whether the source says what is decided here, and "the text" stands for that.
*/
#if RATIONAL
#include "chapters/foundations/pages.h"
#endif

#include "chapters/judge/claims_on.h"

/*
:::{statement} hu-1987:preface-nine-chapters
:title: The book has nine chapters
:zh: 全书共九章
:printed: The whole book has nine chapters.
:holds-by: contents_has_nine_chapters
:example: the sentence is about this one book, whose chapters are counted.
:figure: pages_of_the_sections
:::
*/

#if RATIONAL
/*
:::{claim} contents_has_nine_chapters
:title: The table of contents has nine chapters with seventy sections
:zh: 目录共九章七十节
:kind: decision
:given: the numbers of sections in the table of contents, chapter by chapter
:data: sections = 9 10 6 9 7 11 3 8 7; chapters = 9
:then: the printed pages are those of so many chapters with so many sections
:result: sections in all = 70
:method: The printed pages are counted.
:control: the last chapter left out
:::
*/
CLAIM(contents_has_nine_chapters)
{
    num printed[CHAPTERS], expected;
    given_points(T, "sections", CHAPTERS, 1, printed);
    expected = given(T, "chapters");
    int sections = 0, chapters = 0;
    for (int c = 0; c < fault(T, CHAPTERS, CHAPTERS - 1); c++, chapters++) {
        int count = 0;
        while (section_page[c][count] != 0)
            count++;
        same(T, from_int(count), printed[c]);
        sections += count;
    }
    found_whole(T, "sections in all", sections);
    same(T, from_int(chapters), expected);
}

/*
Page numbers are the one thing in a table of contents that can be checked without the book: they do not fall.  The next
statement does no more than that, and finds a number that cannot be right together with its neighbours.

:::{statement} hu-1987:contents-page-order
:title: The pages of the sections increase
:zh: 目录页码递增
:printed: § 9-1 (225), § 9-2 (237), § 9-3 (234), § 9-4 (237)
:refuted-by: page_of_a_section_before_the_one_before
:class: misprint
:corrected: Without § 9-2 the page numbers increase strictly; if it is no exception and the other pages are right, it begins on a page from
  226 to 233.
:corrected-by: other_pages_do_not_decrease
:example: the table of contents of this book.
:figure: pages_of_the_sections
:::
*/

/* Whether from this chapter on every page is more than the one before, that section of that chapter left out.  Chapters and
 * sections count from 1. */
static int pages_increase(int first_chapter, int chapter, int section)
{
    num last = from_int(0);
    int good = 1;
    for (int c = first_chapter; c <= CHAPTERS; c++)
        for (int k = 1; section_page[c - 1][k - 1] != 0; k++)
            if (c != chapter || k != section) {
                num page = from_int(section_page[c - 1][k - 1]);
                good &= compare_q(last, page) < 0;
                last = page;
            }
    return good;
}

/*
:::{claim} page_of_a_section_before_the_one_before
:title: Section 9-3 begins before section 9-2
:zh: 9-3 节页码小于 9-2 节
:kind: counterexample
:given: the printed pages of the sections of the given chapter, and which of its sections is left out, 0 if none is
:data: chapter = 9; pages = 225 237 234 237 242 244 248; left out = 0
:instead: left out = 2
:then: they do not increase, because the third is less than the second
:method: Neighbours are compared.
:control: the second page left out
:::
*/
CLAIM(page_of_a_section_before_the_one_before)
{
    enum { SECTIONS = 7 };
    num page[SECTIONS];
    int chapter = given_whole(T, "chapter"), printed = 1;
    given_points(T, "pages", SECTIONS, 1, page);
    int left_out = given_whole(T, "left out");
    for (int k = 0; k < SECTIONS; k++)
        printed = printed && equal_q(page[k], from_int(section_page[chapter - 1][k]));
    about(T, "whether the pages are in order, or are not those that are printed");
    refute(T, printed && !pages_increase(chapter, chapter, left_out));
}

/*
:::{claim} other_pages_do_not_decrease
:title: Without 9-2 all pages increase
:zh: 其余页码严格递增
:kind: decision
:given: the pages of all seventy sections, with that one left out
:data: chapter = 9; section = 2
:instead: section = 0
:then: each is more than the one before it; so, if the section left out is no exception, it begins between the pages of its neighbours
:result: page before = 225; page after = 234
:method: Neighbours are compared.
:control: no section left out
:::
*/
CLAIM(other_pages_do_not_decrease)
{
    int chapter = given_whole(T, "chapter"), section = given_whole(T, "section");
    if (section > 0) {
        found_whole(T, "page before", section_page[chapter - 1][section - 2]);
        found_whole(T, "page after", section_page[chapter - 1][section]);
    }
    agree(T, pages_increase(1, chapter, section));
}

/*
What can be compared, too, is the page of a chapter with that of its first section.  Eight of nine agree.
For the ninth, chapter 2, the pages around it leave all possibilities open.

:::{statement} hu-1987:contents-chapter-pages
:title: A chapter begins with its first section
:zh: 章首页码
:printed: Chapter 2 begins on page 23, its first section on page 25, and the last section before it, 1-9, on page 22.
:reading: second_chapter_begins_before_its_first_section | both numbers are the page on which the chapter begins with its first section, as all other chapters do
:reading: the chapter begins on page 23, behind the last section before it, and has pages of its own before its first section, 25: nothing in the table of contents
  says that it has none
:confirmed-by: other_chapters_begin_with_their_first_section
:figure: pages_of_the_sections

The eight other chapters begin on the pages of their first sections (`other_chapters_begin_with_their_first_section`).
:::
*/

/*
:::{claim} second_chapter_begins_before_its_first_section
:title: The page of chapter 2 is not that of section 2-1
:zh: 第二章页码与 2-1 节不符
:kind: counterexample
:given: the number of a chapter, and two pages of the table of contents: that of the chapter and that of its first section
:data: chapter = 2
:instead: chapter = 3
:then: the printed page of the chapter is not that of its first section
:result: page of the chapter = 23; page of its first section = 25
:method: The two numbers of the table.
:control: the next chapter
:::
*/
CLAIM(second_chapter_begins_before_its_first_section)
{
    int c = given_whole(T, "chapter") - 1, page = chapter_page[c], first = section_page[c][0];
    found_whole(T, "page of the chapter", page);
    found_whole(T, "page of its first section", first);
    about(T, "the two pages");
    same(T, from_int(page), from_int(first));
}

/*
:::{claim} other_chapters_begin_with_their_first_section
:title: The other chapters begin on the page of their first section
:zh: 其余各章页码与首节一致
:kind: decision
:given: the printed pages of all chapters but the second
:data: pages = 1 57 82 115 147 187 198 225
:then: each is the page of the first section
:method: The numbers of the table.
:control: chapter 2 counted in
:::
*/
CLAIM(other_chapters_begin_with_their_first_section)
{
    num page[CHAPTERS - 1];
    given_points(T, "pages", CHAPTERS - 1, 1, page);
    for (int c = 0, k = 0; c < CHAPTERS; c++)
        if (c != 1) {
            agree(T, equal_q(page[k++], from_int(chapter_page[c])));
            same(T, from_int(chapter_page[c]), from_int(section_page[c][0]));
        } else if (T->faulty) {
            same(T, from_int(chapter_page[c]), from_int(section_page[c][0]));
        }
}
#endif

/*
## The sections

| section | subject | covered by | open |
|---|---|---|---|
| 1-1 | what geometric design is about | `one_cubic_passes_through_four_data` `nearest_line_meets_no_datum` | other kinds of data |
| 1-2 | properties of shapes | `matrices_pass_to_the_points` `translation_adds_the_sum_of_the_functions` `bezier_curve_moves_with_its_points` `curve_points_are_convex_combinations` | solids |
| 1-3 | circles | `small_steps_multiply_the_radius` `second_orbit_never_closes` `ellipse_lies_between_two_circles` `third_matrix_by_the_radius` | |
| 1-4 | description of parametric curves | `horner_computes_the_sum_of_powers` `additions_step_along_the_curve` `cusp_of_the_example_is_a_cusp` `sign_of_delta_tells_the_form` `torsion_by_speed_and_curvature` | |
| 1-5 | control of shape | `conditions_make_one_curve_in_another_parameter` `pieces_in_new_powers` `fractional_change_of_a_power_curve` | the end of the section |
| 1-6 | theory of curves and surfaces | `curvature_belongs_to_arc_length` `torsion_belongs_to_arc_length` `signed_curvature_is_the_turning_of_the_tangent` `surface_normal_is_the_cross_product` | curvature of surfaces; the text |
| 1-7 | points of parametric surfaces | `tensor_kernel_is_the_matrix_product` `surface_kernel_computes_the_double_sum` `surface_derivatives_of_every_order` | differences; the text |
| 1-8 | control of the shape of surfaces | `borders_and_cross_derivatives_are_kept` `surface_part_is_the_piece` | joints of surfaces; the text |
| 1-9 | interpolation by Lagrange | `lagrange_functions_keep_every_polynomial` `one_cubic_passes_through_four_data` `divided_difference_is_leading_coefficient` | parameters for points; the text |
| 2-1 | display in space | | all of it |
| 2-2 | affine maps | `bezier_curve_moves_with_its_points` `total_degree_survives_affine_maps` | maps of space as matrices; the text |
| 2-3 | projective maps | `projective_image_is_not_the_curve_of_the_images` `projective_change_of_unit_interval_is_fractional` | maps of the plane; the text |
| 2-4 | rotation about an axis | `rotation_matrix_adds_the_angle` `rotations_keep_products` `rotation_about_a_point_moves_the_example` | axes beside the origin; the text |
| 2-5 | viewing transformation | | all of it |
| 2-6 | perspective | | all of it |
| 2-7 | theory of perspective | | all of it |
| 2-8 | perspective space | | all of it |
| 2-9 | homogeneous coordinates | `homogeneous_points_carry_their_weight` `translated_homogeneous_points_give_no_translate` | the text |
| 2-10 | clipping | | all of it |
| 3-1 | hidden lines and surfaces | | all of it |
| 3-2 | convex polyhedra | | all of it |
| 3-3 | methods for hidden parts | | all of it |
| 3-4 | choice of coordinates | | all of it |
| 3-5 | an algorithm for hidden parts | | all of it |
| 3-6 | another algorithm for hidden parts | | all of it |
| 4-1 | interpolation by Hermite | `hermite_interpolant_exists_and_is_unique` `end_data_determine_the_cubic` `osculation_is_divisibility` | the text |
| 4-2 | Ferguson's curves, first part | `hermite_kernel_blends_four_data` `base_functions_interpolate_once_continuously` `other_lengths_give_another_cubic` | the system of equations of splines; the text |
| 4-3 | Ferguson's curves, second part | `second_derivatives_meet_on_a_condition` `conditions_make_one_curve_in_another_parameter` `cusps_are_on_a_hyperbola` | the system of equations of splines; the text |
| 4-4 | Ferguson's surfaces | `tensor_kernel_is_the_matrix_product` | twists 0; the text |
| 4-5 | Coons surfaces, first part | `coons_kernel_is_the_bordered_product` `four_curves_are_borders` `shifted_frame_shifts_the_patch_by_a_product` | the text |
| 4-6 | Coons surfaces, second part | `borders_and_cross_derivatives_are_kept` `cubic_frame_of_corners_gives_the_product` | the text |
| 4-7 | control of bicubic surfaces | `tensor_kernel_is_the_matrix_product` `cubic_frame_gives_bicubic_patch` | changes of the parameters; the text |
| 4-8 | twist | `two_twists_cannot_both_be_kept` | estimates of the twist; the text |
| 4-9 | joining Coons patches | | all of it |
| 5-1 | cubic Bézier curves | `decasteljau_evaluates_bezier_curve` `end_derivatives_are_end_differences` | the text |
| 5-2 | Bernstein polynomials | `bernstein_is_binomial_form` `bernstein_sums_to_one` `bernstein_positive_inside` `bernstein_recurrence` | the text |
| 5-3 | properties of Bézier curves | `curve_points_are_convex_combinations` `line_crosses_curve_at_most_as_often_as_polygon` `reversed_points_reverse_the_curve` | the text |
| 5-4 | elevation, division, joining | `elevation_keeps_bezier_curve` `split_gives_the_two_parts` `conditions_make_one_curve_in_another_parameter` | the text |
| 5-5 | Bézier surfaces | `surface_kernel_computes_the_double_sum` `parameter_lines_are_bezier_curves` `surface_functions_sum_to_one_and_are_positive` `corners_of_the_net_give_tangents_normal_and_twist` `collapsed_border_has_no_normal` | joints of surfaces; the text |
| 5-6 | triangular patches | | all of it |
| 5-7 | interpolating cubic Bézier curves | `end_data_determine_the_cubic` | systems of equations; the text |
| 6-1 | uniform cubic B-spline curves | `uniform_matrix_is_the_matrix` `matrix_gives_homogeneous_curve` | geometric properties of the cubic; the text |
| 6-2 | uniform B-spline surfaces | | all of it |
| 6-3 | B-splines by divided differences | `column_by_differences_is_the_function` `truncated_power_gives_the_basis` | the text |
| 6-4 | B-splines by recursion | `bspline_basis_follows_definition` `basis_is_a_partition_of_unity` | the text |
| 6-5 | forms of B-spline curves | `clamped_end_is_the_first_point` `periodic_data_close_the_curve` `bezier_curves_are_nurbs_curves` | the text |
| 6-6 | points of curves from data | | all of it |
| 6-7 | points of surfaces from data | | all of it |
| 6-8 | de Boor's algorithm | `rational_triangle_gives_the_point` `every_level_divides_its_edges` | the text |
| 6-9 | insertion of knots | `printed_insertion_keeps_the_curve` `inserted_points_divide_the_edges` | the text |
| 6-10 | Chaikin's algorithm | | all of it |
| 6-11 | interpolating B-splines | | all of it |
| 7-1 | plane rational curves | `rational_point_is_weighted_mean` `equal_invariants_give_same_curve` | the text |
| 7-2 | conics and their kinds | `points_at_infinity_tell_the_kind` `kind_in_any_coordinates` `conic_invariants_are_determinants` | the text |
| 7-3 | rational curves in space | `end_torsion_at_zero` `coplanar_vertices_give_a_plane_curve` | T-conics; the text |
| 8-1 | geometric models | | all of it |
| 8-2 | methods of modelling | | all of it |
| 8-3 | Boolean operations | | all of it |
| 8-4 | regular Boolean operations | | all of it |
| 8-5 | data structures of polyhedra | | all of it |
| 8-6 | description of solids | | all of it |
| 8-7 | free surfaces in solids | | all of it |
| 8-8 | local deformation | | all of it |
| 9-1 | arcs of circles and their joints | `arc_and_its_central_angle` `rational_quadratic_of_the_arc` | joints of two arcs; the text |
| 9-2 | conics from lines | `conics_touching_two_lines_are_limings` `limings_pencil_in_the_frame` | the text |
| 9-3 | cubic splines | `second_derivatives_meet_on_a_condition` | the system of equations; the text |
| 9-4 | generating lines of surfaces | | all of it |
| 9-5 | fairness | | all of it |
| 9-6 | fairing by rebound | | all of it |
| 9-7 | fairing by energy | | all of it |
*/
#include "chapters/judge/claims_off.h"
