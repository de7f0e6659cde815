/* Generated from derive/ (digest 0b025fe68865f259) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
/* Functions of states, inputs and parameters at many points, some points side by side.
 *
 * An argument is a column, or one number if its stride is 0; a result is rows of so many numbers,
 * one row for each point, or NULL if it is not wanted. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { LANES = 32 };
#define INLINE static inline __attribute__((always_inline))
#define APART static __attribute__((noinline))
#define SHOWN __attribute__((visibility("default")))
#define LANE_LOOP _Pragma("omp simd") for (int l = 0; l < LANES; ++l)
typedef double lanes[LANES];

/* ---- elementary functions, branch-free so that loops over lanes become vector code ---------
 * Errors of few units of the last place, as tests/test_elementary.py says.  NaN in, NaN out. */

INLINE int64_t bits(double x) { int64_t b; memcpy(&b, &x, sizeof b); return b; }
INLINE double from_bits(int64_t b) { double x; memcpy(&x, &b, sizeof x); return x; }

/* x where the mask is -1, 0 where it is 0.  Masks, because gcc takes ?: apart into paths and puts
 * them together again with one division for each path. */
INLINE double only(int64_t mask, double x) { return from_bits(mask & bits(x)); }

/* t of lane_atan and the angle to add. */
INLINE double fold(double z, double *offset)
{
    const int64_t mid = -(int64_t)(z > 0.41421356237309503), big = -(int64_t)(z > 2.414213562373095);
    *offset = only(mid, 0.7853981633974483) + only(big, 0.7853981633974483);
    return (only(~big, z) - only(mid, 1.0)) / (only(~big, 1.0) + only(mid, z));
}

/* atan: |x| to t in [-tan(pi/8), tan(pi/8)] by t = z, (z - 1) / (z + 1) or -1 / z, then
 * t + t s P(s) with s = t t. */
INLINE double lane_atan(double x)
{
    double offset;
    const double t = fold(fabs(x), &offset), s = t * t, s2 = s * s;
    const double p = (-0.3333333333333015 + s2 * (-0.14285714195261148 + s2 * (-0.09090782412337584 + s2 * (-0.06641121186601258 + s2 * -0.04359095370168373)))) + s * (0.19999999999088952 + s2 * (0.11111106653580938 + s2 * (0.07690068299297602 + s2 * (0.05692538997871437 + s2 * 0.021259847052258217))));
    return copysign(offset + (t + t * s * p), x);
}

/* (-1)^k sin(x - n pi), n = k + shift, k = round(x / pi - shift): sine with shift 0, cosine 1/2.
 * Three-part Cody-Waite reduction, good to |x| = 1.6e6; beyond that NaN, not wrong
 * digits. */
INLINE double lane_wave(double x, double shift)
{
    const double magic = 6755399441055744.0;    /* 1.5 * 2^52: adding it rounds to a whole number */
    const double rounded = x * 0.3183098861837907 - shift + magic, n = rounded - magic + shift;
    const double r0 = ((x - n * 3.1415926534682512) - n * 1.2154201012607932e-10) - n * 4.044532497591901e-21;
    const double r = from_bits(bits(r0) | -(int64_t)!(fabs(x) < 1.6e6));
    const double s = r * r, s2 = s * s;
    const double p = (-0.16666666666666666 + s2 * (-0.0001984126984120885 + s2 * (-2.5052106866687343e-08 + s2 * -7.642983119287835e-13))) + s * (0.008333333333333193 + s2 * (2.755731921107215e-06 + s2 * (1.6058939391233316e-10 + s2 * 2.721085003160315e-15)));
    return from_bits(bits(r + r * s * p) ^ (int64_t)((uint64_t)bits(rounded) << 63));
}

INLINE double lane_sin(double x) { return lane_wave(x, 0.0); }
INLINE double lane_cos(double x) { return -lane_wave(x, 0.5); }
INLINE double lane_tan(double x) { return lane_sin(x) / lane_cos(x); }

/* 2^n for whole numbers from -1022 to 1023, as they stand in the last bits of n + magic. */
INLINE double two_to(int64_t n) { return from_bits((int64_t)((uint64_t)(n + 1023) << 52)); }

/* r and n of x = n log 2 + r, |r| <= log(2) / 2; the whole number is handed on as an integer. */
INLINE double halve(double x, int64_t *n)
{
    const double magic = 6755399441055744.0, rounded = x * 1.4426950408889634 + magic;
    const double whole = rounded - magic;
    *n = bits(rounded) - bits(magic);
    return (x - whole * 0.6931471804855391) - whole * 7.440617110012397e-11;
}

