/* space-rotation.h -- the rotations of space about the origin, as matrices for rows, from their quaternions.
 *
 * A 3 x 3 matrix is stored by rows.  Generic text. */
#include "chapters/foundations/definition.h"

#include "chapters/judge/claims_on.h"

/* The rotation of the quaternion h_0 + h_1 i + h_2 j + h_3 k, for rows: its first row is the image of (1, 0, 0); below = |h|^2 */
static inline void G(rotation_of_space)(const num h[], num below, num M[])
{
    num square[4], two = from_int(2);
    for (int k = 0; k < 4; k++)
        square[k] = mul(h[k], h[k]);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3; /* the axes in their cyclic order */
        num along = sub(add(square[0], square[1 + i]), add(square[1 + j], square[1 + k]));
        num both_j = mul(h[1 + i], h[1 + j]), both_k = mul(h[1 + i], h[1 + k]);
        M[i * 3 + i] = div(along, below);
        M[i * 3 + j] = div(mul(two, add(both_j, mul(h[0], h[1 + k]))), below);
        M[i * 3 + k] = div(mul(two, sub(both_k, mul(h[0], h[1 + j]))), below);
    }
}

/* out = v M, a row times a matrix */
static inline void G(row_of_space_times)(const num v[], const num M[], num out[])
{
    for (int j = 0; j < 3; j++) {
        out[j] = from_int(0);
        for (int k = 0; k < 3; k++)
            out[j] = add(out[j], mul(v[k], M[k * 3 + j]));
    }
}
#include "chapters/judge/claims_off.h"
