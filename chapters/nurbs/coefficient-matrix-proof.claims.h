/*
# The proof of theorem 4.4.1 (定理 4.4.1 的证明)

The theorem writes a B-spline as a divided difference of a truncated power and collects the powers of $u$.  Its proof is three lines, of which the second
and the third lose a condition that the theorem has.  Here they are decided line by line; order, span and $u$ are those of the section before.
*/
#include "chapters/nurbs/spans.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:thm-4.4.1-step-1
:title: The B-spline as a sum of derivatives of truncated powers
:zh: 证明第一行:截断幂的导数之和
:printed: N_{i,k}(t)=(t_{i+k}-t_i)\sum_{\lambda=1}^d\sum_{\mu=0}^{l_\lambda-1}\alpha_{\lambda\mu}
  \frac{d^\mu(x-t)_+^{k-1}}{dx^\mu}\Big|_{x=\tau_\lambda}
:holds-by: truncated_power_gives_the_basis all_full_powers_sum_to_nothing truncated_power_steps_in_every_order linear_factor_in_a_divided_difference
:argued: every k | By `truncated_power_steps_in_every_order` and `linear_factor_in_a_divided_difference` $N_{i,k}$ is $t_{i+k}-t_i$ times the divided
  difference of the truncated power for every $k$ and every $t$ between the knots of the function, which is this sum by lemma 4.4.1.  For all other $t$ both sides are 0: left of the knots the
  power is a full one, of degree $k-1$ in $x$, whose divided difference is 0 (`all_full_powers_sum_to_nothing`); from the last one on it is 0 with its derivatives.
:hypothesis: zero_power_at_a_knot_of_multiplicity_k | $t$ is no knot of multiplicity $k$ in $T_i$, or $0_+^0$ counts as 0: at
  such a knot the derivative of order $k-1$ is $(k-1)!\,0_+^0$, which for $k=1$ is the truncated power itself and for $k>1$ does not exist
:figure: zero_power_at_a_knot

The reason that is given is 2.7.4 with lemma 4.4.1; whatever 2.7.4 is, the section is not at hand, and the copy has lost the word before the number; it is computed here.  The sentence before abbreviates $d(T_i),l_q(T_i),\tau_q(T_i),\alpha_{\lambda\mu}(T_i)$ to $d,l_q,\tau_q,\alpha_{\lambda\mu}$; in the copy at hand the first four have lost their $(T_i)$, too.  The
knots of $T_i$ are not all equal, as $[t_r,t_{r+1})$ is not empty and lies between them.
:::
*/

/* (k-1)!/(k-1-mu)! (tau - t)^{degree - mu}, with degree = k-1 */
static num G(power_datum)(int k, int mu, num tau, num t, int degree)
{
    return mul(div(G(factorial)(k - 1), G(factorial)(k - 1 - mu)), G(power)(sub(tau, t), degree - mu));
}