/* exp(s) - 1 for |s| <= log(2) / 2 */
INLINE double small_expm1(double s)
{
    const double s2 = s * s, p = (0.5000000000000011 + s2 * (0.04166666666652901 + s2 * (0.0013888888943991541 + s2 * (2.4801492673882887e-05 + s2 * 2.763041554362714e-07)))) + s * (0.16666666666666402 + s2 * (0.00833333333350108 + s2 * (0.0001984126949183641 + s2 * (2.7557599835008617e-06 + s2 * 2.4995723761300685e-08))));
    return s + s2 * p;
}

/* exp: beyond what a number can hold infinity or 0, in two factors that both can be held. */
INLINE double lane_exp(double x)
{
    const double most = x > 710.0 ? 710.0 : x, y = most < -746.0 ? -746.0 : most;
    int64_t n;
    const double e = small_expm1(halve(y, &n)), one = two_to(n >> 1), two = two_to(n - (n >> 1));
    return (one + one * e) * two;
}

/* exp(x) - 1, exact where x is small; up to 700. */
INLINE double bounded_expm1(double x)
{
    const double y = x < -40.0 ? -40.0 : x;
    int64_t n;
    const double e = small_expm1(halve(y, &n)), power = two_to(n);
    return power * e + (power - 1.0);
}

INLINE double lane_expm1(double x)
{
    const double large = lane_exp(x), small = bounded_expm1(x > 40.0 ? 40.0 : x);
    return x > 40.0 ? large : small;
}

/* log(2^n (1 + f)) + more, 1 + f between the roots of 1/2 and 2. */
INLINE double sum_log(double n, double f, double more)
{
    const double t = f / (2.0 + f), s = t * t, s2 = s * s, half = 0.5 * f * f;
    const double p = (0.6666666666666735 + s2 * (0.28571428743261834 + s2 * (0.18183569731612698 + s2 * 0.14797505200529643))) + s * (0.39999999999411096 + s2 * (0.22222198476116337 + s2 * 0.15313903480505622));
    return n * 0.6931471804855391 - ((half - (t * (half + s * p) + (n * 7.440617110012397e-11 + more))) - f);
}

/* n and f of x = 2^n (1 + f), x > 0 and normal. */
INLINE double take_apart(double x, double *n)
{
    const int64_t root = 0x3fe6a09e667f3bcd, apart = bits(x) - root, power = apart >> 52;
    *n = from_bits(power + 0x4338000000000000) - 6755399441055744.0;
    return from_bits((apart & 0xfffffffffffff) + root) - 1.0;
}

INLINE double lane_log(double x)
{
    const int tiny = x < DBL_MIN;
    double n;
    const double f = take_apart(tiny ? x * 0x1p54 : x, &n);
    const double finite = sum_log(tiny ? n - 54.0 : n, f, 0.0);
    const double sound = x < INFINITY ? finite : x, lost = x < 0.0 ? NAN : sound;
    return x == 0.0 ? -INFINITY : lost;
}

/* log(1 + x): what is lost in 1 + x is added again. */
INLINE double lane_log1p(double x)
{
    const double u = 1.0 + x, rest = u > 0x1p53 ? 0.0 : (x - (u - 1.0)) / u;
    double n;
    const double finite = sum_log(n, take_apart(u, &n), rest);
    const double sound = x < INFINITY ? finite : x, lost = x < -1.0 ? NAN : sound;
    return x == -1.0 ? -INFINITY : lost;
}

/* x^y; a negative x has whole powers only.  Its error is |y log x| units of the last place. */
INLINE double lane_pow(double x, double y)
{
    const double size = lane_exp(y * lane_log(fabs(x))), half = 0.5 * y;
    const double odd = half == floor(half) ? 1.0 : -1.0, whole = y == floor(y) ? odd : NAN;
    const double signed_size = x < 0.0 ? whole * size : size;
    return y == 0.0 || x == 1.0 ? 1.0 : signed_size;
}

INLINE double lane_tanh(double x)
{
    const double size = fabs(x), e = bounded_expm1(2.0 * (size > 20.0 ? 20.0 : size));
    return copysign(e / (e + 2.0), x);
}

INLINE double lane_sinh(double x)
{
    const double size = fabs(x), e = bounded_expm1(size > 40.0 ? 40.0 : size);
    const double half = lane_exp(0.5 * size);
    return copysign(size > 40.0 ? 0.5 * half * half : 0.5 * (e + e / (e + 1.0)), x);
}

INLINE double lane_cosh(double x)
{
    const double size = fabs(x), half = lane_exp(0.5 * size), e = lane_exp(size > 40.0 ? 40.0 : size);
    return size > 40.0 ? 0.5 * half * half : 0.5 * (e + 1.0 / e);
}

INLINE double lane_asinh(double x)
{
    const double size = fabs(x), most = size > 1e9 ? 1e9 : size, square = most * most;
    const double near = lane_log1p(most + square / (1.0 + sqrt(1.0 + square)));
    const double far = lane_log(size) + 0.6931471805599453;
    return copysign(size > 1e9 ? far : near, x);
}

