#include "core/fit/strategy.h"

/* Each number was varied alone, and this was measured.
 *
 * How many curves are found again, of 240 random conics, cubics, quartics and splines of 3 segments, with weights
 * between 1/4 and 4 and 60 to 80 points without noise each; a difference of two or three curves is chance.
 *
 *     alternations     0, 2, 4, 8, 16           213, 214, 218, 221, 221
 *     weight_spread    4, 8, 16, 64, 256        223, 224, 221, 220, 216
 *     chord_groups     16, 32, 64, 128, 1000    220, 222, 221, 220, 220
 *     extra_starts     0, 4, 8                  221, 221, 221
 *
 * With fewer alternations the points of a first curve are too far off for any weights.  With a wider spread, few of
 * the thirteen guesses are near the weights that are sought.
 *
 * How many fits come to the lowest minimum that any of these ways has found: of 24 conics with 40 points that scatter
 * by 0.3, as much as they bend, and of 24 cubics with 60 points that scatter by 0.05.
 *
 *     chord_groups     8, 16, 64, 1000          7 + 10, 5 + 10, 8 + 12, 8 + 12
 *     extra_starts     0, 2, 4, 8, 16           3 + 10, 4 + 11, 6 + 12, 8 + 12, 8 + 12
 *
 * With fewer groups the chords cut corners.  The extra starts take 1, 2.5, 3.5, 5 and 5 times the time.
 *
 * The time over the usual time, for a conic and a cubic with 200, 2 000 and 20 000 points that scatter by 0.002.  The
 * cost is the same everywhere.
 *
 *     handover             1e-2, 1e-3, 1e-5, 1e-6    0.94 to 1.04
 *     anchors              16, 32, 128, 256          1 but for the noise of the measurement
 *     sides                64, 128                   1.08 (200 points), 1.06 (2 000), 1.03 (20 000) with 64; found again of 240 curves
 *                                                    225, 227, 228, and the lowest minimum of 48 that scatter 18, 18, 20 times
 *     points_per_unknown   5, 10, 40, 80             0.4 to 0.6, 0.6 to 1, 1 to 1.7, 0.5 to 6
 *     means_factor         1, 2, 8, 16               0.4 to 0.6, 0.6 to 1, 1 to 1.7, 1 to 2.9
 *     guesses              3, 6, 26, 52              0.4 to 0.6, 0.6 to 0.8, 1.4 to 1.8, 2 to 6
 *
 * Newton's steps lead to the end from every handover.  These problems are easy; what fewer points, means and guesses
 * lose in difficult ones has not been measured, and so they stay as they are. */
const fit_strategy fit_usual_strategy = {.chord_groups = 64,
                                         .alternations = 8,
                                         .guesses = 13,
                                         .weight_spread = 16,
                                         .guess_steps = 40,
                                         .guess_accuracy = 1e-3,
                                         .extra_starts = 8,
                                         .points_per_unknown = 20,
                                         .means_factor = 4,
                                         .handover = 1e-4,
                                         .taylor_reach = 0x1p-6,
                                         .intervals = 1,
                                         .anchors = 64,
                                         .sides = 32};