/*
The proof begins with the truncated power (截断幂).  Seen from a $t$ of the span it has the data 0 at the nodes on the
left and those of an ordinary power at the nodes on the right; that is all that the divided difference needs.

:::{claim} truncated_power_gives_the_basis
:title: The divided difference of the truncated power is the B-spline
:zh: 截断幂的差商即 B 样条基
:given: every pattern of the $k+1$ knots of a function and every span among them, the different knots and $t$ variables;
  random patterns for greater $k$
:then: $(t_{i+k}-t_i)[t_i,\dots,t_{i+k}](x-t)_+^{k-1}=N_{i,k}(t)$ on the span, by the table of divided differences and
  by the sum with the weights $\alpha$ of (4.4.9)
:method: The data of the truncated power at $\tau_\lambda$ are $\frac{(k-1)!}{(k-1-\mu)!}(\tau_\lambda-t)^{k-1-\mu}$
  right of the span and 0 left of it.
:degrees: 0..4 sampled 7
:scope: every multiplicity of the knots of a function
:over: t#: knots
:control: the data right and left of the span exchanged
:::
*/
CLAIM(truncated_power_gives_the_basis)
{
    int k = T->degree + 1;
    num x[LARGEST_ORDER + 1], t = parameter(T, "t");
    G(increasing)(T, k + 1, x);
    for (int count = G(function_patterns)(k), m = 0; m < count; m++) {
        int pattern = G(function_pattern)(T, k, m), groups = 1;
        for (int a = 0; a < k; a++)
            groups += pattern >> a & 1;
        num alpha[LARGEST_ORDER + 1][LARGEST_ORDER + 1];
        for (int g = 0; g + 1 < groups; g++) {
            struct G(span) S = G(span_of_function)(k, pattern, g, x);
            struct G(nodes) n = G(nodes_of)(&S);
            num data[LARGEST_ORDER + 1], sum = from_int(0), length = sub(S.t[k], S.t[0]);
            if (g == 0)
                G(cofactor_weights)(&n, k, alpha);
            for (int i = 0, row = 0; i < n.d; i++)
                for (int mu = 0; mu < n.l[i]; mu++, row++) {
                    int counts = fault(T, n.right[i], !n.right[i]);
                    data[row] = counts ? G(power_datum)(k, mu, n.tau[i], t, k - 1) : from_int(0);
                    sum = add(sum, mul(alpha[i][mu], data[row]));
                }
            num N = G(basis_value)(&S, 0, k, t);
            about(T, "by the table");
            /* (t_i+k - t_i) [t_i, ..., t_i+k] (x - t)_+^(k-1) = N_i,k(t) */
            same(T, mul(length, G(divided_difference)(n.d, n.l, n.tau, data)), N);
            about(T, "by the weights");
            same(T, mul(length, sum), N);
        }
    }
}

/*
That this is so for every order is the recursion of Cox and de Boor again: a truncated power is the one of a degree less times $x-t$, and the divided
difference of a function times a linear factor is made of two divided differences of the function.

:::{claim} linear_factor_in_a_divided_difference
:title: The divided difference of a linear factor times a function
:zh: 线性因子与函数之积的差商
:types: field rational
:given: nodes $t_0,\dots,t_k$, $k\ge1$, any of which may be equal; $Q=(x-t_1)\cdots(x-t_k)=xU+q$ and a polynomial $G=c_1U+p$ at $x$, where $U=x^{k-1}$; numbers $c$ and $t$; all
  variables
:then: $(x-t)(G+cQ)-c\,(x-t_0)Q=(x-t)G+c\,(t_0-t)\,Q=\bigl(c_1+(t_0-t)c\bigr)xU+x\,p-t\,G+c\,(t_0-t)\,q$
:method: Let $c=[t_0,\dots,t_k]g$, and let $G$ osculate a function $g$ on $t_1,\dots,t_k$, so that $c_1=[t_1,\dots,t_k]g$.  Then $G+cQ$ osculates $g$ on all nodes: the polynomial of
  degree $k$ that does, less $G$, is $c$ times $Q$.  So $(x-t)(G+cQ)$ osculates $(x-t)g$, and so does the left side, as $(x-t_0)Q$ osculates 0.  It is of degree $k$:
  $[t_0,\dots,t_k]\,(x-t)g=(t_0-t)\,[t_0,\dots,t_k]g+[t_1,\dots,t_k]g$.
:over: t; x t0 U q p c#: -
:control: $(x-t)Q$ in the place of $(x-t_0)Q$
:::
*/
CLAIM(linear_factor_in_a_divided_difference)
{
    num x = unknown(T, "x", 0), t = parameter(T, "t"), t0 = unknown(T, "t", 0), U = unknown(T, "U", 0);
    num q = unknown(T, "q", 0), p = unknown(T, "p", 0), c = unknown(T, "c", 0), c1 = unknown(T, "c", 1);
    num Q = add(mul(x, U), q), G = add(mul(c1, U), p), back = mul(c, sub(t0, t));
    num short_by = mul(c, mul(sub(x, fault(T, t0, t)), Q));
    about(T, "the polynomial");
    same(T, sub(mul(sub(x, t), add(G, mul(c, Q))), short_by), add(mul(sub(x, t), G), mul(back, Q)));
    about(T, "its highest power");
    num rest = add(sub(mul(x, p), mul(t, G)), mul(back, q));
    same(T, add(mul(sub(x, t), G), mul(back, Q)), add(mul(add(c1, back), mul(x, U)), rest));
}