INLINE double lane_acosh(double x)
{
    const double t = x - 1.0, most = t > 1e9 ? 1e9 : t;
    const double near = lane_log1p(most + sqrt(most * (most + 2.0)));
    const double far = lane_log(x) + 0.6931471805599453;
    return t > 1e9 ? far : near;
}

INLINE double lane_atanh(double x)
{
    const double size = fabs(x);
    return copysign(0.5 * lane_log1p(2.0 * size / (1.0 - size)), x);
}

INLINE double lane_asin(double x) { return lane_atan(x / sqrt((1.0 - x) * (1.0 + x))); }
INLINE double lane_acos(double x) { return 2.0 * lane_atan(sqrt((1.0 - x) / (1.0 + x))); }

/* Angle of (x, y), with the signs of zero as in C. */
INLINE double lane_atan2(double y, double x)
{
    const double a = fabs(x), b = fabs(y), more = a > b ? a : b, less = a > b ? b : a;
    const double ratio = less == more ? (more == 0.0 ? 0.0 : 1.0) : less / more;
    const double angle = lane_atan(ratio), first = b > a ? 1.5707963267948966 - angle : angle;
    const double turned = bits(x) < 0 ? 3.141592653589793 - first : first;
    return copysign(a + b == a + b ? turned : a + b, y);
}

INLINE double lane_hypot(double x, double y) { return sqrt(x * x + y * y); }

/* Minimum and maximum that let NaN through, unlike fmin and fmax. */
INLINE double lane_min(double a, double b) { return a < b ? a : (b <= a ? b : a + b); }
INLINE double lane_max(double a, double b) { return a > b ? a : (b >= a ? b : a + b); }

INLINE double lane_sign(double a) { return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : a); }


typedef struct {
    int64_t n, threads;
    const double *const *in;     /* [arguments] */
    const int64_t *stride;
    double *const *out;          /* [results], each [n][size] or NULL */
} points_t;

/* What a function computes in rows w: arguments first, then whatever comes of them. `place` is for
 * every element of every result the row that it stands in; row 0 holds zeros. */
typedef struct {
    int n_in, n_out, rows;
    const int16_t *in;           /* [n_in] which of the arguments */
    const int16_t *size;         /* [n_out] */
    const int16_t *place;
    void (*run)(lanes *w);
} function_t;

/* Points from `from` to `end`, no more than there are lanes. */
static void some(const function_t *f, const points_t *job, lanes *w, int64_t from, int64_t end)
{
    const int count = (int)(end - from);
    for (int k = 0; k < f->n_in; ++k) {
        const int64_t stride = job->stride[f->in[k]];
        const double *column = job->in[f->in[k]] + stride * from;
        for (int l = 0; l < LANES && stride; ++l)
            w[1 + k][l] = column[l < count ? l : count - 1];
    }
    f->run(w);
    for (int r = 0, e = 0; r < f->n_out; e += f->size[r++]) {
        double *out = job->out[r];
        if (!out)
            continue;
        out += from * f->size[r];
        for (int k = 0; k < f->size[r]; ++k)
            for (int l = 0; l < count; ++l)
                out[l * f->size[r] + k] = w[f->place[e + k]][l];
    }
}

static void all(const function_t *f, const points_t *job)
{
    const int64_t blocks = (job->n + LANES - 1) / LANES;
#pragma omp parallel num_threads((int)job->threads) if (job->threads > 1)
    {
        lanes w[f->rows] __attribute__((aligned(64)));
        for (int l = 0; l < LANES; ++l)
            w[0][l] = 0.0;
        for (int k = 0; k < f->n_in; ++k)
            for (int l = 0; l < LANES; ++l)
                w[1 + k][l] = *job->in[f->in[k]];
#pragma omp for schedule(static)
        for (int64_t b = 0; b < blocks; ++b) {
            const int64_t from = b * LANES, left = job->n - from;
            some(f, job, w, from, left < LANES ? job->n : from + LANES);
        }
    }
}

