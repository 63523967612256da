/* laws.tmpl.h -- the laws of a ring with division, written once for every number type: both sides of
 * law k go to left[k] and right[k].  And a straight-line program in four registers. */
#include "core/number/generic_on.h"

static void G(laws)(num a, num b, num c, num left[], num right[])
{
    int k = 0;
#define LAW(x, y) (left[k] = (x), right[k++] = (y))
    LAW(add(a, b), add(b, a));
    LAW(mul(a, b), mul(b, a));
    LAW(sub(a, b), add(a, neg(b)));
    LAW(neg(neg(a)), a);
    LAW(add(a, from_int(0)), a);
    LAW(mul(a, from_int(1)), a);
    LAW(add(add(a, b), c), add(a, add(b, c)));
    LAW(mul(mul(a, b), c), mul(a, mul(b, c)));
    LAW(mul(a, add(b, c)), add(mul(a, b), mul(a, c)));
    LAW(mul(sub(b, c), a), sub(mul(b, a), mul(c, a)));
    LAW(add(a, neg(a)), from_int(0));
    LAW(mul(a, div(from_int(1), a)), from_int(1));
    LAW(mul(div(a, b), b), a);
    LAW(div(div(a, b), c), div(a, mul(b, c)));
    LAW(mul(from_ratio(-22, 7), from_int(14)), from_int(-44));
#undef LAW
}

/* r[i] := r[i] op r[j]; what the operations are is read from the code. */
static num G(program)(int steps, const unsigned char code[], num r[4])
{
    for (int s = 0; s < steps; s++) {
        int i = code[s] & 3, j = code[s] >> 2 & 3, op = code[s] >> 4;
        if (op < 5)
            r[i] = add(r[i], r[j]);
        else if (op < 9)
            r[i] = sub(r[i], mul(from_ratio(op, 7), r[j]));
        else if (op < 13)
            r[i] = mul(div(r[i], from_int(1000000 * op)), r[j]);
        else
            r[i] = div(add(r[i], from_int(3)), add(mul(r[j], r[j]), from_ratio(1, 3)));
    }
    return r[0];
}
#include "core/number/generic_off.h"