/*
:::{claim} truncated_power_steps_in_every_order
:title: From the truncated power of one order to the next, whatever the order
:zh: 截断幂差商的递推(任意阶数)
:types: field rational
:given: an order $k\ge2$; knots $a=t_i$, $b=t_{i+k}$ that differ, $e=t_{i+k-1}\ne a$ and $d=t_{i+1}\ne b$; $N_{i,k-1}=(e-a)A$, $N_{i+1,k-1}=(b-d)B$; any $t$; all variables
:harmless: $e=t_{i+k-1}\ne a$ and $d=t_{i+1}\ne b$ | where they are equal, the function and the difference are 0
:let: $D=\frac{B-A}{b-a}$
:then: $(b-a)\bigl((a-t)D+B\bigr)=\frac{t-a}{e-a}N_{i,k-1}+\frac{b-t}{b-d}N_{i+1,k-1}$, which is $N_{i,k}$
:method: With $A$ and $B$ the divided differences of $(x-t)_+^{k-2}$ on $t_i,\dots,t_{i+k-1}$ and on $t_{i+1},\dots,t_{i+k}$, $D$ is that on $t_i,\dots,t_{i+k}$ by the table, and
  $(a-t)D+B$ is that of $(x-t)_+^{k-1}$ (`linear_factor_in_a_divided_difference`).  Where $e=a$ it is $N_{i,k-1}=0$, and $A=0$, a derivative of order $k-1$ of a power $k-2$ or of 0;
  likewise for $d=b$.  For $k=1$ the difference of $(x-t)_+^0$, 0 at the knots left of the span, 1 right of it, is $\frac1{b-a}$ if the span is $[a,b)$, and 0 otherwise.
:scope: every multiplicity of the knots of a function
:over: a b d e N#: -
:control: $A$ and $B$ exchanged in $D$
:::
*/
CLAIM(truncated_power_steps_in_every_order)
{
    num t = parameter(T, "t"), a = unknown(T, "a", 0), b = unknown(T, "b", 0), d = unknown(T, "d", 0);
    num e = unknown(T, "e", 0), N[2] = {unknown(T, "N", 0), unknown(T, "N", 1)};
    num A = div(N[0], sub(e, a)), B = div(N[1], sub(b, d)), length = sub(b, a);
    num D = div(sub(fault(T, B, A), fault(T, A, B)), length);
    num recursion = add(mul(div(sub(t, a), sub(e, a)), N[0]), mul(div(sub(b, t), sub(b, d)), N[1]));
    same(T, mul(length, add(mul(sub(a, t), D), B)), recursion);
}

#if RATIONAL
/*
:::{claim} zero_power_at_a_knot_of_multiplicity_k
:title: At a knot of multiplicity k the power 0 of 0 decides
:zh: k 重节点处的零次截断幂
:kind: counterexample
:given: $k=1$, the two knots $t_i$ of $N_{i,1}$, at $t=t_r$, the first of them; a value of $0_+^0$
:data: t_i = 0 1; 0_+^0 = 1
:instead: 0_+^0 = 0
:then: $(t_{r+1}-t_r)$ times the divided difference of $(\cdot-t_r)_+^0$ is 0, but $N_{i,1}(t_r)=1$
:result: first line = 0
:method: The printed first line, with the value of $0_+^0$ at the first knot and 1 at the second.
:control: the other value
:::
*/
CLAIM(zero_power_at_a_knot_of_multiplicity_k)
{
    int l[2] = {1, 1};
    num tau[2], data[2];
    given_points(T, "t_i", 2, 1, tau);
    data[0] = given(T, "0_+^0");
    data[1] = from_int(1);
    num line = mul(sub(tau[1], tau[0]), G(divided_difference)(2, l, tau, data));
    found(T, "first line", line);
    about(T, "the first line at t = t_r, and N_{i,1}(t_r)");
    same(T, line, from_int(1));
}
#endif