APART void nonlinear_rhs_0(lanes *restrict w)
{
    LANE_LOOP {
        const double r16 = w[16][l];
        const double r14 = w[14][l];
        const double v0 = r16 * r14;
        const double r7 = w[7][l];
        const double r2 = w[2][l];
        const double v1 = r7 * r2;
        const double r15 = w[15][l];
        const double v2 = r15 + v0;
        const double r1 = w[1][l];
        const double v3 = r1 + v1;
        const double v4 = v2 * v3;
        const double r18 = w[18][l];
        const double v5 = r18 * r14;
        const double r17 = w[17][l];
        const double v6 = r17 + v5;
        const double r9 = w[9][l];
        const double v7 = v6 * r9;
        const double v8 = 1.0 / v7;
        const double v9 = v4 * v8;
        const double r22 = w[22][l];
        const double v10 = -r22;
        const double v11 = v10 + 1.0;
        const double v12 = v9 * v11;
        const double r19 = w[19][l];
        const double v13 = r19 * v9;
        const double v14 = lane_atan(v13);
        const double v15 = r22 * v14;
        const double v16 = 1.0 / r19;
        const double v17 = v15 * v16;
        const double v18 = v12 + v17;
        const double v19 = r19 * v18;
        const double r11 = w[11][l];
        const double r12 = w[12][l];
        const double v20 = r11 * r12;
        const double r8 = w[8][l];
        const double v21 = r8 * r2;
        const double v22 = 1.0 / r9;
        const double v23 = -v21;
        const double v24 = r1 + v23;
        const double v25 = v24 * v22;
        const double v26 = lane_atan(v25);
        const double v27 = v20 * v26;
        const double r10 = w[10][l];
        const double v28 = v27 * r10;
        const double v29 = r9 * r9;
        const double v30 = v28 * v29;
        const double r13 = w[13][l];
        const double v31 = r13 * v26;
        const double r5 = w[5][l];
        const double v32 = 1.0 / r5;
        const double v33 = (-0.5) * v30;
        const double r4 = w[4][l];
        const double v34 = r4 + v33;
        const double v35 = -v31;
        const double v36 = v34 + v35;
        const double v37 = r2 * r9;
        const double v38 = -v37;
        const double v39 = v30 * r8;
        const double v40 = r4 * r8;
        const double v41 = v31 * r8;
        const double r6 = w[6][l];
        const double v42 = 1.0 / r6;
        const double v43 = -v40;
        const double v44 = 0.5 * v39;
        const double v45 = v43 + v44;
        const double v46 = v45 + v41;
        const double r3 = w[3][l];
        const double v47 = lane_cos(r3);
        const double v48 = r9 * v47;
        const double v49 = lane_sin(r3);
        const double v50 = r1 * v49;
        const double v51 = -v50;
        const double v52 = v48 + v51;
        const double v53 = r9 * v49;
        const double v54 = r1 * v47;
        const double v55 = v53 + v54;
        w[23][l] = v6;
        w[24][l] = v19;
        w[25][l] = v32;
        w[26][l] = v36;
        w[27][l] = v38;
        w[28][l] = v42;
        w[29][l] = v46;
        w[30][l] = v52;
        w[31][l] = v55;
    }
}

APART void nonlinear_rhs_1(lanes *restrict w)
{
    LANE_LOOP {
        const double r24 = w[24][l];
        const double v0 = lane_atan(r24);
        const double r20 = w[20][l];
        const double v1 = r20 * v0;
        w[32][l] = v1;
    }
}

APART void nonlinear_rhs_2(lanes *restrict w)
{
    LANE_LOOP {
        const double r32 = w[32][l];
        const double v0 = lane_sin(r32);
        const double r21 = w[21][l];
        const double v1 = r21 * v0;
        const double r14 = w[14][l];
        const double v2 = v1 * r14;
        const double r23 = w[23][l];
        const double v3 = v2 * r23;
        const double v4 = (-2.0) * v3;
        const double r26 = w[26][l];
        const double v5 = r26 + v4;
        const double r25 = w[25][l];
        const double v6 = v5 * r25;
        const double r27 = w[27][l];
        const double v7 = r27 + v6;
        const double r7 = w[7][l];
        const double v8 = v3 * r7;
        const double v9 = (-2.0) * v8;
        const double r29 = w[29][l];
        const double v10 = r29 + v9;
        const double r28 = w[28][l];
        const double v11 = v10 * r28;
        w[24][l] = v7;
        w[33][l] = v11;
    }
}

static void nonlinear_rhs_run(lanes *restrict w)
{
    nonlinear_rhs_0(w);
    nonlinear_rhs_1(w);
    nonlinear_rhs_2(w);
}

static const int16_t nonlinear_rhs_in[] = { 0, 1, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25 };
static const int16_t nonlinear_rhs_size[] = { 7 };
static const int16_t nonlinear_rhs_place[] = { 24, 33, 1, 2, 30, 31, 2 };
static const function_t nonlinear_rhs_f = { 22, 1, 34, nonlinear_rhs_in, nonlinear_rhs_size, nonlinear_rhs_place, nonlinear_rhs_run };
SHOWN void nonlinear_rhs(const points_t *job) { all(&nonlinear_rhs_f, job); }

