/* Generated from derive/ (digest bfd9ab80ef38709d) with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`. */
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

APART void linear_rhs_0(lanes *restrict w)
{
    LANE_LOOP {
        const double r7 = w[7][l];
        const double r2 = w[2][l];
        const double v0 = r7 * r2;
        const double r9 = w[9][l];
        const double v1 = 1.0 / r9;
        const double r1 = w[1][l];
        const double v2 = r1 + v0;
        const double v3 = v2 * v1;
        const double r13 = w[13][l];
        const double v4 = r13 * v3;
        const double r11 = w[11][l];
        const double r12 = w[12][l];
        const double v5 = r11 * r12;
        const double r8 = w[8][l];
        const double v6 = r8 * r2;
        const double v7 = -v6;
        const double v8 = r1 + v7;
        const double v9 = v8 * v1;
        const double v10 = v5 * v9;
        const double r10 = w[10][l];
        const double v11 = v10 * r10;
        const double v12 = r9 * r9;
        const double v13 = v11 * v12;
        const double r14 = w[14][l];
        const double v14 = r14 * v9;
        const double r5 = w[5][l];
        const double v15 = 1.0 / r5;
        const double v16 = (-2.0) * v4;
        const double r4 = w[4][l];
        const double v17 = r4 + v16;
        const double v18 = (-0.5) * v13;
        const double v19 = v17 + v18;
        const double v20 = -v14;
        const double v21 = v19 + v20;
        const double v22 = v21 * v15;
        const double v23 = r2 * r9;
        const double v24 = -v23;
        const double v25 = v22 + v24;
        const double v26 = v13 * r8;
        const double v27 = r4 * r8;
        const double v28 = v4 * r7;
        const double v29 = v14 * r8;
        const double r6 = w[6][l];
        const double v30 = 1.0 / r6;
        const double v31 = 0.5 * v26;
        const double v32 = -v27;
        const double v33 = v31 + v32;
        const double v34 = (-2.0) * v28;
        const double v35 = v33 + v34;
        const double v36 = v35 + v29;
        const double v37 = v36 * v30;
        const double r3 = w[3][l];
        const double v38 = lane_cos(r3);
        const double v39 = r9 * v38;
        const double v40 = lane_sin(r3);
        const double v41 = r1 * v40;
        const double v42 = -v41;
        const double v43 = v39 + v42;
        const double v44 = r9 * v40;
        const double v45 = r1 * v38;
        const double v46 = v44 + v45;
        w[15][l] = v25;
        w[16][l] = v37;
        w[17][l] = v43;
        w[18][l] = v46;
    }
}

static void linear_rhs_run(lanes *restrict w)
{
    linear_rhs_0(w);
}

static const int16_t linear_rhs_in[] = { 0, 1, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17 };
static const int16_t linear_rhs_size[] = { 7 };
static const int16_t linear_rhs_place[] = { 15, 16, 1, 2, 17, 18, 2 };
static const function_t linear_rhs_f = { 14, 1, 19, linear_rhs_in, linear_rhs_size, linear_rhs_place, linear_rhs_run };
SHOWN void linear_rhs(const points_t *job) { all(&linear_rhs_f, job); }