/*
:::{statement} wang-ch4:thm-4.4.1-step-2
:title: The truncated powers replaced by powers
:zh: 证明第二行:截断幂换成幂
:printed: N_{i,k}(t)=\dots=(t_{i+k}-t_i)\sum_{\lambda=1}^d\sum_{\mu=0}^{l_\lambda-1}\alpha_{\lambda\mu}\frac{(k-1)!}{(k-1-\mu)!}
  (\tau_\lambda-t)^{k-1-\mu}
:class: invalid-proof
:refuted-by: full_powers_sum_to_nothing
:corrected: the same sum over the $\lambda$ with $\tau_\lambda>t_r$ only; over all $\lambda$ it is 0, a divided difference
  of order $k$ of a polynomial of degree $k-1$
:corrected-by: truncated_power_gives_the_basis all_full_powers_sum_to_nothing truncated_power_steps_in_every_order linear_factor_in_a_divided_difference
:argued: every k | By `truncated_power_steps_in_every_order` and `linear_factor_in_a_divided_difference` $N_{i,k}$ is $t_{i+k}-t_i$ times the divided
  difference of the truncated power for every $k$, which is this sum by lemma 4.4.1.
  The full power, of degree $k-1$ in $x$, has the coefficient 0 at $x^k$: its divided difference is 0.
:needs: polynomial_of_a_span_ends_with_it | theorem 4.4.1: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:figure: full_powers
:::
*/

/* The printed second line, over all nodes or over those right of t_r. */
static num G(second_line)(const struct G(span) * S, int only_right, num t, int degree)
{
    struct G(nodes) n = G(nodes_of)(S);
    num alpha[LARGEST_ORDER + 1][LARGEST_ORDER + 1], sum = from_int(0);
    G(cofactor_weights)(&n, S->k, alpha);
    for (int i = 0; i < n.d; i++)
        for (int mu = 0; mu < n.l[i]; mu++)
            if (!only_right || n.right[i])
                sum = add(sum, mul(alpha[i][mu], G(power_datum)(S->k, mu, n.tau[i], t, degree)));
    return mul(sub(S->t[S->k], S->t[0]), sum);
}

/*
Then the truncation is forgotten in the print.  A divided difference of order $k$ of a polynomial of degree $k-1$ is
0, so the second and third lines of the proof are 0 for all $t$.  The formula at the end is right nevertheless,
because the condition $\tau_\lambda>t_r$ comes back in (4.4.12).

:::{claim} all_full_powers_sum_to_nothing
:title: With the full powers the sum is always 0
:zh: 不截断则和恒为零
:given: every pattern of the $k+1$ knots of a function, the different knots and $t$ variables; random patterns for greater $k$
:then: $(t_{i+k}-t_i)\sum_{\lambda=1}^d\sum_{\mu=0}^{l_\lambda-1}\alpha_{\lambda\mu}\frac{(k-1)!}{(k-1-\mu)!}(\tau_\lambda-t)^{k-1-\mu}$ is 0 for every $t$
:method: The sum with the weights $\alpha$ of (4.4.9) of all $\tau_\lambda$.
:degrees: 0..4 sampled 7
:scope: every multiplicity of the knots of a function
:over: t#: knots
:control: powers of one degree more
:::
*/
CLAIM(all_full_powers_sum_to_nothing)
{
    int k = T->degree + 1;
    num x[LARGEST_ORDER + 1], t = parameter(T, "t");
    G(increasing)(T, k + 1, x);
    for (int count = G(function_patterns)(k), m = 0; m < count; m++) {
        int pattern = G(function_pattern)(T, k, m);
        if (pattern == 0) /* k+1 equal knots are the knots of no function */
            continue;
        struct G(span) S = G(span_of_function)(k, pattern, 0, x);
        vanishes(T, G(second_line)(&S, 0, t, fault(T, k - 1, k)));
    }
}