APART void nonlinear_outputs_0(lanes *restrict w)
{
    LANE_LOOP {
        const double r5 = w[5][l];
        const double r2 = w[2][l];
        const double v0 = r5 * r2;
        const double r7 = w[7][l];
        const double v1 = 1.0 / r7;
        const double r1 = w[1][l];
        const double v2 = r1 + v0;
        const double v3 = v2 * v1;
        const double v4 = lane_atan(v3);
        const double r6 = w[6][l];
        const double v5 = r6 * r2;
        const double v6 = -v5;
        const double v7 = r1 + v6;
        const double v8 = v7 * v1;
        const double v9 = lane_atan(v8);
        const double v10 = r1 * v1;
        const double v11 = lane_atan(v10);
        const double r14 = w[14][l];
        const double r12 = w[12][l];
        const double v12 = r14 * r12;
        const double r13 = w[13][l];
        const double v13 = r13 + v12;
        const double v14 = v13 * v3;
        const double r16 = w[16][l];
        const double v15 = r16 * r12;
        const double r15 = w[15][l];
        const double v16 = r15 + v15;
        const double v17 = 1.0 / v16;
        const double v18 = v14 * v17;
        const double r20 = w[20][l];
        const double v19 = -r20;
        const double v20 = v19 + 1.0;
        const double v21 = v18 * v20;
        const double r17 = w[17][l];
        const double v22 = r17 * v18;
        const double v23 = lane_atan(v22);
        const double v24 = r20 * v23;
        const double v25 = 1.0 / r17;
        const double v26 = v24 * v25;
        const double v27 = v21 + v26;
        const double v28 = r17 * v27;
        const double r9 = w[9][l];
        const double r10 = w[10][l];
        const double v29 = r9 * r10;
        const double v30 = v29 * v9;
        const double r8 = w[8][l];
        const double v31 = v30 * r8;
        const double v32 = r7 * r7;
        const double v33 = v31 * v32;
        const double v34 = 0.5 * v33;
        const double r11 = w[11][l];
        const double v35 = r11 * v9;
        const double v36 = (-0.5) * v33;
        const double r3 = w[3][l];
        const double v37 = r3 + v36;
        const double v38 = -v35;
        const double v39 = v37 + v38;
        const double r4 = w[4][l];
        const double v40 = 1.0 / r4;
        const double v41 = v33 * r6;
        const double v42 = r3 * r6;
        const double v43 = v35 * r6;
        const double v44 = -v42;
        const double v45 = 0.5 * v41;
        const double v46 = v44 + v45;
        const double v47 = v46 + v43;
        const double v48 = r4 * r2;
        const double v49 = v48 * r1;
        const double v50 = -v49;
        const double r21 = w[21][l];
        const double v51 = r21 * r4;
        w[22][l] = v4;
        w[23][l] = v9;
        w[24][l] = v11;
        w[25][l] = v16;
        w[26][l] = v28;
        w[27][l] = v34;
        w[28][l] = v35;
        w[29][l] = v39;
        w[30][l] = v40;
        w[31][l] = v47;
        w[32][l] = v50;
        w[33][l] = v51;
    }
}

APART void nonlinear_outputs_1(lanes *restrict w)
{
    LANE_LOOP {
        const double r26 = w[26][l];
        const double v0 = lane_atan(r26);
        const double r18 = w[18][l];
        const double v1 = r18 * v0;
        w[34][l] = v1;
    }
}

APART void nonlinear_outputs_2(lanes *restrict w)
{
    LANE_LOOP {
        const double r34 = w[34][l];
        const double v0 = lane_sin(r34);
        const double r19 = w[19][l];
        const double v1 = r19 * v0;
        const double r12 = w[12][l];
        const double v2 = v1 * r12;
        const double r25 = w[25][l];
        const double v3 = v2 * r25;
        const double v4 = 2.0 * v3;
        const double v5 = (-2.0) * v3;
        const double r29 = w[29][l];
        const double v6 = r29 + v5;
        const double r30 = w[30][l];
        const double v7 = v6 * r30;
        const double r5 = w[5][l];
        const double v8 = v3 * r5;
        const double v9 = (-2.0) * v8;
        const double r31 = w[31][l];
        const double v10 = r31 + v9;
        w[26][l] = v4;
        w[35][l] = v6;
        w[36][l] = v7;
        w[37][l] = v10;
    }
}

static void nonlinear_outputs_run(lanes *restrict w)
{
    nonlinear_outputs_0(w);
    nonlinear_outputs_1(w);
    nonlinear_outputs_2(w);
}

static const int16_t nonlinear_outputs_in[] = { 0, 1, 7, 8, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26 };
static const int16_t nonlinear_outputs_size[] = { 11 };
static const int16_t nonlinear_outputs_place[] = { 22, 23, 24, 26, 27, 28, 36, 35, 37, 32, 33 };
static const function_t nonlinear_outputs_f = { 21, 1, 38, nonlinear_outputs_in, nonlinear_outputs_size, nonlinear_outputs_place, nonlinear_outputs_run };
SHOWN void nonlinear_outputs(const points_t *job) { all(&nonlinear_outputs_f, job); }

