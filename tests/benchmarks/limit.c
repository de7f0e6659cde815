/* The limit of the machine for exactly this model, written by hand: the thesis's non-linear
 * aircraft with a, Ct, u and v0 from lane to lane and everything else folded into constants.
 *
 * Blocks of LANES trajectories as structure of arrays; DOP853 with one fixed step for all, whose
 * number is tuned by knowing the answer (for the single one, growing steps); v and r only are carried through the stages, y and theta
 * are sums at the end.  atan and sin are inlined polynomials.  -Ofast, -march=native.
 */
#include <math.h>
#include <stdint.h>
#include <string.h>
#include "constants.h" /* tableau, polynomials and the aircraft, written by build.py */

#ifdef __AVX512F__
#define W 8
#else
#define W 4
#endif
#ifndef VECTORS
#define VECTORS 4
#endif
enum { LANES = W * VECTORS };
typedef double vec __attribute__((vector_size(8 * W)));
typedef int64_t mask __attribute__((vector_size(8 * W)));
#define INLINE static inline __attribute__((always_inline))
#define EACH for (int k = 0; k < VECTORS; ++k)
#define FENCE __asm__ volatile("" ::: "memory")

INLINE vec pick(mask m, vec yes, vec no) { return (vec)((m & (mask)yes) | (~m & (mask)no)); }

INLINE vec v_atan(vec x)
{
    const mask sign = (mask)x & INT64_MIN;
    const vec z = (vec)((mask)x & INT64_MAX), one = (vec){} + 1.0, zero = (vec){};
    const mask mid = z > TAN_PI_8, big = z > COT_PI_8;
    const vec t = (pick(big, zero, z) - pick(mid, one, zero)) / (pick(big, zero, one) + pick(mid, z, zero));
    const vec s = t * t, s2 = s * s;
    const vec offset = pick(mid, zero + 0.7853981633974483, zero) + pick(big, zero + 0.7853981633974483, zero);
    return (vec)((mask)(offset + (t + t * s * (ATAN_POLYNOMIAL))) | sign);
}

/* |x| < C1 pi/2 < 0.3 */
INLINE vec v_sin(vec x)
{
    const vec s = x * x;
    return x + x * s * (-1.0 / 6 + s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880 - s * (1.0 / 39916800)))));
}

typedef struct { vec c1[VECTORS], a[VECTORS], u[VECTORS], iu[VECTORS], km[VECTORS], ki[VECTORS], fm[VECTORS], fi[VECTORS]; } plane;

INLINE void rates(const plane *p, const vec *v, const vec *r, vec *fv, vec *fr)
{
    vec x[VECTORS], g[VECTORS];
    EACH {
        const vec z = p->c1[k] * (v[k] + p->a[k] * r[k]);
        g[k] = v_atan((v[k] - ARM_B * r[k]) * p->iu[k]);
        x[k] = (1 - E1) * z + E1 * v_atan(z);
    }
    FENCE;
    EACH {
        const vec s = v_sin(C1 * v_atan(x[k]));
        fv[k] = -p->km[k] * s - p->fm[k] * g[k] - p->u[k] * r[k];
        fr[k] = -p->ki[k] * s + p->fi[k] * g[k];
    }
    FENCE;
}

static void set(plane *p, int lane, double a, double Ct, double u)
{
    const double force = 2 * D1 * (B5 + C5 * FZ) * FZ, tail = 0.5 * RHO * u * u * AP * CL_GAMMA + Ct;
    ((double *)p->c1)[lane] = B1 * (B3 + C3 * FZ) / (u * (B5 + C5 * FZ));
    ((double *)p->a)[lane] = a;
    ((double *)p->u)[lane] = u;
    ((double *)p->iu)[lane] = 1 / u;
    ((double *)p->km)[lane] = force / MASS;
    ((double *)p->ki)[lane] = a * force / IZZ;
    ((double *)p->fm)[lane] = tail / MASS;
    ((double *)p->fi)[lane] = ARM_B * tail / IZZ;
}

static void block(const plane *p, vec *v, vec *r, vec *y, vec *q, int steps)
{
    const double h = T_END / steps;
    vec kv[12][VECTORS], kr[12][VECTORS], sv[VECTORS], sr[VECTORS];
    for (int n = 0; n < steps; ++n) {
        rates(p, v, r, kv[0], kr[0]);
        STAGES
        EACH {
            const vec dv = LAST_SUM(kv), dr = LAST_SUM(kr);
            y[k] += h * (WEIGHT_SUM * v[k] + h * QUADRATURE_SUM(kv));
            q[k] += h * (WEIGHT_SUM * r[k] + h * QUADRATURE_SUM(kr));
            v[k] += h * dv;
            r[k] += h * dr;
        }
    }
}