#if RATIONAL
/*
:::{claim} full_powers_sum_to_nothing
:title: The printed second line is 0 where the B-spline is not
:zh: 证明第二行恒为零
:kind: counterexample
:given: $k=2$, the three knots $t_i$ of $N_{i,2}$, and a $t$ of the first span, which is $[0,1)$, so that $u=t$
:data: t_i = 0 1 2; t = 1/2
:then: the sum over all $\lambda$ is 0, which $N_{i,2}(t)$ is not; so is the third line, which is the second expanded
:result: second line = 0; third line = 0; N_i,2(t) = 1/2
:method: Both lines by their letter, with the weights of (4.4.9).
:control: only the $\tau_\lambda>t_r$
:::
*/
/* The printed third line at u, over all nodes or over those right of t_r. */
static num G(third_line)(const struct G(span) * S, int only_right, num u)
{
    int k = S->k;
    struct G(nodes) n = G(nodes_of)(S);
    num alpha[LARGEST_ORDER + 1][LARGEST_ORDER + 1], t_r = S->t[S->r], step = sub(t_r, S->t[S->r + 1]),
                                                     sum = from_int(0);
    G(cofactor_weights)(&n, k, alpha);
    for (int i = 0; i < n.d; i++)
        for (int mu = 0; mu < n.l[i]; mu++)
            for (int j = 0; j <= k - mu - 1 && (!only_right || n.right[i]); j++) {
                num factor = mul(div(G(factorial)(k - 1), G(factorial)(k - 1 - mu)), G(choose)(k - 1 - mu, j));
                num powers = mul(G(power)(sub(n.tau[i], t_r), k - 1 - mu - j), G(power)(mul(step, u), j));
                sum = add(sum, mul(alpha[i][mu], mul(factor, powers)));
            }
    return mul(sub(S->t[k], S->t[0]), sum);
}

CLAIM(full_powers_sum_to_nothing)
{
    num x[3];
    given_points(T, "t_i", 3, 1, x);
    num t = given(T, "t");
    struct G(span) S = G(span_of_function)(2, 3, 0, x);
    num line = G(second_line)(&S, fault(T, 1, 0), t, 1), third = G(third_line)(&S, fault(T, 1, 0), t);
    num value = G(basis_value)(&S, 0, 2, t);
    found(T, "second line", line);
    found(T, "third line", third);
    found(T, "N_i,2(t)", value);
    about(T, "whether the second line or the third is N_i,2(t)");
    refute(T, !equal_q(line, value) && !equal_q(third, value));
}
#endif