APART void nonlinear_linearized_0(lanes *restrict w)
{
    LANE_LOOP {
        const double r17 = w[17][l];
        const double r13 = w[13][l];
        const double v0 = r17 * r13;
        const double r16 = w[16][l];
        const double v1 = r16 + v0;
        const double r15 = w[15][l];
        const double v2 = r15 * r13;
        const double r14 = w[14][l];
        const double v3 = r14 + v2;
        const double r6 = w[6][l];
        const double r2 = w[2][l];
        const double v4 = r6 * r2;
        const double r1 = w[1][l];
        const double v5 = r1 + v4;
        const double v6 = v3 * v5;
        const double r8 = w[8][l];
        const double v7 = v1 * r8;
        const double v8 = 1.0 / v7;
        const double v9 = v6 * v8;
        const double r21 = w[21][l];
        const double v10 = -r21;
        const double v11 = v10 + 1.0;
        const double v12 = v9 * v11;
        const double r18 = w[18][l];
        const double v13 = r18 * v9;
        const double v14 = lane_atan(v13);
        const double v15 = r21 * v14;
        const double v16 = 1.0 / r18;
        const double v17 = v15 * v16;
        const double v18 = v12 + v17;
        const double v19 = r18 * v18;
        const double v20 = v3 * v8;
        const double v21 = v11 * v20;
        const double v22 = r18 * v20;
        const double v23 = v13 * v13;
        const double v24 = v23 + 1.0;
        const double v25 = 1.0 / v24;
        const double v26 = v22 * v25;
        const double v27 = r21 * v26;
        const double v28 = v27 * v16;
        const double v29 = v21 + v28;
        const double v30 = r18 * v29;
        const double v31 = v19 * v19;
        const double v32 = v31 + 1.0;
        const double v33 = 1.0 / v32;
        const double v34 = v30 * v33;
        const double r19 = w[19][l];
        const double v35 = r19 * v34;
        const double v36 = r8 * r8;
        const double r10 = w[10][l];
        const double r11 = w[11][l];
        const double v37 = r10 * r11;
        const double r7 = w[7][l];
        const double v38 = r7 * r2;
        const double v39 = 1.0 / r8;
        const double v40 = -v38;
        const double v41 = r1 + v40;
        const double v42 = v41 * v39;
        const double v43 = v42 * v42;
        const double v44 = v43 + 1.0;
        const double v45 = 1.0 / v44;
        const double v46 = v45 * v39;
        const double v47 = v37 * v46;
        const double r9 = w[9][l];
        const double v48 = r9 * v47;
        const double v49 = v36 * v48;
        const double r12 = w[12][l];
        const double v50 = r12 * v46;
        const double r4 = w[4][l];
        const double v51 = 1.0 / r4;
        const double v52 = 0.5 * v49;
        const double v53 = v52 + v50;
        const double v54 = r7 * v49;
        const double v55 = r7 * v50;
        const double r5 = w[5][l];
        const double v56 = 1.0 / r5;
        const double v57 = 0.5 * v54;
        const double v58 = v57 + v55;
        const double v59 = r7 * v39;
        const double v60 = v59 * v45;
        const double v61 = v37 * v60;
        const double v62 = r9 * v61;
        const double v63 = v36 * v62;
        const double v64 = v3 * r6;
        const double v65 = v64 * v8;
        const double v66 = v11 * v65;
        const double v67 = r18 * v65;
        const double v68 = v67 * v25;
        const double v69 = r21 * v68;
        const double v70 = v69 * v16;
        const double v71 = v66 + v70;
        const double v72 = r18 * v71;
        const double v73 = v72 * v33;
        const double v74 = r19 * v73;
        const double v75 = r12 * v60;
        const double v76 = 0.5 * v63;
        const double v77 = v76 + v75;
        const double v78 = -r8;
        const double v79 = r7 * v63;
        const double v80 = r7 * v75;
        const double v81 = 0.5 * v79;
        const double v82 = v81 + v80;
        const double v83 = r7 * v56;
        const double v84 = -v83;
        const double v85 = v5 * v39;
        const double v86 = v85 * v85;
        const double v87 = v86 + 1.0;
        const double v88 = 1.0 / v87;
        const double v89 = v88 * v39;
        const double v90 = r1 * v39;
        const double v91 = v90 * v90;
        const double v92 = v91 + 1.0;
        const double v93 = 1.0 / v92;
        const double v94 = v93 * v39;
        const double v95 = v3 * v85;
        const double v96 = 1.0 / v1;
        const double v97 = v95 * v96;
        const double v98 = v97 * v11;
        const double v99 = r18 * v97;
        const double v100 = lane_atan(v99);
        const double v101 = r21 * v100;
        const double v102 = v101 * v16;
        const double v103 = v98 + v102;
        const double v104 = r18 * v103;
        const double v105 = v3 * v39;
        const double v106 = v105 * v96;
        const double v107 = v11 * v106;
        const double v108 = r18 * v106;
        const double v109 = v99 * v99;
        const double v110 = v109 + 1.0;
        const double v111 = 1.0 / v110;
        const double v112 = v108 * v111;
        const double v113 = r21 * v112;
        const double v114 = v113 * v16;
        const double v115 = v107 + v114;
        const double v116 = r18 * v115;
        const double v117 = v104 * v104;
        const double v118 = v117 + 1.0;
        const double v119 = 1.0 / v118;
        const double v120 = v116 * v119;
        const double v121 = r19 * v120;
        const double v122 = r4 * r2;
        const double v123 = -v122;
        const double v124 = r6 * v39;
        const double v125 = v124 * v88;
        const double v126 = -v60;
        const double v127 = v3 * v124;
        const double v128 = v127 * v96;
        const double v129 = v11 * v128;
        const double v130 = r18 * v128;
        const double v131 = v130 * v111;
        const double v132 = r21 * v131;
        const double v133 = v132 * v16;
        const double v134 = v129 + v133;
        const double v135 = r18 * v134;
        const double v136 = v135 * v119;
        const double v137 = r19 * v136;
        const double v138 = (-0.5) * v63;
        const double v139 = -v75;
        const double v140 = (-0.5) * v79;
        const double v141 = -v80;
        const double v142 = v140 + v141;
        const double v143 = r1 * r4;
        const double v144 = -v143;
        const double v145 = -r7;
        const double v146 = lane_atan(v42);
        const double v147 = v37 * v146;
        const double v148 = v147 * r9;
        const double v149 = v148 * v36;
        const double v150 = r12 * v146;
        const double v151 = (-0.5) * v149;
        const double r3 = w[3][l];
        const double v152 = r3 + v151;
        const double v153 = -v150;
        const double v154 = v152 + v153;
        const double v155 = r2 * r8;
        const double v156 = -v155;
        const double v157 = v149 * r7;
        const double v158 = r3 * r7;
        const double v159 = v150 * r7;
        const double v160 = -v158;
        const double v161 = 0.5 * v157;
        const double v162 = v160 + v161;
        const double v163 = v162 + v159;
        const double v164 = lane_atan(v85);
        const double v165 = lane_atan(v90);
        const double v166 = 0.5 * v149;
        const double v167 = v122 * r1;
        const double v168 = -v167;
        const double r22 = w[22][l];
        const double v169 = r22 * r4;
        w[23][l] = v1;
        w[24][l] = v19;
        w[25][l] = v35;
        w[26][l] = v46;
        w[27][l] = v50;
        w[28][l] = v51;
        w[29][l] = v52;
        w[30][l] = v53;
        w[31][l] = v56;
        w[32][l] = v58;
        w[33][l] = v74;
        w[34][l] = v77;
        w[35][l] = v78;
        w[36][l] = v82;
        w[37][l] = v84;
        w[38][l] = v89;
        w[39][l] = v94;
        w[40][l] = v104;
        w[41][l] = v121;
        w[42][l] = v123;
        w[43][l] = v125;
        w[44][l] = v126;
        w[45][l] = v137;
        w[46][l] = v138;
        w[47][l] = v139;
        w[48][l] = v142;
        w[49][l] = v144;
        w[50][l] = v145;
        w[51][l] = v146;
        w[52][l] = v150;
        w[53][l] = v154;
        w[54][l] = v156;
        w[55][l] = v163;
        w[56][l] = v164;
        w[57][l] = v165;
        w[58][l] = v166;
        w[59][l] = v168;
        w[60][l] = v169;
    }
}