void ensemble(int64_t n, const double *a, const double *Ct, const double *u, const double *v0, int64_t steps, double *out, int64_t threads)
{
#pragma omp parallel for schedule(dynamic, 4) num_threads((int)threads)
    for (int64_t from = 0; from < n; from += LANES) {
        plane p;
        vec v[VECTORS], r[VECTORS] = {}, y[VECTORS] = {}, q[VECTORS] = {};
        for (int l = 0; l < LANES; ++l) {
            const int64_t i = from + l < n ? from + l : n - 1;
            set(&p, l, a[i], Ct[i], u[i]);
            ((double *)v)[l] = v0[i];
        }
        block(&p, v, r, y, q, (int)steps);
        for (int l = 0; l < LANES && from + l < n; ++l) {
            double *o = out + 4 * (from + l);
            o[0] = ((double *)v)[l], o[1] = ((double *)r)[l], o[2] = ((double *)y)[l], o[3] = ((double *)q)[l];
        }
    }
}

/* ---- one trajectory with dense output -------------------------------------------------- */

INLINE double s_atan(double x)
{
    const double z = fabs(x);
    double t = z, offset = 0;
    if (__builtin_expect(z > TAN_PI_8, 0)) {
        offset = z > COT_PI_8 ? 1.5707963267948966 : 0.7853981633974483;
        t = z > COT_PI_8 ? -1 / z : (z - 1) / (1 + z);
    }
    const double s = t * t, s2 = s * s;
    return copysign(offset + (t + t * s * (ATAN_POLYNOMIAL)), x);
}

INLINE double s_sin(double x)
{
    const double s = x * x;
    return x + x * s * (-1.0 / 6 + s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880 - s * (1.0 / 39916800)))));
}

typedef double four __attribute__((vector_size(32)));
typedef struct { double c1, a, u, iu, km, ki, fm, fi; } one;

INLINE four s_rates(const one *p, four x)
{
    const double z = p->c1 * (x[0] + p->a * x[1]), g = s_atan((x[0] - ARM_B * x[1]) * p->iu);
    const double s = s_sin(C1 * s_atan((1 - E1) * z + E1 * s_atan(z)));
    return (four){-p->km * s - p->fm * g - p->u * x[1], -p->ki * s + p->fi * g, x[0], x[1]};
}

void single(double a, double Ct, double u, double v0, int64_t steps, double growth, int64_t n,
            int64_t repeat, double *out)
{
    const double force = 2 * D1 * (B5 + C5 * FZ) * FZ, tail = 0.5 * RHO * u * u * AP * CL_GAMMA + Ct;
    const one p = {B1 * (B3 + C3 * FZ) / (u * (B5 + C5 * FZ)), a, u, 1 / u, force / MASS, a * force / IZZ,
                   tail / MASS, ARM_B * tail / IZZ};
    double first = T_END, sum = 0, dt = T_END / (n - 1);
    for (int64_t m = 0; m < steps; ++m)
        sum = 1 + growth * sum;
    first /= sum;
    while (repeat--) {
        four x = {v0, 0, 0, 0}, w, z, f[16], d[7];
        int64_t o = 0;
        double h = first, t0 = 0;
        f[0] = s_rates(&p, x);
        for (int64_t m = 0; m < steps; ++m) {
            SINGLE_STAGES
            const double t1 = m + 1 == steps ? T_END * (1 + 1e-14) : t0 + h, ih = 1 / h;
            if (o * dt <= t1) {
                SINGLE_DENSE
                for (; o < n && o * dt <= t1; ++o) {
                    const double s = (o * dt - t0) * ih, e = 1 - s, s2 = s * s, e2 = e * e;
                    /* powers first: a short chain of products instead of six links */
                    const four y = x + s * d[0] + s * e * d[1] + s2 * e * d[2] + s2 * e2 * d[3]
                        + s2 * s * e2 * d[4] + s2 * s * e2 * e * d[5] + s2 * s2 * e2 * e * d[6];
                    memcpy(out + 4 * o, &y, sizeof y);
                }
            }
            x = w;
            f[0] = f[12];
            t0 += h;
            h *= growth;
        }
    }
}

/* ---- linearisations: eigenvalues, damping, frequency ------------------------------------ */

void linear(int64_t n, const double *a, const double *Ct, const double *u, double *const *y, int64_t threads)
{
    double *re1 = y[0], *im1 = y[1], *re2 = y[2], *im2 = y[3], *damping = y[4], *frequency = y[5];
#pragma omp parallel for simd schedule(static) num_threads((int)threads)
    for (int64_t i = 0; i < n; ++i) {
        const double iu = 1 / u[i], K = Ct[i] + 0.5 * RHO * AP * CL_GAMMA * u[i] * u[i], F = 2 * C_ALPHA;
        const double vv = -(F + K) * iu / MASS, vr = -(F * a[i] - K * ARM_B) * iu / MASS - u[i];
        const double rv = -(F * a[i] - K * ARM_B) * iu / IZZ, rr = -(F * a[i] * a[i] + K * ARM_B * ARM_B) * iu / IZZ;
        const double mean = 0.5 * (vv + rr), half = 0.5 * (vv - rr), D = half * half + vr * rv;
        const double root = sqrt(fabs(D)), det = vv * rr - vr * rv, natural = sqrt(det);
        const double spread = D > 0 ? root : 0, turn = D > 0 ? 0 : root;
        re1[i] = mean + spread;
        re2[i] = mean - spread;
        im1[i] = turn;
        im2[i] = -turn;
        damping[i] = -mean / natural;
        frequency[i] = natural;
    }
}