/*
:::{statement} wang-ch4:thm-4.4.1-step-3
:title: The powers expanded in u
:zh: 证明第三行:按 u 展开
:printed: N_{i,k}(t)=\dots=(t_{i+k}-t_i)\sum_{\lambda=1}^d\sum_{\mu=0}^{l_\lambda-1}\alpha_{\lambda\mu}\frac{(k-1)!}{(k-1-\mu)!}
  \sum_{j=0}^{k-\mu-1}\binom{k-1-\mu}j(\tau_\lambda-t_r)^{k-1-\mu-j}(t_r-t_{r+1})^ju^j
:class: invalid-proof
:refuted-by: full_powers_sum_to_nothing
:corrected: the expansion itself is right, term by term, and gives $N_{i,k}$ when only the $\tau_\lambda>t_r$ are summed
:corrected-by: binomial_theorem_in_every_degree truncated_power_gives_the_basis truncated_power_steps_in_every_order linear_factor_in_a_divided_difference
:argued: every k | By `truncated_power_steps_in_every_order` and `linear_factor_in_a_divided_difference` $N_{i,k}$ is $t_{i+k}-t_i$ times the divided
  difference of the truncated power for every $k$, which is the second line as
  corrected.
:needs: empty_span_has_no_parameter | theorem 4.4.1: the interval $[t_r,t_{r+1})$ is not empty | the span is not empty
:needs: polynomial_of_a_span_ends_with_it | theorem 4.4.1: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:confirmed-by: powers_expand_in_the_parameter printed_double_sum_gives_the_basis
:figure: full_powers
:::

:::{statement} wang-ch4:thm-4.4.1-step-expansion
:title: From the second line to the third
:zh: 由第二行到第三行的二项展开
:printed: \frac{(k-1)!}{(k-1-\mu)!}(\tau_\lambda-t)^{k-1-\mu}=\frac{(k-1)!}{(k-1-\mu)!}\sum_{j=0}^{k-\mu-1}
  \binom{k-1-\mu}j(\tau_\lambda-t_r)^{k-1-\mu-j}(t_r-t_{r+1})^ju^j
:holds-by: binomial_theorem_in_every_degree
:confirmed-by: powers_expand_in_the_parameter
:needs: empty_span_has_no_parameter | theorem 4.4.1: the interval $[t_r,t_{r+1})$ is not empty | the span is not empty
:figure: full_powers
:::

The binomial theorem is an induction on the exponent, whose step is Pascal's rule.  So it is computed for all exponents at
once.
*/

/* (x+y)^0 = 1, and x C(n,i) x^(n-i) y^i + y C(n,i-1) x^(n+1-i) y^(i-1) = C(n+1,i) x^(n+1-i) y^i, with c = C(n,i) and U = x^(h-1) y^(i-1), n = i+h-1. */
static void G(check_binomial_step)(trial *T, num x, num y)
{
    num i = whole(T, "i", 1, 9), h = whole(T, "h", 1, 9), c = unknown(T, "c", 0), U = unknown(T, "U", 0),
        one = from_int(1);
    about(T, "the exponent 0");
    same(T, G(power)(add(x, y), 0), mul(G(choose)(0, 0), mul(G(power)(x, 0), G(power)(y, 0))));
    about(T, "from one exponent to the next");
    num here = mul(c, mul(U, y)), before = mul(div(mul(c, fault(T, i, add(i, one))), h), mul(U, x));
    same(T, add(mul(x, here), mul(y, before)), mul(div(mul(c, add(i, h)), h), mul(U, mul(x, y))));
}

/*
:::{claim} binomial_theorem_in_every_degree
:title: From one power of a sum to the next, whatever the exponent
:zh: 二项式定理(任意次数)
:types: field rational
:given: $x=\tau-t_r$ and $y=(t_r-t_{r+1})u$; integers $i,h\ge1$, $n=i+h-1$
:let: $c=\binom ni$, so that $\binom n{i-1}=c\frac ih$ and $\binom{n+1}i=c\frac{i+h}h$; $U=x^{h-1}y^{i-1}$
:then: $x+y$ is $\tau-t$ for $t=t_r+(t_{r+1}-t_r)u$; and $x\binom nix^{n-i}y^i+y\binom n{i-1}x^{n+1-i}y^{i-1}=\binom{n+1}ix^{n+1-i}y^i$
:method: The step of an induction on $n$, in which $i$, $h$, $c$ and $U$ are variables: $(x+y)^{n+1}$ is $x+y$ times $(x+y)^n$, and for $i=0$ and
  $i=n+1$ there is one term on either side.  $(x+y)^0=1$.
:degrees: all
:over: t#: knots; i h c U: -
:control: $i+1$ for $i$ in $\binom n{i-1}$
:::
*/
CLAIM(binomial_theorem_in_every_degree)
{
    num t[2], u = parameter(T, "u"), tau = unknown(T, "tau", 0);
    G(increasing)(T, 2, t);
    num step = mul(u, sub(t[1], t[0])), at = add(t[0], step);
    about(T, "the sum of the two");
    same(T, add(sub(tau, t[0]), neg(step)), sub(tau, at));
    G(check_binomial_step)(T, sub(tau, t[0]), neg(step));
}