APART void nonlinear_linearized_1(lanes *restrict w)
{
    LANE_LOOP {
        const double r24 = w[24][l];
        const double v0 = lane_atan(r24);
        const double r19 = w[19][l];
        const double v1 = r19 * v0;
        const double r40 = w[40][l];
        const double v2 = lane_atan(r40);
        const double v3 = r19 * v2;
        w[61][l] = v1;
        w[62][l] = v3;
    }
}

APART void nonlinear_linearized_2(lanes *restrict w)
{
    LANE_LOOP {
        const double r61 = w[61][l];
        const double v0 = lane_cos(r61);
        const double r25 = w[25][l];
        const double v1 = v0 * r25;
        const double r20 = w[20][l];
        const double v2 = r20 * v1;
        const double r13 = w[13][l];
        const double v3 = r13 * v2;
        const double r23 = w[23][l];
        const double v4 = r23 * v3;
        const double v5 = 2.0 * v4;
        const double r30 = w[30][l];
        const double v6 = r30 + v5;
        const double r28 = w[28][l];
        const double v7 = v6 * r28;
        const double v8 = -v7;
        const double r6 = w[6][l];
        const double v9 = r6 * v4;
        const double v10 = (-2.0) * v9;
        const double r32 = w[32][l];
        const double v11 = r32 + v10;
        const double r31 = w[31][l];
        const double v12 = v11 * r31;
        const double r33 = w[33][l];
        const double v13 = v0 * r33;
        const double v14 = r20 * v13;
        const double v15 = r13 * v14;
        const double v16 = r23 * v15;
        const double v17 = (-2.0) * v16;
        const double r34 = w[34][l];
        const double v18 = r34 + v17;
        const double v19 = v18 * r28;
        const double r35 = w[35][l];
        const double v20 = r35 + v19;
        const double v21 = r6 * v16;
        const double v22 = 2.0 * v21;
        const double r36 = w[36][l];
        const double v23 = r36 + v22;
        const double v24 = v23 * r31;
        const double v25 = -v24;
        const double r62 = w[62][l];
        const double v26 = lane_cos(r62);
        const double r41 = w[41][l];
        const double v27 = v26 * r41;
        const double v28 = r20 * v27;
        const double v29 = r13 * v28;
        const double v30 = r23 * v29;
        const double v31 = 2.0 * v30;
        const double v32 = r30 + v31;
        const double v33 = v32 * r28;
        const double v34 = -v33;
        const double v35 = -v32;
        const double v36 = r6 * v30;
        const double v37 = (-2.0) * v36;
        const double v38 = r32 + v37;
        const double r45 = w[45][l];
        const double v39 = v26 * r45;
        const double v40 = r20 * v39;
        const double v41 = r13 * v40;
        const double v42 = r23 * v41;
        const double v43 = 2.0 * v42;
        const double v44 = (-2.0) * v42;
        const double v45 = r34 + v44;
        const double v46 = v45 * r28;
        const double v47 = r6 * v42;
        const double v48 = (-2.0) * v47;
        const double r48 = w[48][l];
        const double v49 = r48 + v48;
        const double v50 = lane_sin(r61);
        const double v51 = r20 * v50;
        const double v52 = v51 * r13;
        const double v53 = v52 * r23;
        const double v54 = (-2.0) * v53;
        const double r53 = w[53][l];
        const double v55 = r53 + v54;
        const double v56 = v55 * r28;
        const double r54 = w[54][l];
        const double v57 = r54 + v56;
        const double v58 = v53 * r6;
        const double v59 = (-2.0) * v58;
        const double r55 = w[55][l];
        const double v60 = r55 + v59;
        const double v61 = v60 * r31;
        const double v62 = lane_sin(r62);
        const double v63 = r20 * v62;
        const double v64 = v63 * r13;
        const double v65 = v64 * r23;
        const double v66 = 2.0 * v65;
        const double v67 = (-2.0) * v65;
        const double v68 = r53 + v67;
        const double v69 = v68 * r28;
        const double v70 = v65 * r6;
        const double v71 = (-2.0) * v70;
        const double v72 = r55 + v71;
        w[40][l] = v8;
        w[24][l] = v12;
        w[63][l] = v20;
        w[64][l] = v25;
        w[65][l] = v31;
        w[66][l] = v34;
        w[67][l] = v35;
        w[68][l] = v38;
        w[69][l] = v43;
        w[70][l] = v45;
        w[71][l] = v46;
        w[72][l] = v49;
        w[73][l] = v57;
        w[74][l] = v61;
        w[75][l] = v66;
        w[76][l] = v68;
        w[77][l] = v69;
        w[78][l] = v72;
    }
}

static void nonlinear_linearized_run(lanes *restrict w)
{
    nonlinear_linearized_0(w);
    nonlinear_linearized_1(w);
    nonlinear_linearized_2(w);
    LANE_LOOP w[79][l] = 1.0;
}

static const int16_t nonlinear_linearized_in[] = { 0, 1, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26 };
static const int16_t nonlinear_linearized_size[] = { 4, 2, 22, 11, 2, 11 };
static const int16_t nonlinear_linearized_place[] = { 40, 63, 24, 64, 28, 37, 38, 43, 26, 44, 39, 0, 65, 69, 29, 46, 27, 47, 66, 71, 67, 70, 68, 72, 42, 49, 0, 0, 0, 0, 0, 0, 0, 0, 28, 79, 50, 0, 0, 73, 74, 56, 51, 57, 75, 58, 52, 77, 76, 78, 59, 60 };
static const function_t nonlinear_linearized_f = { 22, 6, 80, nonlinear_linearized_in, nonlinear_linearized_size, nonlinear_linearized_place, nonlinear_linearized_run };
SHOWN void nonlinear_linearized(const points_t *job) { all(&nonlinear_linearized_f, job); }