APART void linear_outputs_0(lanes *restrict w)
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
        const double r6 = w[6][l];
        const double v4 = r6 * r2;
        const double v5 = -v4;
        const double v6 = r1 + v5;
        const double v7 = v6 * v1;
        const double v8 = r1 * v1;
        const double r11 = w[11][l];
        const double v9 = r11 * v3;
        const double v10 = 2.0 * v9;
        const double r9 = w[9][l];
        const double r10 = w[10][l];
        const double v11 = r9 * r10;
        const double v12 = v11 * v7;
        const double r8 = w[8][l];
        const double v13 = v12 * r8;
        const double v14 = r7 * r7;
        const double v15 = v13 * v14;
        const double v16 = 0.5 * v15;
        const double r12 = w[12][l];
        const double v17 = r12 * v7;
        const double v18 = (-2.0) * v9;
        const double r3 = w[3][l];
        const double v19 = r3 + v18;
        const double v20 = (-0.5) * v15;
        const double v21 = v19 + v20;
        const double v22 = -v17;
        const double v23 = v21 + v22;
        const double r4 = w[4][l];
        const double v24 = 1.0 / r4;
        const double v25 = v23 * v24;
        const double v26 = v15 * r6;
        const double v27 = r3 * r6;
        const double v28 = v9 * r5;
        const double v29 = v17 * r6;
        const double v30 = 0.5 * v26;
        const double v31 = -v27;
        const double v32 = v30 + v31;
        const double v33 = (-2.0) * v28;
        const double v34 = v32 + v33;
        const double v35 = v34 + v29;
        const double r13 = w[13][l];
        const double v36 = r13 * r4;
        w[14][l] = v3;
        w[15][l] = v7;
        w[16][l] = v8;
        w[17][l] = v10;
        w[18][l] = v16;
        w[19][l] = v17;
        w[20][l] = v23;
        w[21][l] = v25;
        w[22][l] = v35;
        w[23][l] = v36;
    }
}

static void linear_outputs_run(lanes *restrict w)
{
    linear_outputs_0(w);
}

static const int16_t linear_outputs_in[] = { 0, 1, 7, 8, 10, 11, 12, 13, 14, 15, 16, 17, 18 };
static const int16_t linear_outputs_size[] = { 10 };
static const int16_t linear_outputs_place[] = { 14, 15, 16, 17, 18, 19, 21, 20, 22, 23 };
static const function_t linear_outputs_f = { 13, 1, 24, linear_outputs_in, linear_outputs_size, linear_outputs_place, linear_outputs_run };
SHOWN void linear_outputs(const points_t *job) { all(&linear_outputs_f, job); }