/*
:::{claim} power_of_t_in_every_degree
:title: From one power of t to the next, whatever the exponent
:zh: t 的幂的二项展开(任意次数)
:types: field rational
:given: $x=t_r$ and $y=(t_{r+1}-t_r)u$; integers $i,h\ge1$, $n=i+h-1$
:let: $c=\binom ni$, so that $\binom n{i-1}=c\frac ih$ and $\binom{n+1}i=c\frac{i+h}h$; $U=x^{h-1}y^{i-1}$
:then: $x+y$ is $t$ for $u=(t-t_r)/(t_{r+1}-t_r)$; and $x\binom nix^{n-i}y^i+y\binom n{i-1}x^{n+1-i}y^{i-1}=\binom{n+1}ix^{n+1-i}y^i$
:method: The step of an induction on $n$, in which $i$, $h$, $c$ and $U$ are variables: $(x+y)^{n+1}$ is $x+y$ times $(x+y)^n$, and for $i=0$ and
  $i=n+1$ there is one term on either side.  $(x+y)^0=1$.
:degrees: all
:over: t#: knots; i h c U: -
:control: $i+1$ for $i$ in $\binom n{i-1}$
:::
*/
CLAIM(power_of_t_in_every_degree)
{
    num t[2], u = parameter(T, "u");
    G(increasing)(T, 2, t);
    num length = sub(t[1], t[0]), step = mul(u, length);
    about(T, "the parameter of the sum of the two");
    same(T, div(sub(add(t[0], step), t[0]), length), u);
    G(check_binomial_step)(T, t[0], step);
}

/*
:::{claim} powers_expand_in_the_parameter
:title: The expansion of a power of tau - t in powers of u
:zh: (τ-t) 的幂按 u 展开
:given: every $\mu<k$, with $\tau,t_r,t_{r+1},u$ variables
:then: the two sides agree, and $\frac{(k-1)!}{(k-1-\mu)!}\binom{k-1-\mu}j=\frac{(k-1)!}{j!(k-1-\mu-j)!}$
:method: Both sides at $t=t_r+u(t_{r+1}-t_r)$.
:degrees: 0..6 sampled 12
:over: t#: knots
:control: $t_{r+1}-t_r$ in the place of $t_r-t_{r+1}$
:::
*/
CLAIM(powers_expand_in_the_parameter)
{
    int k = T->degree + 1;
    num t[2], tau = unknown(T, "tau", 0), u = parameter(T, "u");
    G(increasing)(T, 2, t);
    num at = add(t[0], mul(u, sub(t[1], t[0]))), step = fault(T, sub(t[0], t[1]), sub(t[1], t[0]));
    for (int mu = 0; mu < k; mu++) {
        num sum = from_int(0);
        for (int j = 0; j <= k - mu - 1; j++) {
            num factor = mul(div(G(factorial)(k - 1), G(factorial)(k - 1 - mu)), G(choose)(k - 1 - mu, j));
            /* (k-1)!/(k-1-μ)! C(k-1-μ, j) = (k-1)!/(j! (k-1-μ-j)!) */
            same(T, factor, div(G(factorial)(k - 1), mul(G(factorial)(j), G(factorial)(k - 1 - mu - j))));
            num term = mul(G(power)(sub(tau, t[0]), k - 1 - mu - j), mul(G(power)(step, j), G(power)(u, j)));
            sum = add(sum, mul(factor, term));
        }
        same(T, G(power_datum)(k, mu, tau, at, k - 1), sum);
    }
}

/*
:::{statement} wang-ch4:thm-4.4.1-step-collect
:title: The sums exchanged
:zh: 整理和式
:printed: arranging the sums gives (4.4.11)
:holds-by: summation_limits_agree_in_every_order
:confirmed-by: summation_orders_agree powers_expand_in_the_parameter
:hypothesis: full_powers_sum_to_nothing | the condition $\tau_\lambda>t_r$ of (4.4.12), which the second and the third line lack, is
  put back
:figure: full_powers

The powers of $u$ in the third line are collected; their coefficients are to be the $a_{ji}$ of (4.4.12), of which (4.4.11) is made.
:::

In the end the powers of $u$ are collected, which exchanges two sums.  The new limits are found by asking for which
$\mu$ a given $j$ occurs.

:::{claim} summation_limits_agree_in_every_order
:title: The limits and the factors of the collected sum, whatever the order
:zh: 求和上限与系数(任意阶数)
:types: field rational
:given: $1\le l\le k$, an exponent $j\ge0$, once $j=k-l+d$ and once $k-l=j+d$ with $d\ge0$
:harmless: with $d\ge0$ | one of the two is the greater, and $d$ the difference
:let: $m=\max(j,k-l)$, the first of these in one case, the second in the other; $A=j!$, $B=(k-1-\mu-j)!$, $\binom{k-1-\mu}j=\frac{(k-1-\mu)!}{AB}$
:then: $k-1-m$ is $k-1-j$, which is $d$ less than $l-1$, in the first case; in the second it is $l-1$, which is $d$ less than $k-1-j$; and
  $\frac{(k-1)!}{(k-1-\mu)!}\binom{k-1-\mu}j=\frac{(k-1)!}{AB}$
:method: Identities in $k$, $l$, $j$ and $d$, and in the factorials.  Of the $k+1$ knots of the function one at least is $t_r$ or before it, so that those behind $t_r$ have $l\le k$.  So $\mu\le l-1$ and $\mu\le k-1-j$, which is $j\le k-\mu-1$, say together
  $\mu\le k-1-\max(j,k-l)$, and the term of $\mu$ and $j$ is the same in both sums.
:degrees: all
:over: l j d k: -; A B C D: -
:control: $\max$ replaced by $\min$
:::
*/
CLAIM(summation_limits_agree_in_every_order)
{
    num l = whole(T, "l", 1, 9), j = whole(T, "j", 0, 9), d = whole(T, "d", 1, 9), one = from_int(1);
    for (int second = 0; second <= 1; second++) {
        num less = second ? j : whole(T, "k", 0, 9), more = add(less, d); /* of j and k - l */
        num k = add(l, second ? more : less), mine = second ? less : more;
        num limit = sub(sub(k, one), fault(T, more, less)), first = sub(l, one), other = sub(sub(k, one), mine);
        about(T, second ? "k - l is the greater" : "j is the greater");
        same(T, limit, second ? first : other);
        same(T, sub(second ? other : first, limit), d);
    }
    num A = positive(T, "A", 0), B = positive(T, "B", 0), C = positive(T, "C", 0), D = positive(T, "D", 0);
    about(T, "the factors"); /* C = (k-1)!, D = (k-1-μ)! */
    same(T, mul(div(C, D), div(D, mul(A, B))), div(C, mul(A, B)));
}

#if RATIONAL
/*
:::{claim} summation_orders_agree
:title: The pairs of mu and j are the same in both orders of summation
:zh: 两种求和次序的指标集相同
:kind: decision
:given: $1\le l\le k$
:then: $\{\mu\le l-1,\ j\le k-\mu-1\}=\{j\le k-1,\ \mu\le k-1-\max(j,k-l)\}$ for nonnegative $\mu$ and $j$
:method: Both sets are listed.
:degrees: k = 1..12
:control: $\max$ replaced by $\min$
:::
*/
CLAIM(summation_orders_agree)
{
    int k = T->degree;
    for (int l = 1; l <= k; l++)
        for (int mu = 0; mu <= k; mu++)
            for (int j = 0; j <= k; j++) {
                int larger = fault(T, j > k - l ? j : k - l, j < k - l ? j : k - l);
                int printed = mu <= l - 1 && j <= k - mu - 1, collected = j <= k - 1 && mu <= k - 1 - larger;
                agree(T, printed == collected);
            }
}
#endif

#include "chapters/judge/claims_off.h"