APART void linear_linearized_0(lanes *restrict w)
{
    LANE_LOOP {
        const double r8 = w[8][l];
        const double v0 = 1.0 / r8;
        const double r12 = w[12][l];
        const double v1 = r12 * v0;
        const double v2 = r8 * r8;
        const double r10 = w[10][l];
        const double r11 = w[11][l];
        const double v3 = r10 * r11;
        const double v4 = v3 * v0;
        const double r9 = w[9][l];
        const double v5 = r9 * v4;
        const double v6 = v2 * v5;
        const double r13 = w[13][l];
        const double v7 = r13 * v0;
        const double v8 = 2.0 * v1;
        const double v9 = 0.5 * v6;
        const double v10 = v8 + v9;
        const double v11 = v10 + v7;
        const double r4 = w[4][l];
        const double v12 = 1.0 / r4;
        const double v13 = v11 * v12;
        const double v14 = -v13;
        const double r7 = w[7][l];
        const double v15 = r7 * v6;
        const double r6 = w[6][l];
        const double v16 = r6 * v1;
        const double v17 = r7 * v7;
        const double v18 = 0.5 * v15;
        const double v19 = (-2.0) * v16;
        const double v20 = v18 + v19;
        const double v21 = v20 + v17;
        const double r5 = w[5][l];
        const double v22 = 1.0 / r5;
        const double v23 = v21 * v22;
        const double v24 = r7 * v0;
        const double v25 = v3 * v24;
        const double v26 = r9 * v25;
        const double v27 = v2 * v26;
        const double v28 = r6 * v0;
        const double v29 = r12 * v28;
        const double v30 = r13 * v24;
        const double v31 = 0.5 * v27;
        const double v32 = (-2.0) * v29;
        const double v33 = v31 + v32;
        const double v34 = v33 + v30;
        const double v35 = v34 * v12;
        const double v36 = -r8;
        const double v37 = v36 + v35;
        const double v38 = r7 * v27;
        const double v39 = r6 * v29;
        const double v40 = r7 * v30;
        const double v41 = 0.5 * v38;
        const double v42 = 2.0 * v39;
        const double v43 = v41 + v42;
        const double v44 = v43 + v40;
        const double v45 = v44 * v22;
        const double v46 = -v45;
        const double v47 = r7 * v22;
        const double v48 = -v47;
        const double v49 = -v11;
        const double v50 = -v24;
        const double v51 = 2.0 * v29;
        const double v52 = (-0.5) * v27;
        const double v53 = -v30;
        const double v54 = -v44;
        const double v55 = -r7;
        const double r2 = w[2][l];
        const double v56 = r6 * r2;
        const double r1 = w[1][l];
        const double v57 = r1 + v56;
        const double v58 = v57 * v0;
        const double v59 = r12 * v58;
        const double v60 = r7 * r2;
        const double v61 = -v60;
        const double v62 = r1 + v61;
        const double v63 = v62 * v0;
        const double v64 = v3 * v63;
        const double v65 = v64 * r9;
        const double v66 = v65 * v2;
        const double v67 = r13 * v63;
        const double v68 = (-2.0) * v59;
        const double r3 = w[3][l];
        const double v69 = r3 + v68;
        const double v70 = (-0.5) * v66;
        const double v71 = v69 + v70;
        const double v72 = -v67;
        const double v73 = v71 + v72;
        const double v74 = v73 * v12;
        const double v75 = r2 * r8;
        const double v76 = -v75;
        const double v77 = v74 + v76;
        const double v78 = v66 * r7;
        const double v79 = r3 * r7;
        const double v80 = v59 * r6;
        const double v81 = v67 * r7;
        const double v82 = 0.5 * v78;
        const double v83 = -v79;
        const double v84 = v82 + v83;
        const double v85 = (-2.0) * v80;
        const double v86 = v84 + v85;
        const double v87 = v86 + v81;
        const double v88 = v87 * v22;
        const double v89 = r1 * v0;
        const double v90 = 2.0 * v59;
        const double v91 = 0.5 * v66;
        const double r14 = w[14][l];
        const double v92 = r14 * r4;
        w[15][l] = v0;
        w[16][l] = v7;
        w[17][l] = v8;
        w[18][l] = v9;
        w[19][l] = v12;
        w[20][l] = v14;
        w[21][l] = v21;
        w[22][l] = v23;
        w[23][l] = v28;
        w[24][l] = v34;
        w[25][l] = v35;
        w[26][l] = v37;
        w[27][l] = v46;
        w[28][l] = v48;
        w[29][l] = v49;
        w[30][l] = v50;
        w[31][l] = v51;
        w[32][l] = v52;
        w[33][l] = v53;
        w[34][l] = v54;
        w[35][l] = v55;
        w[36][l] = v58;
        w[37][l] = v63;
        w[38][l] = v67;
        w[39][l] = v73;
        w[40][l] = v74;
        w[41][l] = v77;
        w[42][l] = v87;
        w[43][l] = v88;
        w[44][l] = v89;
        w[45][l] = v90;
        w[46][l] = v91;
        w[47][l] = v92;
    }
}

static void linear_linearized_run(lanes *restrict w)
{
    linear_linearized_0(w);
    LANE_LOOP w[48][l] = 1.0;
}

static const int16_t linear_linearized_in[] = { 0, 1, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18 };
static const int16_t linear_linearized_size[] = { 4, 2, 20, 10, 2, 10 };
static const int16_t linear_linearized_place[] = { 20, 26, 22, 27, 19, 28, 15, 23, 15, 30, 15, 0, 17, 31, 18, 32, 16, 33, 20, 25, 29, 24, 21, 34, 0, 0, 0, 0, 0, 0, 0, 0, 19, 48, 35, 0, 41, 43, 36, 37, 44, 45, 46, 38, 40, 39, 42, 47 };
static const function_t linear_linearized_f = { 14, 6, 49, linear_linearized_in, linear_linearized_size, linear_linearized_place, linear_linearized_run };
SHOWN void linear_linearized(const points_t *job) { all(&linear_linearized_f, job); }

